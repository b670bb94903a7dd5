#pragma once

#include <QByteArray>
#include <vector>

#include "scene/source.hpp"
#include "viewer/number_box.hpp"
#include "viewer/output_dialog.hpp"

namespace aerostat::viewer {

/// A dialog that asks for the file, the size and the quality of a picture and renders it.
class ExportDialog : public OutputDialog {
  Q_OBJECT

 public:
  ExportDialog(const Document& document, const QString& device, QWidget* parent = nullptr);

 private:
  bool is_ready() override;
  void start(const QString& path) override;
  void ask_about_file(QString path, const QByteArray& bytes);
  std::vector<scene::Override> changes() const;

  WholeBox* width_;
  WholeBox* height_;
};

}  // namespace aerostat::viewer
