#include "viewer/panels.hpp"

#include <QComboBox>
#include <QFormLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/scene.hpp"
#include "viewer/camera_control.hpp"
#include "viewer/scene_presets.hpp"
#include "viewer/sun_disc.hpp"
#include "viewer/sun_panel.hpp"

namespace aerostat::viewer {
namespace {

/// The data of the two special presets in the list: the file's own camera, and the first camera of
/// an installed scene. The general presets count from 1.
constexpr int kAsInFile = -1, kOfScenes = 100;
constexpr QSize kSizes[] = {{640, 360},   {1280, 720},  {1920, 1080},
                            {3840, 2160}, {1080, 1080}, {1080, 1350}};

QLabel* heading(const QString& text) {
  auto* label = new QLabel("<b>" + text.toHtmlEscaped() + "</b>");
  label->setContentsMargins(0, 8, 0, 0);
  return label;
}

/// Hides a row together with its fold. A row of a list that is empty is hidden too, because it
/// would edit nothing.
void hide_with(QToolButton& fold, QFormLayout& form, QWidget* field, ItemPicker* of = nullptr) {
  const auto show = [&fold, &form, field, of] {
    form.setRowVisible(field, fold.isChecked() && (of == nullptr || !of->chosen().isEmpty()));
  };
  show();
  QObject::connect(&fold, &QToolButton::toggled, &form, show);
  if (of != nullptr) QObject::connect(of, &ItemPicker::chosen_changed, &form, show);
}

/// Returns a box whose value does not change when the wheel scrolls over it.
QComboBox* steady_box() {
  auto* box = new QComboBox;
  box->setFocusPolicy(Qt::StrongFocus);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  return box;
}

}  // namespace

Panels::Panels(Document& document, CameraControl& camera, QWidget* parent)
    : QTabWidget(parent),
      document_(document),
      camera_(camera),
      sun_(new SunPanel(document)),
      balloons_(new ItemPicker(ItemPicker::Kind::balloon, document)),
      models_(new ItemPicker(ItemPicker::Kind::model, document)),
      lamps_(new ItemPicker(ItemPicker::Kind::lamp, document,
                            [&camera] { return camera.balloon_place(); })),
      materials_(new ItemPicker(ItemPicker::Kind::material, document)),
      view_(steady_box()),
      presets_(steady_box()),
      sizes_(steady_box()),
      devices_(steady_box()) {
  setDocumentMode(true);
  add_rows(add_panel(tr("&Land")), Panel::land);
  QFormLayout* light = add_panel(tr("Li&ght"));
  light->addRow(heading(tr("Sun")));
  light->addRow(sun_);
  add_rows(light, Panel::light);
  add_rows(add_panel(tr("&Balloon")), Panel::balloon);
  add_rows(add_panel(tr("&Materials")), Panel::materials);
  QFormLayout* picture = add_panel(tr("&Picture"));
  add_view(picture);
  add_rows(picture, Panel::view);
  add_rows(picture, Panel::picture);
  add_device(picture);
  for (ItemPicker* picker : {balloons_, models_, lamps_, materials_}) {
    connect(picker, &ItemPicker::chosen_changed, this, [this, picker] { bind_rows(*picker); });
    bind_rows(*picker);
  }
  for (auto* fold : findChildren<QToolButton*>()) {
    if (fold->isCheckable()) connect(fold, &QToolButton::toggled, this, &Panels::fit_width);
  }
  fit_width();
  connect(&document, &Document::changed, this, &Panels::refresh);
  refresh();
}

QFormLayout* Panels::add_panel(const QString& title) {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setRowWrapPolicy(QFormLayout::DontWrapRows);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(page);
  addTab(scroll, title);
  return form;
}

/// Makes the tabs wide enough that no page is cut at its side, with or without a scroll bar.
void Panels::fit_width() {
  const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent) + 2;
  for (auto* scroll : findChildren<QScrollArea*>()) {
    const int page = scroll->widget()->minimumSizeHint().width() + bar;
    scroll->setMinimumWidth(std::max(scroll->minimumWidth(), page));
  }
}

void Panels::add_rows(QFormLayout* form, Panel panel) {
  for (const ControlGroup& group : control_groups()) {
    if (group.panel == panel) add_group(form, group);
  }
}

