#include "viewer/color_editor.hpp"

#include <QColorDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QPainter>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "image/tone.hpp"
#include "viewer/screen_fit.hpp"

namespace aerostat::viewer {
namespace {

QColor color_of(const QJsonArray& linear) {
  const auto encoded = [&linear](int i) {
    return static_cast<float>(image::srgb_from_linear(linear[i].toDouble()));
  };
  return QColor::fromRgbF(encoded(0), encoded(1), encoded(2));
}

QString json_of(const QColor& color) {
  const auto linear = [](float encoded) {
    // Four decimals are finer than a step of eight bits at every value.
    return QString::number(std::round(image::linear_from_srgb(static_cast<double>(encoded)) * 1e4) /
                           1e4);
  };
  return "[" + linear(color.redF()) + ", " + linear(color.greenF()) + ", " + linear(color.blueF()) +
         "]";
}

constexpr QSize kSmall(16, 16), kWide(56, 16);

QIcon swatch(const QColor& color, const QSize& size, const QWidget& on) {
  QPixmap pixmap(size * on.devicePixelRatioF());
  pixmap.setDevicePixelRatio(on.devicePixelRatioF());
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(on.palette().color(QPalette::Mid));
  painter.setBrush(color);
  painter.drawRoundedRect(QRectF(0.5, 0.5, size.width() - 1, size.height() - 1), 3, 3);
  return QIcon(pixmap);
}

/// Asks for a colour with Qt's dialog, in a frame that scrolls if the screen is smaller than the
/// dialog. Returns an invalid colour if the dialog was cancelled.
QColor ask_for_color(const QColor& before, const QString& title, QWidget* parent) {
  QDialog dialog(parent);
  dialog.setWindowTitle(title);
  auto* colors = new QColorDialog(before);
  colors->setWindowFlags(Qt::Widget);
  colors->setOptions(QColorDialog::DontUseNativeDialog | QColorDialog::NoButtons);
  auto* scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(colors);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* layout = new QVBoxLayout(&dialog);
  layout->addWidget(scroll);
  layout->addWidget(buttons);
  const QMargins rim = layout->contentsMargins();
  resize_to_fit(dialog, colors->sizeHint() + QSize(rim.left() + rim.right(),
                                                   rim.top() + rim.bottom() + layout->spacing() +
                                                       buttons->sizeHint().height()));
  return dialog.exec() == QDialog::Accepted ? colors->currentColor() : QColor();
}

}  // namespace

ColorEditor::ColorEditor(int least, int most, const QString& title, QWidget* parent)
    : QWidget(parent),
      least_(least),
      most_(most),
      title_(title),
      layout_(new QHBoxLayout(this)),
      more_(new QToolButton),
      fewer_(new QToolButton) {
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(2);
  more_->setText(QStringLiteral("+"));
  more_->setToolTip(tr("One more colour"));
  fewer_->setText(QStringLiteral("−"));
  fewer_->setToolTip(tr("Remove the last colour"));
  layout_->addWidget(more_);
  layout_->addWidget(fewer_);
  layout_->addStretch(1);
  more_->setVisible(most > least);
  fewer_->setVisible(most > least);
  connect(more_, &QToolButton::clicked, this, [this] {
    colors_.push_back(colors_.empty() ? QColor(Qt::white) : colors_.back());
    tell();
  });
  connect(fewer_, &QToolButton::clicked, this, [this] {
    colors_.pop_back();
    tell();
  });
}

void ColorEditor::show_colors(const QString& json) {
  colors_.clear();
  const QJsonDocument document = QJsonDocument::fromJson(json.toUtf8());
  for (const auto& one : document.array()) colors_.push_back(color_of(one.toArray()));
  arrange();
}

void ColorEditor::arrange() {
  while (buttons_.size() > colors_.size()) {
    // The button is deleted later, because it may be the one that was clicked.
    buttons_.back()->hide();
    buttons_.back()->deleteLater();
    buttons_.pop_back();
  }
  while (buttons_.size() < colors_.size()) {
    const int index = static_cast<int>(buttons_.size());
    auto* button = new QToolButton;
    button->setAutoRaise(true);
    connect(button, &QToolButton::clicked, this, [this, index] { choose(index); });
    layout_->insertWidget(index, button);
    buttons_.push_back(button);
  }
  for (std::size_t i = 0; i < colors_.size(); ++i) {
    // A single white button must not look like an empty check box, so it is wider than one of
    // several.
    const QSize size = most_ > 1 ? kSmall : kWide;
    buttons_[i]->setIconSize(size);
    buttons_[i]->setIcon(swatch(colors_[i], size, *this));
    buttons_[i]->setToolTip(tr("Colour %1: %2").arg(i + 1).arg(colors_[i].name()));
    buttons_[i]->setAccessibleName(buttons_[i]->toolTip());
  }
  more_->setEnabled(static_cast<int>(colors_.size()) < most_);
  fewer_->setEnabled(static_cast<int>(colors_.size()) > least_);
}

void ColorEditor::choose(int index) {
  QColor& color = colors_[static_cast<std::size_t>(index)];
  const QColor chosen = ask_for_color(color, title_, this);
  if (!chosen.isValid()) return;
  colors_[static_cast<std::size_t>(index)] = chosen;
  tell();
}

void ColorEditor::tell() {
  QStringList parts;
  for (const QColor& color : colors_) parts.push_back(json_of(color));
  Q_EMIT edited("[" + parts.join(", ") + "]");
}

}  // namespace aerostat::viewer
