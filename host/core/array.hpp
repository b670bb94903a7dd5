#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "core/huge_pages.hpp"

namespace aerostat {

/// Allocates for arrays of many megabytes that all cores are about to fill: elements start without
/// a value, so that each page is first touched by who fills it, and memory begins at a page.
template <typename T>
class ArrayAllocator {
 public:
  using value_type = T;

  ArrayAllocator() = default;
  template <typename U>
  explicit ArrayAllocator(const ArrayAllocator<U>&) {}

  T* allocate(std::size_t count) {
    void* const memory = ::operator new(count * sizeof(T), kAlignment);
    prefer_huge_pages(memory, count * sizeof(T));
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { ::operator delete(memory, kAlignment); }

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
  static constexpr std::align_val_t kAlignment{4096};
};

/// A vector whose resize() leaves new elements without a value.
template <typename T>
using Array = std::vector<T, ArrayAllocator<T>>;

}  // namespace aerostat