/// Adds the controls of a group below its heading.
void Panels::add_group(QFormLayout* form, const ControlGroup& group) {
  QToolButton* const fold = group.folded ? add_fold(form, heading_of(group)) : nullptr;
  if (fold == nullptr && group.heading != nullptr) form->addRow(heading(heading_of(group)));
  for (const Control& control : controls()) {
    if (control.group != group.group) continue;
    const QString pointer = QString::fromStdString(control.pointer);
    add_picker(form, pointer, fold);
    ControlRow* row = ControlRow::make(control, document_, this);
    form->addRow(row->label(), row->editor());
    rows_.push_back(row);
    ItemPicker* of = nullptr;
    for (ItemPicker* picker : {lamps_, models_}) {
      if (!picker->prefix_of(pointer).isEmpty()) of = picker;
    }
    if (of == models_) models_fold_ = fold;
    if (fold != nullptr) hide_with(*fold, *form, row->editor(), of);
    if (pointer == QLatin1String("/image/height")) add_sizes(form);
  }
}

/// Adds the picker of the object that a control edits, unless the picker already has its place.
void Panels::add_picker(QFormLayout* form, const QString& pointer, QToolButton* fold) {
  const std::pair<ItemPicker*, QString> pickers[] = {{balloons_, tr("Balloon")},
                                                     {models_, tr("Model")},
                                                     {lamps_, tr("Lamp")},
                                                     {materials_, tr("Material of")}};
  for (const auto& [picker, text] : pickers) {
    if (picker->prefix_of(pointer).isEmpty() || picker->parentWidget() != nullptr) continue;
    auto* label = new QLabel(text);
    label->setBuddy(picker);
    form->addRow(label, picker);
    if (fold != nullptr) hide_with(*fold, *form, picker);
  }
}

/// Adds a heading that shows and hides the rows below it.
QToolButton* Panels::add_fold(QFormLayout* form, const QString& title) {
  auto* fold = new QToolButton;
  fold->setText(title);
  fold->setCheckable(true);
  fold->setAutoRaise(true);
  // Without this style, an open fold would look like a button that is held down.
  fold->setStyleSheet(QStringLiteral("QToolButton { border: none; padding: 6px 0 2px 0; }"));
  fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  fold->setArrowType(Qt::RightArrow);
  QFont font = fold->font();
  font.setBold(true);
  fold->setFont(font);
  connect(fold, &QToolButton::toggled, fold,
          [fold](bool open) { fold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow); });
  form->addRow(fold);
  return fold;
}

/// Binds the controls of the picker's kind to the object that is chosen in it.
void Panels::bind_rows(const ItemPicker& picker) {
  for (ControlRow* row : rows_) {
    const QString own = QString::fromStdString(row->control().pointer);
    const QString prefix = picker.prefix_of(own);
    if (prefix.isEmpty()) continue;
    row->bind_to(picker.chosen().isEmpty() ? QString() : picker.chosen() + own.mid(prefix.size()));
  }
}

void Panels::add_view(QFormLayout* form) {
  view_->addItem(tr("From outside"), static_cast<int>(ViewKind::outside));
  view_->addItem(tr("From the basket"), static_cast<int>(ViewKind::basket));
  view_->addItem(tr("Free"), static_cast<int>(ViewKind::free));
  view_->setToolTip(
      tr("Where the camera stands: before the balloon, in its basket, or where you "
         "move it"));
  connect(view_, &QComboBox::activated, this,
          [this](int index) { camera_.set_kind(static_cast<ViewKind>(index)); });
  presets_->setObjectName(QStringLiteral("presets"));
  presets_->setToolTip(
      tr("The camera as in the file, those of the scenes that came with the program in this biome, "
         "and such as suit any scene, counted from the balloon"));
  connect(presets_, &QComboBox::activated, this, [this](int index) {
    const int number = presets_->itemData(index).toInt();
    const auto own = scene_presets(document_.scene().biome.kind);
    presets_->setCurrentIndex(0);
    if (number == kAsInFile) {
      camera_.take_camera_of(tr("As in the file"), document_.saved());
    } else if (number >= kOfScenes && number - kOfScenes < static_cast<int>(own.size())) {
      const ScenePreset& preset = own[static_cast<std::size_t>(number - kOfScenes)];
      camera_.take_camera_of(preset.name, preset.scene);
    } else if (number > 0) {
      camera_.apply_preset(number - 1);
    }
  });
  auto* place = new QPushButton(tr("Put the Balloon by a Click"));
  place->setToolTip(
      tr("Then click on the ground below the place for the balloon (or Ctrl+click at "
         "any time)"));
  connect(place, &QPushButton::clicked, this, &Panels::placing_asked);
  form->addRow(heading(tr("View")));
  form->addRow(tr("View"), view_);
  form->addRow(tr("Preset"), presets_);
  form->addRow(place);
}

