#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

namespace aerostat::elevation {

/// Decoded strips and tiles of all open files, so that neighbouring windows do not decode them
/// twice. The least recently used ones go first, but two always stay. It may be used from any
/// thread.
class BlockCache {
 public:
  /// File, level of detail, and number of the block.
  using Key = std::tuple<std::uint64_t, int, std::uint64_t>;
  using Block = std::shared_ptr<const std::vector<float>>;

  explicit BlockCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Returns a block, or null if it is not there.
  Block find(const Key& key);
  void put(const Key& key, Block block);
  /// Drops all blocks of a file.
  void drop(std::uint64_t file);

  /// The cache of the process.
  static BlockCache& shared();
  /// Returns a number for a file that no other file has.
  static std::uint64_t new_file();

 private:
  struct Entry {
    Key key;
    Block block;
  };
  using Entries = std::list<Entry>;

  void remove(const std::map<Key, Entries::iterator>::iterator& at);

  std::mutex mutex_;
  std::size_t most_bytes_ = 0, bytes_ = 0;
  Entries entries_;  // the most recently used first
  std::map<Key, Entries::iterator> places_;
};

}  // namespace aerostat::elevation
