#include "render/row_queue.hpp"

#include <algorithm>

namespace aerostat::render {

RowQueue::RowQueue(int y0, int y1, int devices)
    : y0_(y0),
      y1_(y1),
      rows_(static_cast<std::size_t>(y1 - y0)),
      first_own_(static_cast<std::size_t>(devices), y0) {}

void RowQueue::begin_pass(int y0, int y1) {
  const RowRange rows{y0, y1};
  begin_pass(std::span(&rows, 1));
}

void RowQueue::begin_pass(std::span<const RowRange> waiting) {
  const std::lock_guard lock(mutex_);
  for (Row& one : rows_) one.waits = false;
  waiting_ = 0;
  for (const RowRange& rows : waiting) {
    for (int y = rows.y0; y < rows.y1; ++y) row(y).waits = true;
    waiting_ += rows.y1 - rows.y0;
  }
  std::fill(first_own_.begin(), first_own_.end(), y0_);
}

std::optional<RowRun> RowQueue::next(int device, int least, int most) {
  const std::lock_guard lock(mutex_);
  if (waiting_ == 0) return std::nullopt;
  const auto devices = static_cast<int>(first_own_.size());
  // Each device gets half of an even share each time. So the runs at the end are small, and the
  // order in which devices take them matters less.
  if (devices > 1) most = std::clamp(waiting_ / (2 * devices), least, std::max(least, most));
  RowRun run = own_run(device, most);
  if (run.y0 == run.y1) run = foreign_run(most);
  for (int y = run.y0; y < run.y1; ++y) row(y) = {device, false};
  waiting_ -= run.y1 - run.y0;
  return run;
}

void RowQueue::close() {
  const std::lock_guard lock(mutex_);
  waiting_ = 0;
}

std::vector<RowRange> RowQueue::pause() {
  const std::lock_guard lock(mutex_);
  std::vector<RowRange> waiting;
  for (int y = y0_; y < y1_ && waiting_ > 0; ++y) {
    if (!row(y).waits) continue;
    if (waiting.empty() || waiting.back().y1 != y) waiting.push_back({y, y});
    waiting.back().y1 = y + 1;
  }
  waiting_ = 0;
  return waiting;
}

void RowQueue::hold_all(int device) {
  const std::lock_guard lock(mutex_);
  for (Row& one : rows_) one.holder = device;
}

/// Returns the first waiting rows that `device` or nobody holds, at most `most`.
RowRun RowQueue::own_run(int device, int most) {
  int& y = first_own_[static_cast<std::size_t>(device)];
  const auto is_own = [&](const Row& row) {
    return row.waits && (row.holder == device || row.holder == kNobody);
  };
  while (y < y1_ && !is_own(row(y))) ++y;
  RowRun run{y, y, y < y1_ ? row(y).holder : kNobody};
  while (run.y1 < std::min(y1_, run.y0 + most) && is_own(row(run.y1)) &&
         row(run.y1).holder == run.holder) {
    ++run.y1;
  }
  return run;
}

/// Returns the last waiting rows, at most `most`, because their holder would come to them last.
RowRun RowQueue::foreign_run(int most) const {
  int end = y1_;
  while (!row(end - 1).waits) --end;
  RowRun run{end, end, row(end - 1).holder};
  while (run.y0 > std::max(y0_, end - most) && row(run.y0 - 1).waits &&
         row(run.y0 - 1).holder == run.holder) {
    --run.y0;
  }
  return run;
}

std::vector<RowRun> RowQueue::held() const {
  const std::lock_guard lock(mutex_);
  std::vector<RowRun> runs;
  for (int y = y0_; y < y1_; ++y) {
    const int holder = row(y).holder;
    if (runs.empty() || runs.back().holder != holder) runs.push_back({y, y, holder});
    runs.back().y1 = y + 1;
  }
  return runs;
}

}  // namespace aerostat::render
