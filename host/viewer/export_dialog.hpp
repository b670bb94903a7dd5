#pragma once

#include <QDialog>
#include <memory>

#include "viewer/document.hpp"
#include "viewer/number_box.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace aerostat::viewer {

class ExportJob;

/// Asks where to, how large and how good, renders, and can be cancelled meanwhile.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  ExportDialog(const Document& document, const QString& device, QWidget* parent = nullptr);
  ~ExportDialog() override;

  void set_path(const QString& path);
  /// "draft", "standard" or "final".
  void set_quality(const QString& quality);
  void begin();
  bool is_busy() const { return job_ != nullptr; }
  QString message() const;

 public Q_SLOTS:
  /// Cancels the export if there is one, else closes.
  void reject() override;

 Q_SIGNALS:
  void ended(bool written);

 private:
  void build();
  void choose_path();
  void show_progress(double fraction, const QString& stage);
  void end(bool written, const QString& error);
  bool may_write(const QString& path);
  void ask_about_file(QString path);
  void set_busy(bool busy);
  std::vector<scene::Override> changes() const;

  const Document& document_;
  QString device_;
  QString agreed_path_;  // may be replaced without a question
  QLineEdit* path_;
  QComboBox* quality_;
  WholeBox* width_;
  WholeBox* height_;
  QProgressBar* progress_;
  QLabel* message_;
  QPushButton* browse_;
  QPushButton* export_;
  QPushButton* close_;
  std::unique_ptr<ExportJob> job_;
};

}  // namespace aerostat::viewer
