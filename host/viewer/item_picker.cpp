#include "viewer/item_picker.hpp"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QToolButton>

#include "scene/field_rule.hpp"
#include "scene/scene.hpp"
#include "viewer/controls.hpp"

namespace aerostat::viewer {
namespace {

/// The distances in metres between new balloons, and from a balloon up to a new lamp. Chosen by
/// eye.
constexpr double kApart_m = 60.0;
constexpr double kLampAbove_m = 30.0;

QString place_text(const dvec3& place) {
  const auto number = [](double value) { return QString::number(value, 'g', 12); };
  return QStringLiteral("{\"position\": [%1, %2, %3]}")
      .arg(number(place.x), number(place.y), number(place.z));
}

}  // namespace

ItemPicker::ItemPicker(Kind kind, Document& document, std::function<dvec3()> near, QWidget* parent)
    : QWidget(parent),
      kind_(kind),
      document_(document),
      near_(std::move(near)),
      items_(new QComboBox),
      more_(new QToolButton),
      fewer_(new QToolButton) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(items_, 1);
  layout->addWidget(more_);
  layout->addWidget(fewer_);
  items_->setFocusPolicy(Qt::StrongFocus);
  setFocusProxy(items_);
  items_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  if (kind == Kind::lamp) items_->setPlaceholderText(tr("No lamp"));
  if (kind == Kind::model) items_->setPlaceholderText(tr("No model"));
  more_->setText(QStringLiteral("+"));
  more_->setToolTip(kind == Kind::lamp    ? tr("One more lamp")
                    : kind == Kind::model ? tr("One more model, from a file")
                                          : tr("One more balloon"));
  fewer_->setText(QStringLiteral("−"));
  fewer_->setToolTip(kind == Kind::lamp    ? tr("Remove this lamp")
                     : kind == Kind::model ? tr("Remove this model")
                                           : tr("Remove this balloon"));
  for (QToolButton* button : {more_, fewer_}) {
    button->setAccessibleName(button->toolTip());
    button->setVisible(kind != Kind::material);
  }
  connect(more_, &QToolButton::clicked, this, &ItemPicker::add);
  connect(fewer_, &QToolButton::clicked, this, &ItemPicker::remove);
  connect(items_, &QComboBox::activated, this, &ItemPicker::refresh);
  connect(&document, &Document::changed, this, &ItemPicker::refresh);
  if (kind == Kind::material) {
    for (std::size_t i = 0; i < scene::kMaterialCount; ++i) {
      const auto id = static_cast<scene::MaterialId>(i);
      const auto name = QString::fromStdString(scene::material_name(id));
      items_->addItem(word_text(name), QString("/materials/" + name));
    }
    items_->setCurrentIndex(items_->findData(QStringLiteral("/materials/envelope")));
  }
  refresh();
}

QString ItemPicker::list() const {
  if (kind_ == Kind::model) return QStringLiteral("/objects");
  return kind_ == Kind::lamp ? QStringLiteral("/lights") : QStringLiteral("/balloons");
}

int ItemPicker::count() const {
  const scene::Scene& scene = document_.scene();
  if (kind_ == Kind::model) return static_cast<int>(scene.objects.size());
  return static_cast<int>(kind_ == Kind::lamp ? scene.lights.size() : scene.balloons.size());
}

int ItemPicker::most() const {
  return scene::field_rule(list().toStdString()).most_items;
}

QString ItemPicker::chosen() const {
  return items_->currentData().toString();
}

void ItemPicker::choose(const QString& pointer) {
  items_->setCurrentIndex(items_->findData(pointer));
  refresh();
}

QString ItemPicker::prefix_of(const QString& pointer) const {
  constexpr const char* kPrefixes[] = {"/balloon", "/objects/0", "/lights/0",
                                       "/materials/envelope"};
  const QString prefix = QString::fromLatin1(kPrefixes[static_cast<std::size_t>(kind_)]);
  return pointer.startsWith(prefix + "/") ? prefix : QString();
}

void ItemPicker::add() {
  if (kind_ == Kind::model) {
    Q_EMIT file_asked();
    return;
  }
  const scene::Scene& scene = document_.scene();
  const int number = count();
  dvec3 place;
  if (kind_ == Kind::lamp) {
    const dvec3 near = near_();
    place = {near.x + kApart_m * number, near.y + kLampAbove_m, near.z + kApart_m};
  } else {
    // New balloons are placed beside one another, and further ones farther back.
    const dvec3 near = scene.balloon.position;
    place = {near.x + (number % 2 == 0 ? kApart_m : -kApart_m) * (1 + number / 2), near.y,
             near.z - kApart_m * number};
  }
  document_.end_gesture();
  document_.set(more_->toolTip(), list() + "/" + QString::number(number), place_text(place));
  choose(list() + "/" + QString::number(number));
}

void ItemPicker::remove() {
  const QString pointer = chosen();
  if (!pointer.startsWith(list() + "/")) return;
  QJsonArray all = QJsonDocument::fromJson(document_.value(list()).toUtf8()).array();
  all.removeAt(pointer.section(QLatin1Char('/'), 2, 2).toInt());
  document_.end_gesture();
  if (all.isEmpty()) {
    document_.reset(fewer_->toolTip(), {list()});
  } else {
    document_.set(fewer_->toolTip(), list(),
                  QString::fromUtf8(QJsonDocument(all).toJson(QJsonDocument::Compact)));
  }
}

QString ItemPicker::name_of(int index) const {
  if (kind_ == Kind::lamp) return tr("Lamp %1").arg(index + 1);
  if (kind_ == Kind::balloon) return tr("Balloon %1").arg(index + 2);
  const auto& file = document_.scene().objects[static_cast<std::size_t>(index)].file;
  return QStringLiteral("%1: %2").arg(index + 1).arg(
      QFileInfo(QString::fromStdString(file)).fileName());
}

/// Shows the names of models, which change when one of them is removed.
void ItemPicker::show_names() {
  for (int i = 0; i < items_->count(); ++i) {
    if (items_->itemText(i) != name_of(i)) items_->setItemText(i, name_of(i));
  }
}

/// Updates the list from the document. An addition that is undone removes its item as well.
void ItemPicker::refresh() {
  if (kind_ != Kind::material) {
    const bool balloons = kind_ == Kind::balloon;
    const int wanted = count() + (balloons ? 1 : 0);
    while (items_->count() > wanted) items_->removeItem(items_->count() - 1);
    while (items_->count() < wanted) {
      const int i = items_->count() - (balloons ? 1 : 0);
      items_->addItem(i < 0 ? QString() : name_of(i), list() + "/" + QString::number(i));
      if (i < 0) {
        items_->setItemText(0, tr("Balloon %1").arg(1));
        items_->setItemData(0, QStringLiteral("/balloon"));
      }
    }
    if (kind_ == Kind::model) show_names();
    items_->setEnabled(wanted > 0);
    fewer_->setVisible(wanted > 0);
    more_->setEnabled(count() < most());
    fewer_->setEnabled(chosen().startsWith(list() + "/"));
  }
  if (told_ == chosen() && !told_.isNull()) return;
  told_ = chosen().isNull() ? QStringLiteral("") : chosen();
  Q_EMIT chosen_changed(chosen());
}

}  // namespace aerostat::viewer
