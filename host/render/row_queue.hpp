#pragma once

#include <mutex>
#include <optional>
#include <vector>

namespace aerostat::render {

/// Rows of the image, y0 <= y < y1, and the device whose film holds what was rendered of them.
struct RowRun {
  int y0 = 0, y1 = 0;
  int holder = 0;  // index of a device; RowQueue::kNobody before the first pass
};

/// Hands out the rows of a picture to several devices, pass after pass: whoever asks first gets
/// the next rows, so that each device does as much as it is fast. From pass to pass a device is
/// given the rows that it holds, as long as there are any. Safe from several threads.
class RowQueue {
 public:
  static constexpr int kNobody = -1;

  /// For the rows y0 <= y < y1 and devices 0 to `devices` - 1.
  RowQueue(int y0, int y1, int devices);

  /// Every row is to be rendered once more, or those of y0 <= y < y1. Not while a pass is under
  /// way.
  void begin_pass() { begin_pass(y0_, y1_); }
  void begin_pass(int y0, int y1);

  /// Up to `most` rows for `device`, which holds them from now on; `holder` is who did before.
  /// Several devices are given less towards the end of a pass, but not below `least` where so much
  /// lies side by side: all end together. Nothing if no row is left.
  std::optional<RowRun> next(int device, int least, int most);

  /// No row is left in this pass.
  void close();

  /// Who holds which rows, from the top.
  std::vector<RowRun> held() const;

 private:
  struct Row {
    int holder = kNobody;
    bool waits = false;
  };

  RowRun own_run(int device, int most);
  RowRun foreign_run(int most) const;
  Row& row(int y) { return rows_[static_cast<std::size_t>(y - y0_)]; }
  const Row& row(int y) const { return rows_[static_cast<std::size_t>(y - y0_)]; }

  mutable std::mutex mutex_;
  const int y0_, y1_;
  std::vector<Row> rows_;
  std::vector<int> first_own_;  // of each device: none of its rows above waits
  int waiting_ = 0;
};

}  // namespace aerostat::render
