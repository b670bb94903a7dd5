#pragma once

#include <QFrame>
#include <QString>
#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;

namespace aerostat::viewer {

/// A bar above the picture that says what went wrong and offers what can be done about it.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  struct Offer {
    QString text;
    std::function<void()> accept;
  };
  void show_message(const QString& message, const std::vector<Offer>& offers = {});
  void dismiss();
  QString message() const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void clear_offers();
  void arrange(int width);

  QLabel* text_;
  QHBoxLayout* offers_;
};

}  // namespace aerostat::viewer