/// Fills the list of presets that suit the biome: the camera of the file, then those of the scenes,
/// then the general ones.
void Panels::fill_presets() {
  const scene::BiomeKind biome = document_.scene().biome.kind;
  if (presets_of_ == biome) return;
  presets_of_ = biome;
  presets_->clear();
  presets_->addItem(tr("Choose…"), 0);
  presets_->addItem(tr("As in the file"), kAsInFile);
  int number = kOfScenes;
  for (const ScenePreset& preset : scene_presets(biome)) presets_->addItem(preset.name, number++);
  number = 1;
  for (const QString& name : CameraControl::preset_names()) presets_->addItem(name, number++);
}

void Panels::add_sizes(QFormLayout* form) {
  sizes_->addItem(tr("Choose…"));
  for (const QSize& size : kSizes) {
    sizes_->addItem(QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()), size);
  }
  connect(sizes_, &QComboBox::activated, this, [this](int index) {
    const QSize size = sizes_->itemData(index).toSize();
    if (size.isEmpty()) return;
    document_.end_gesture();
    document_.change(tr("Change the Size"), {{"/image/width", std::to_string(size.width())},
                                             {"/image/height", std::to_string(size.height())}});
  });
  form->addRow(tr("Usual sizes"), sizes_);
}

void Panels::add_device(QFormLayout* form) {
  devices_->addItem(tr("Automatic"), QString());
  devices_->setToolTip(tr("The device that computes the picture. It is not saved with the scene."));
  devices_->setObjectName(QStringLiteral("device"));
  connect(devices_, &QComboBox::activated, this,
          [this](int index) { Q_EMIT device_chosen(devices_->itemData(index).toString()); });
  form->addRow(heading(tr("Computing")));
  form->addRow(tr("Device"), devices_);
}

void Panels::show_devices(const std::vector<DeviceChoice>& devices) {
  const QString chosen = devices_->currentData().toString();
  while (devices_->count() > 1) devices_->removeItem(1);
  for (const DeviceChoice& device : devices) {
    devices_->addItem(device.name, device.selector);
    devices_->setItemData(devices_->count() - 1, device.name, Qt::ToolTipRole);
  }
  show_device(chosen);
}

void Panels::show_device(const QString& selector) {
  int index = devices_->findData(selector);
  if (index < 0) {
    devices_->addItem(selector, selector);
    index = devices_->count() - 1;
  }
  devices_->setCurrentIndex(index);
}

void Panels::show_model(const QString& pointer) {
  models_->choose(pointer);
  models_fold_->setChecked(true);
  for (int i = 0; i < count(); ++i) {
    auto* scroll = qobject_cast<QScrollArea*>(widget(i));
    if (scroll == nullptr || !scroll->isAncestorOf(models_)) continue;
    setCurrentIndex(i);
    scroll->widget()->layout()->activate();
    scroll->ensureWidgetVisible(models_, 0, scroll->viewport()->height() / 2);
  }
}

void Panels::show_view() {
  const auto pose = camera_.pose();
  if (!pose) return;
  const dvec3 sight = pose->target - pose->position;
  const scene::Scene& scene = document_.scene();
  const double half = std::tan(scene.camera.fov_y_deg * std::numbers::pi / 360.0);
  const double wide = 2.0 * std::atan(half * scene.image.width / scene.image.height);
  sun_->disc().show_view(std::atan2(sight.x, -sight.z) * 180.0 / std::numbers::pi,
                         wide * 180.0 / std::numbers::pi);
}

void Panels::refresh() {
  fill_presets();
  view_->setCurrentIndex(static_cast<int>(camera_.kind()));
  const scene::Image& image = document_.scene().image;
  const int index = sizes_->findData(QSize(image.width, image.height));
  sizes_->setCurrentIndex(std::max(0, index));
  show_view();
}

}  // namespace aerostat::viewer
