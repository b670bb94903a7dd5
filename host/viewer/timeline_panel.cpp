#include "viewer/timeline_panel.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <exception>

#include "film/keys.hpp"
#include "film/timeline.hpp"
#include "scene/scene.hpp"
#include "viewer/timeline_keys.hpp"
#include "viewer/timeline_slider.hpp"

namespace aerostat::viewer {

TimelinePanel::TimelinePanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      slider_(new TimelineSlider),
      play_(tool(tr("Play"), QStyle::SP_MediaPlay)),
      still_(tool(tr("Show the still picture"), QStyle::SP_MediaStop)),
      position_(new QLabel),
      values_(new QComboBox),
      value_(new QLineEdit),
      set_(new QPushButton(tr("Set Key"))),
      remove_(new QPushButton(tr("Remove Key"))),
      export_(new QPushButton(tr("Export Film…"))) {
  build();
  connect_buttons();
  connect(&document_, &Document::changed, this, &TimelinePanel::refresh);
  connect(&document_, &Document::file_changed, this, [this] {
    // A scene that was opened has no history yet, and one that was saved keeps its own.
    if (document_.undo_stack().count() == 0) show_still();
  });
  refresh();
}

QToolButton* TimelinePanel::tool(const QString& text, QStyle::StandardPixmap icon) {
  auto* button = new QToolButton;
  button->setIcon(style()->standardIcon(icon));
  button->setToolTip(text);
  button->setAccessibleName(text);
  return button;
}

void TimelinePanel::build() {
  slider_->setAccessibleName(tr("Frame"));
  slider_->setMinimumWidth(80);
  position_->setMinimumWidth(1);
  values_->setEditable(true);
  values_->setInsertPolicy(QComboBox::NoInsert);
  values_->setAccessibleName(tr("Value with keys"));
  values_->setToolTip(tr("The value whose keys are edited, by its JSON pointer"));
  values_->setMinimumContentsLength(8);
  values_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  value_->setAccessibleName(tr("Value at this frame"));
  value_->setToolTip(tr("The value at this frame; Enter makes it a key"));
  value_->setMinimumWidth(60);
  for (QPushButton* button : {set_, remove_, export_}) button->setAutoDefault(false);
  auto* time = new QHBoxLayout;
  time->addWidget(play_);
  time->addWidget(still_);
  time->addWidget(slider_, 1);
  auto* keys = new QHBoxLayout;
  keys->addWidget(values_, 2);
  keys->addWidget(value_, 1);
  keys->addWidget(set_);
  keys->addWidget(remove_);
  keys->addWidget(position_, 1);
  keys->addWidget(export_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addLayout(time);
  layout->addLayout(keys);
}

void TimelinePanel::connect_buttons() {
  connect(play_, &QToolButton::clicked, this, [this] { is_playing_ ? pause() : play(); });
  connect(still_, &QToolButton::clicked, this, &TimelinePanel::show_still);
  connect(slider_, &QSlider::valueChanged, this, [this](int frame) {
    pause();
    go_to(frame);
  });
  connect(values_, &QComboBox::currentTextChanged, this, [this] {
    show_marks();
    show_value();
  });
  connect(value_, &QLineEdit::returnPressed, this, [this] { set_key(value_->text()); });
  connect(set_, &QPushButton::clicked, this, [this] { set_key(value_->text()); });
  connect(remove_, &QPushButton::clicked, this, &TimelinePanel::remove_key);
  connect(export_, &QPushButton::clicked, this, &TimelinePanel::export_asked);
}

double TimelinePanel::time_of(int frame) const {
  return (frame - 1) / document_.scene().film.fps;
}

std::optional<double> TimelinePanel::shown_time() const {
  return is_shown_ ? std::optional(time_of(frame())) : std::nullopt;
}

int TimelinePanel::frame() const {
  return slider_->value();
}

int TimelinePanel::frames() const {
  return slider_->maximum();
}

QString TimelinePanel::pointer() const {
  return values_->currentText().trimmed();
}

QString TimelinePanel::value_text() const {
  return value_->text();
}

QString TimelinePanel::position_text() const {
  return position_->text();
}

void TimelinePanel::go_to(int frame) {
  {
    const QSignalBlocker blocker(slider_);
    slider_->setValue(frame);
  }
  is_shown_ = true;
  show_position();
  show_value();
  Q_EMIT time_changed();
}

void TimelinePanel::play() {
  is_playing_ = true;
  first_ = frame() == frames() ? 1 : frame();
  shown_frames_ = 0;
  clock_.start();
  play_->setIcon(style()->standardIcon(QStyle::SP_MediaPause));
  go_to(first_);
}

void TimelinePanel::pause() {
  if (!is_playing_) return;
  is_playing_ = false;
  play_->setIcon(style()->standardIcon(QStyle::SP_MediaPlay));
  show_position();
}

void TimelinePanel::show_still() {
  pause();
  if (!is_shown_) return;
  is_shown_ = false;
  show_position();
  Q_EMIT time_changed();
}

void TimelinePanel::frame_arrived() {
  if (!is_playing_) return;
  ++shown_frames_;
  const double seconds = static_cast<double>(clock_.elapsed()) / 1000.0;
  const int now = first_ + static_cast<int>(seconds * document_.scene().film.fps);
  if (frame() >= frames()) {
    pause();
    // The last frame is shown again, in all its quality.
    go_to(frames());
    return;
  }
  go_to(std::clamp(now, frame() + 1, frames()));
}

void TimelinePanel::choose_value(const QString& pointer) {
  values_->setCurrentText(pointer);
}

/// Returns the chosen value as the film has it at the frame of the slider.
QString TimelinePanel::value_at_frame() const {
  const scene::Film& film = document_.scene().film;
  try {
    const auto source = document_.source().with(film::changes_at(film.keys, time_of(frame())));
    return QString::fromStdString(source.value(pointer().toStdString()));
  } catch (const std::exception&) {
    return {};
  }
}

void TimelinePanel::set_key(const QString& json) {
  if (pointer().isEmpty() || json.trimmed().isEmpty()) return;
  document_.end_gesture();
  document_.set(tr("Key of %1").arg(pointer()), "/film/keys",
                with_key(document_.value("/film/keys"), pointer(), time_of(frame()), json));
}

void TimelinePanel::remove_key() {
  document_.end_gesture();
  document_.set(tr("Key of %1").arg(pointer()), "/film/keys",
                without_key(document_.value("/film/keys"), pointer(), time_of(frame())));
}

void TimelinePanel::refresh() {
  {
    const QSignalBlocker blocker(slider_);
    slider_->setRange(1, film::frame_count(document_.scene().film));
  }
  refresh_values();
  show_marks();
  show_position();
  show_value();
}

void TimelinePanel::refresh_values() {
  const QStringList values = values_for_keys(document_.scene().film.keys);
  QStringList present;
  for (int i = 0; i < values_->count(); ++i) present << values_->itemText(i);
  if (values == present) return;
  const QString chosen = present.isEmpty() ? values.value(0) : pointer();
  const QSignalBlocker blocker(values_);
  values_->clear();
  values_->addItems(values);
  values_->setCurrentText(chosen);
}

void TimelinePanel::show_marks() {
  std::vector<TimelineSlider::Mark> marks;
  const scene::Film& film = document_.scene().film;
  for (const scene::KeyTrack& track : film.keys) {
    const bool is_chosen = QString::fromStdString(track.value) == pointer();
    for (const scene::Key& key : track.keys)
      marks.push_back({1.0 + key.time_s * film.fps, is_chosen});
  }
  slider_->show_marks(std::move(marks));
}

void TimelinePanel::show_position() {
  QString text =
      tr("frame %1 of %2, %3 s").arg(frame()).arg(frames()).arg(time_of(frame()), 0, 'f', 2);
  const double seconds = static_cast<double>(clock_.isValid() ? clock_.elapsed() : 0) / 1000.0;
  if (is_playing_ && shown_frames_ > 1) {
    text += tr(", %1 frames/s").arg(shown_frames_ / seconds, 0, 'f', 1);
  }
  if (!is_shown_) text = tr("still picture");
  position_->setText(text);
  position_->setToolTip(text);
  still_->setEnabled(is_shown_);
}

void TimelinePanel::show_value() {
  // While it plays, the text would only flicker.
  if (is_playing_) return;
  if (!value_->hasFocus() || !value_->isModified()) value_->setText(value_at_frame());
  const bool has = has_key(document_.scene().film.keys, pointer(), time_of(frame()));
  remove_->setEnabled(has);
}

}  // namespace aerostat::viewer
