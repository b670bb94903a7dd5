#pragma once

#include <QElapsedTimer>
#include <QStyle>
#include <QWidget>
#include <optional>

#include "viewer/document.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace aerostat::viewer {

class TimelineSlider;

/// The timeline of the scene's film: it moves through the frames, plays them and edits keys. The
/// window shows the scene of its frame, or the still picture if no frame is chosen.
class TimelinePanel : public QWidget {
  Q_OBJECT

 public:
  explicit TimelinePanel(Document& document, QWidget* parent = nullptr);

  /// Returns the time in seconds that the window shows, or nothing for the still picture.
  std::optional<double> shown_time() const;
  /// Returns the frame of the slider, from 1 on.
  int frame() const;
  int frames() const;
  bool is_playing() const { return is_playing_; }
  TimelineSlider& slider() { return *slider_; }
  QString value_text() const;
  QString position_text() const;

  /// Shows a frame.
  void go_to(int frame);
  /// Plays from the present frame on, or from the first one if the present one is the last.
  void play();
  /// Stops playing at the present frame.
  void pause();
  /// Shows the still picture again.
  void show_still();
  /// Chooses the value, by its JSON pointer, whose keys are edited.
  void choose_value(const QString& pointer);
  /// Gives the chosen value a key at the present frame. `json` is what the text box shows.
  void set_key(const QString& json);
  void remove_key();
  /// Tells that the frame which was asked for last is on the screen. While it plays, the next one
  /// follows: the one whose turn it is by the clock, so that slow machines leave frames out.
  void frame_arrived();

 Q_SIGNALS:
  /// Reports that another time is to be shown.
  void time_changed();
  void export_asked();

 private:
  void build();
  void connect_buttons();
  QToolButton* tool(const QString& text, QStyle::StandardPixmap icon);
  void refresh();
  void refresh_values();
  void show_value();
  void show_marks();
  void show_position();
  double time_of(int frame) const;
  QString pointer() const;
  QString value_at_frame() const;

  Document& document_;
  TimelineSlider* slider_;
  QToolButton* play_;
  QToolButton* still_;
  QLabel* position_;
  QComboBox* values_;
  QLineEdit* value_;
  QPushButton* set_;
  QPushButton* remove_;
  QPushButton* export_;
  bool is_shown_ = false;  // a frame and not the still picture
  bool is_playing_ = false;
  QElapsedTimer clock_;
  int first_ = 1;         // the frame at which it began to play
  int shown_frames_ = 0;  // since then
};

}  // namespace aerostat::viewer
