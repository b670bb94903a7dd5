#pragma once

#include <QString>

#include "viewer/output_dialog.hpp"

namespace aerostat::viewer {

/// A dialog that asks for the file and the quality of a film and makes it. A film that was
/// cancelled goes on from its frames when it is asked for again.
class FilmDialog : public OutputDialog {
  Q_OBJECT

 public:
  FilmDialog(const Document& document, const QString& device, QWidget* parent = nullptr);

 private:
  void start(const QString& path) override;
};

}  // namespace aerostat::viewer
