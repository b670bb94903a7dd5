#pragma once

#include <memory>
#include <mutex>
#include <optional>

namespace aerostat {

/// Keeps the value that was made last and the key that it was made for. It may be used from any
/// thread; a thread that asks while a value is made waits for it.
template <typename Key, typename Value>
class LastMade {
 public:
  /// Returns the value of `key`: the kept one, or what `make()` returns, a shared_ptr<const Value>.
  /// If `make` throws, nothing is kept.
  template <typename Make>
  std::shared_ptr<const Value> get(const Key& key, const Make& make) {
    const std::lock_guard lock(mutex_);
    if (!value_ || !(*key_ == key)) {
      value_ = nullptr;
      key_ = key;
      value_ = make();
      ++count_;
    }
    return value_;
  }

  /// Returns how many values were made.
  int count() const {
    const std::lock_guard lock(mutex_);
    return count_;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<Key> key_;
  std::shared_ptr<const Value> value_;
  int count_ = 0;
};

}  // namespace aerostat
