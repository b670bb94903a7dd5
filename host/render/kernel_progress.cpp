#include "render/kernel_progress.hpp"

#include <algorithm>
#include <chrono>

namespace aerostat::render {
namespace {

/// The usual time of all steps. It was measured with PoCL on two idle cores.
constexpr double kUsualSeconds = 14.0;

}  // namespace

double KernelProgress::steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void KernelProgress::begin(double share) {
  const std::lock_guard lock(mutex_);
  done_ += share_;
  share_ = share;
  began_s_ = clock_();
}

void KernelProgress::finish() {
  const std::lock_guard lock(mutex_);
  share_ = 0.0;
  done_ = 1.0;
}

double KernelProgress::fraction() const {
  const std::lock_guard lock(mutex_);
  if (share_ <= 0.0) return done_;
  const double spent = std::max(0.0, clock_() - began_s_);
  // The guessed share of a step is one half after its usual time and three quarters after three
  // times that.
  const double guessed = share_ * spent / (spent + share_ * kUsualSeconds);
  return std::min(1.0, done_ + guessed);
}

}  // namespace aerostat::render
