#pragma once

#include <QDialog>
#include <memory>

#include "viewer/document.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace aerostat::viewer {

class FilmJob;

/// A dialog that asks for the file and the quality of a film and makes it. The film can be
/// cancelled, and goes on from its frames when it is asked for again.
class FilmDialog : public QDialog {
  Q_OBJECT

 public:
  FilmDialog(const Document& document, const QString& device, QWidget* parent = nullptr);
  ~FilmDialog() override;

  void set_path(const QString& path);
  /// Sets the quality: "preview", "draft", "standard" or "final", or nothing for that of the scene.
  void set_quality(const QString& quality);
  void begin();
  bool is_busy() const { return job_ != nullptr; }
  QString message() const;

 public Q_SLOTS:
  /// Cancels the film if one is being made, else closes the dialog.
  void reject() override;

 Q_SIGNALS:
  void ended(bool written);

 private:
  void build();
  void choose_path();
  bool may_write(const QString& path);
  scene::SceneSource source() const;
  void end(bool written, const QString& message);
  void set_busy(bool busy);

  const Document& document_;
  QString device_;
  /// The path of a film that may be replaced without a question.
  QString agreed_path_;
  QLineEdit* path_;
  QComboBox* quality_;
  QProgressBar* progress_;
  QLabel* message_;
  QPushButton* browse_;
  QPushButton* export_;
  QPushButton* close_;
  std::unique_ptr<FilmJob> job_;
};

}  // namespace aerostat::viewer
