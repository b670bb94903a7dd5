#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include <sys/mman.h>

namespace aerostat {

/// Allocates for arrays of many megabytes that all cores are about to fill: elements start without
/// a value, memory begins at a page, and the system is asked for huge pages.
template <typename T>
class ArrayAllocator {
 public:
  using value_type = T;

  ArrayAllocator() = default;
  template <typename U>
  explicit ArrayAllocator(const ArrayAllocator<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    const std::size_t alignment = bytes >= kHugePage ? kHugePage : kPage;
    void* memory = ::operator new(bytes, std::align_val_t(alignment));
    if (bytes >= kHugePage) ::madvise(memory, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
    return static_cast<T*>(memory);
  }

  void deallocate(T* memory, std::size_t count) {
    const std::size_t alignment = count * sizeof(T) >= kHugePage ? kHugePage : kPage;
    ::operator delete(memory, std::align_val_t(alignment));
  }

  template <typename U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <typename U, typename... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const ArrayAllocator&, const ArrayAllocator&) { return true; }

 private:
  static constexpr std::size_t kPage = 4096;
  static constexpr std::size_t kHugePage = std::size_t{1} << 21;
};

/// A vector whose resize() leaves new elements without a value.
template <typename T>
using Array = std::vector<T, ArrayAllocator<T>>;

}  // namespace aerostat
