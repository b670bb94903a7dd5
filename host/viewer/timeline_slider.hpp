#pragma once

#include <QSlider>
#include <vector>

namespace aerostat::viewer {

/// A slider over the frames of a film that shows where keys are. A click moves it there.
class TimelineSlider : public QSlider {
  Q_OBJECT

 public:
  explicit TimelineSlider(QWidget* parent = nullptr);

  /// A key to show, by the frame that it is at, which may lie between two.
  struct Mark {
    double frame = 1.0;
    bool is_chosen = false;  // it belongs to the value that is chosen
  };
  void show_marks(std::vector<Mark> marks);
  const std::vector<Mark>& marks() const { return marks_; }

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  double x_of(double frame) const;
  int frame_at(double x) const;
  double half_handle() const;

  std::vector<Mark> marks_;
};

}  // namespace aerostat::viewer
