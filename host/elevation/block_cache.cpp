#include "elevation/block_cache.hpp"

#include <atomic>
#include <utility>

namespace aerostat::elevation {

BlockCache::Block BlockCache::find(const Key& key) {
  const std::lock_guard lock(mutex_);
  const auto at = places_.find(key);
  if (at == places_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, at->second);
  return at->second->block;
}

void BlockCache::put(const Key& key, Block block) {
  const std::size_t bytes = block->size() * sizeof(float);
  const std::lock_guard lock(mutex_);
  if (const auto at = places_.find(key); at != places_.end()) remove(at);
  // Two blocks stay, however large they are: what is read often lies on both sides of a border, and
  // large blocks cost the most to decode.
  while (entries_.size() > 1 && bytes_ + bytes > most_bytes_)
    remove(places_.find(entries_.back().key));
  entries_.push_front({key, std::move(block)});
  places_[key] = entries_.begin();
  bytes_ += bytes;
}

void BlockCache::drop(std::uint64_t file) {
  const std::lock_guard lock(mutex_);
  auto at = places_.lower_bound({file, 0, 0});
  while (at != places_.end() && std::get<0>(at->first) == file) remove(at++);
}

void BlockCache::remove(const std::map<Key, Entries::iterator>::iterator& at) {
  bytes_ -= at->second->block->size() * sizeof(float);
  entries_.erase(at->second);
  places_.erase(at);
}

BlockCache& BlockCache::shared() {
  constexpr std::size_t kMostBytes = std::size_t{192} << 20;
  static BlockCache cache(kMostBytes);
  return cache;
}

std::uint64_t BlockCache::new_file() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace aerostat::elevation
