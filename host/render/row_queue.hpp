#pragma once

#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace aerostat::render {

/// Rows of the image, y0 <= y < y1.
struct RowRange {
  int y0 = 0, y1 = 0;
};

/// Rows of the image, y0 <= y < y1, and the device whose film holds what was rendered of them.
struct RowRun {
  int y0 = 0, y1 = 0;
  /// The index of a device, or RowQueue::kNobody before the first pass.
  int holder = 0;
};

/// Hands out the rows of a picture to several devices, pass after pass. The device that asks first
/// gets the next rows, so that each device does as much as its speed allows. In later passes a
/// device gets the rows that it holds as long as there are any. It may be used from several threads
/// at once.
class RowQueue {
 public:
  static constexpr int kNobody = -1;

  /// Makes a queue of the rows y0 <= y < y1 for the devices 0 to `devices` - 1.
  RowQueue(int y0, int y1, int devices);

  /// Begins a pass that renders every row once more, or the rows y0 <= y < y1. It must not be
  /// called during a pass.
  void begin_pass() { begin_pass(y0_, y1_); }
  void begin_pass(int y0, int y1);
  /// Begins a pass, or goes on with a paused one, in which these rows wait.
  void begin_pass(std::span<const RowRange> waiting);

  /// Gives up to `most` rows to `device`, which holds them from now on. The `holder` of the run is
  /// the device that held them before. Returns nothing if no row is left. Several devices get fewer
  /// rows towards the end of a pass, so that all end together, but not fewer than `least` if that
  /// many lie side by side.
  std::optional<RowRun> next(int device, int least, int most);

  /// Ends the pass, so that no row is left in it.
  void close();
  /// Ends the pass and returns the rows that waited, from the top. Rows that devices work on are
  /// not among them.
  std::vector<RowRange> pause();

  /// Makes a device the holder of all rows.
  void hold_all(int device);

  /// Returns which device holds which rows, from the top.
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
  /// For each device, the first row that may still wait for it. None of its rows above waits.
  std::vector<int> first_own_;
  int waiting_ = 0;
};

}  // namespace aerostat::render
