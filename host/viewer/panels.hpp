#pragma once

#include <QTabWidget>
#include <optional>
#include <vector>

#include "viewer/editors.hpp"
#include "viewer/item_picker.hpp"
#include "viewer/render_thread.hpp"

class QComboBox;
class QToolButton;
class QFormLayout;

namespace aerostat::viewer {

class CameraControl;
class SunPanel;

/// The tabs with all controls.
class Panels : public QTabWidget {
  Q_OBJECT

 public:
  Panels(Document& document, CameraControl& camera, QWidget* parent = nullptr);

  const std::vector<ControlRow*>& rows() const { return rows_; }
  SunPanel& sun() { return *sun_; }
  ItemPicker& balloons() { return *balloons_; }
  ItemPicker& models() { return *models_; }
  ItemPicker& lamps() { return *lamps_; }
  ItemPicker& materials() { return *materials_; }

  void show_devices(const std::vector<DeviceChoice>& devices);
  void show_device(const QString& selector);
  /// Shows the controls of a model, which is a pointer such as "/objects/0".
  void show_model(const QString& pointer);
  /// Draws the direction of the camera on the disc of the sun.
  void show_view();

 Q_SIGNALS:
  void device_chosen(const QString& selector);
  void placing_asked();

 private:
  QFormLayout* add_panel(const QString& title);
  void add_rows(QFormLayout* form, Panel panel);
  void add_group(QFormLayout* form, const ControlGroup& group);
  void add_picker(QFormLayout* form, const QString& pointer, QToolButton* fold);
  QToolButton* add_fold(QFormLayout* form, const QString& title);
  void bind_rows(const ItemPicker& picker);
  void fit_width();
  void add_view(QFormLayout* form);
  void add_sizes(QFormLayout* form);
  void add_device(QFormLayout* form);
  void refresh();
  void fill_presets();

  Document& document_;
  CameraControl& camera_;
  std::vector<ControlRow*> rows_;
  SunPanel* sun_;
  ItemPicker* balloons_;
  ItemPicker* models_;
  QToolButton* models_fold_ = nullptr;
  ItemPicker* lamps_;
  ItemPicker* materials_;
  QComboBox* view_;
  QComboBox* presets_;
  std::optional<scene::BiomeKind> presets_of_;
  QComboBox* sizes_;
  QComboBox* devices_;
};

}  // namespace aerostat::viewer
