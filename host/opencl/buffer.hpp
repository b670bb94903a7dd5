#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "opencl/program.hpp"

namespace aerostat::opencl {

/// Limits the bytes of buffers that may exist on a device at once. Drivers grant more than there is
/// and fail late, so aerostat counts itself. Copies share one count.
class MemoryBudget {
 public:
  /// Makes a budget without a limit.
  MemoryBudget();
  /// Makes a budget. `bound` says in words what sets the limit. If it is empty, the device or the
  /// user does.
  explicit MemoryBudget(std::uint64_t limit_bytes, std::string bound = {});

  std::uint64_t limit() const { return state_->limit; }
  std::uint64_t used() const { return state_->used; }
  /// Returns what sets the limit in words, or an empty text if the device or the user does.
  const std::string& bound() const { return state_->bound; }

  /// Counts `bytes` for `what` ("the triangles"). Throws Error{exhausted}, counting nothing, if
  /// they would exceed the limit. The message says how much is needed and how much is allowed. It
  /// also says what sets the limit, or that --memory-limit changes it.
  void reserve(std::uint64_t bytes, const std::string& what);
  void release(std::uint64_t bytes);

 private:
  struct State {
    std::uint64_t limit = 0;
    std::uint64_t used = 0;
    std::string bound;
  };
  std::shared_ptr<State> state_;
};

/// The ways in which kernels may access a buffer.
enum class Access { read, read_write };

/// The content of new memory.
enum class Content { zeros, unset };

/// Untyped device memory that counts in a budget as long as it exists. It is movable. A moved-from
/// or default-constructed buffer is empty.
class RawBuffer {
 public:
  RawBuffer() = default;
  /// Allocates `bytes` bytes. They are rounded up to a multiple of 16 and at least 16, because
  /// OpenCL has no empty buffers. Zeros are written at once, so that a driver that allocates late
  /// fails here. Unset memory is for a caller whose kernel writes all of it next, on all cores of a
  /// CPU. Throws Error{exhausted}.
  RawBuffer(const Context& context, MemoryBudget budget, std::uint64_t bytes, std::string what,
            Access access, Content content = Content::zeros);
  /// Allocates a copy of the `bytes` bytes at `data`.
  RawBuffer(const Context& context, MemoryBudget budget, const void* data, std::uint64_t bytes,
            std::string what, Access access);
  /// Makes a buffer of the `bytes` > 0 bytes at `data` themselves, if the device works in the
  /// host's memory. They must not change, and `owner` keeps them until the device has finished with
  /// them.
  RawBuffer(const Context& context, MemoryBudget budget, std::shared_ptr<const void> owner,
            const void* data, std::uint64_t bytes, std::string what);
  RawBuffer(RawBuffer&& other) noexcept;
  RawBuffer& operator=(RawBuffer&& other) noexcept;
  ~RawBuffer();

  /// Returns the buffer, or null if it is empty.
  const cl::Buffer* handle() const { return handle_.get(); }
  std::uint64_t allocated_bytes() const { return allocated_; }

  /// Copies bytes to the device and waits for the end. Throws Error{internal} if the range is not
  /// inside the buffer. `read` does the same in the other direction.
  void write(const void* data, std::uint64_t offset, std::uint64_t bytes);
  void read(void* data, std::uint64_t offset, std::uint64_t bytes) const;
  /// Calls `look` with the bytes at a place that the host can read. A device that works in the
  /// host's memory need not copy them. They must not be used after `look` returns.
  void look_at(std::uint64_t offset, std::uint64_t bytes,
               const std::function<void(const void*)>& look) const;

 private:
  void allocate(const Context& context, std::uint64_t bytes, Access access,
                const std::function<void()>& fill);
  void let_go() noexcept;
  void check_range(std::uint64_t offset, std::uint64_t bytes) const;

  std::shared_ptr<const cl::CommandQueue> queue_;
  /// The owner of memory that is not the buffer's own.
  std::shared_ptr<const void> owner_;
  std::shared_ptr<const cl::Buffer> handle_;
  MemoryBudget budget_;
  std::string what_;
  std::uint64_t allocated_ = 0;
};

/// A buffer of `size()` elements of T on a device. `what` names the contents in messages ("the
/// triangles").
template <typename T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);

 public:
  Buffer() = default;

  /// Makes a copy of `values`. Kernels only read it unless `access` says otherwise.
  Buffer(const Context& context, const MemoryBudget& budget, std::span<const T> values,
         std::string what, Access access = Access::read)
      : raw_(context, budget, values.data(), values.size_bytes(), std::move(what), access),
        size_(values.size()) {}

  /// Allocates `count` elements, which are zero or unset as in RawBuffer.
  Buffer(const Context& context, const MemoryBudget& budget, std::size_t count, std::string what,
         Access access = Access::read_write, Content content = Content::zeros)
      : raw_(context, budget, std::uint64_t{count} * sizeof(T), std::move(what), access, content),
        size_(count) {}

  /// Makes a buffer of `values` without a copy, as RawBuffer does. Kernels only read it.
  Buffer(const Context& context, const MemoryBudget& budget, std::shared_ptr<const void> owner,
         std::span<const T> values, std::string what)
      : raw_(context, budget, std::move(owner), values.data(), values.size_bytes(),
             std::move(what)),
        size_(values.size()) {}

  std::size_t size() const { return size_; }
  std::uint64_t bytes() const { return std::uint64_t{size_} * sizeof(T); }
  const RawBuffer& raw() const { return raw_; }

  /// Overwrites the elements from `first` on and waits for the end.
  void write(std::span<const T> values, std::size_t first = 0) {
    check(first, values.size());
    raw_.write(values.data(), std::uint64_t{first} * sizeof(T), values.size_bytes());
  }

  /// Waits for the kernels enqueued before, and reads the elements from `first` on.
  void read(std::span<T> values, std::size_t first = 0) const {
    check(first, values.size());
    raw_.read(values.data(), std::uint64_t{first} * sizeof(T), values.size_bytes());
  }

  /// Waits for the kernels enqueued before, and calls `look` with `count` elements from `first` on.
  /// They must not be used after `look` returns. It is cheaper than `read` on a device that needs
  /// no copy.
  void look_at(std::size_t first, std::size_t count,
               const std::function<void(std::span<const T>)>& look) const {
    check(first, count);
    raw_.look_at(std::uint64_t{first} * sizeof(T), std::uint64_t{count} * sizeof(T),
                 [&](const void* data) {
                   look({static_cast<const T*>(data), count});
                 });
  }

  std::vector<T> read() const {
    std::vector<T> values(size_);
    read(std::span<T>(values));
    return values;
  }

 private:
  void check(std::size_t first, std::size_t count) const;

  RawBuffer raw_;
  std::size_t size_ = 0;
};

/// Throws Error{internal} unless first + count <= size.
void require_range(std::size_t first, std::size_t count, std::size_t size);

template <typename T>
void Buffer<T>::check(std::size_t first, std::size_t count) const {
  require_range(first, count, size_);
}

}  // namespace aerostat::opencl
