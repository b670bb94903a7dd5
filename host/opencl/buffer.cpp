#include "opencl/buffer.hpp"

#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "opencl/status.hpp"

namespace aerostat::opencl {
namespace {

constexpr std::uint64_t kGranule = 16;

double mebibytes(std::uint64_t bytes) {
  return static_cast<double>(bytes) / (1024.0 * 1024.0);
}

std::uint64_t rounded_up(std::uint64_t bytes) {
  if (bytes > std::numeric_limits<std::uint64_t>::max() - kGranule) return bytes;
  return std::max(kGranule, (bytes + kGranule - 1) / kGranule * kGranule);
}

cl_mem_flags flags_of(Access access) {
  return access == Access::read ? CL_MEM_READ_ONLY : CL_MEM_READ_WRITE;
}

}  // namespace

MemoryBudget::MemoryBudget() : MemoryBudget(std::numeric_limits<std::uint64_t>::max()) {}

MemoryBudget::MemoryBudget(std::uint64_t limit_bytes, std::string bound)
    : state_(std::make_shared<State>()) {
  state_->limit = limit_bytes;
  state_->bound = std::move(bound);
}

void MemoryBudget::reserve(std::uint64_t bytes, const std::string& what) {
  if (bytes > state_->limit - std::min(state_->limit, state_->used)) {
    const std::string by =
        state_->bound.empty() ? "(--memory-limit changes that)" : "by " + state_->bound;
    throw Error(
        ErrorKind::exhausted,
        fmt::format("not enough device memory for {}: {:.1f} MiB are needed beside {:.1f} "
                    "MiB in use, {:.1f} MiB are allowed {}",
                    what, mebibytes(bytes), mebibytes(state_->used), mebibytes(state_->limit), by));
  }
  state_->used += bytes;
}

void MemoryBudget::release(std::uint64_t bytes) {
  state_->used -= std::min(state_->used, bytes);
}

RawBuffer::RawBuffer(const Context& context, MemoryBudget budget, std::uint64_t bytes,
                     std::string what, Access access, Content content)
    : queue_(context.queue()), budget_(std::move(budget)), what_(std::move(what)) {
  allocate(context, bytes, access, [&] {
    if (content == Content::unset) return;
    queue_->enqueueFillBuffer(*handle_, cl_uint4{}, 0, rounded_up(bytes));
    queue_->finish();
  });
}

RawBuffer::RawBuffer(const Context& context, MemoryBudget budget, const void* data,
                     std::uint64_t bytes, std::string what, Access access)
    : queue_(context.queue()), budget_(std::move(budget)), what_(std::move(what)) {
  allocate(context, bytes, access, [&] {
    if (bytes > 0) queue_->enqueueWriteBuffer(*handle_, CL_TRUE, 0, bytes, data);
  });
}

RawBuffer::RawBuffer(const Context& context, MemoryBudget budget, std::shared_ptr<const void> owner,
                     const void* data, std::uint64_t bytes, std::string what)
    : queue_(context.queue()),
      owner_(std::move(owner)),
      budget_(std::move(budget)),
      what_(std::move(what)) {
  budget_.reserve(bytes, what_);
  try {
    guarded(fmt::format("sharing {:.1f} MiB for {}", mebibytes(bytes), what_).c_str(), [&] {
      // CL_MEM_READ_ONLY promises that no kernel writes to this memory.
      handle_ = std::make_shared<cl::Buffer>(
          context.handle(), CL_MEM_READ_ONLY | CL_MEM_USE_HOST_PTR, bytes, const_cast<void*>(data));
    });
  } catch (...) {
    budget_.release(bytes);
    throw;
  }
  allocated_ = bytes;
}

void RawBuffer::allocate(const Context& context, std::uint64_t bytes, Access access,
                         const std::function<void()>& fill) {
  const auto size = rounded_up(bytes);
  budget_.reserve(size, what_);
  try {
    const auto doing = fmt::format("allocating {:.1f} MiB for {}", mebibytes(size), what_);
    guarded(doing.c_str(), [&] {
      handle_ = std::make_shared<cl::Buffer>(context.handle(), flags_of(access), size);
      fill();
    });
  } catch (...) {
    budget_.release(size);
    throw;
  }
  allocated_ = size;
}

RawBuffer::RawBuffer(RawBuffer&& other) noexcept
    : queue_(std::move(other.queue_)),
      owner_(std::move(other.owner_)),
      handle_(std::move(other.handle_)),
      budget_(other.budget_),
      what_(std::move(other.what_)),
      allocated_(std::exchange(other.allocated_, 0)) {}

RawBuffer& RawBuffer::operator=(RawBuffer&& other) noexcept {
  if (this == &other) return *this;
  let_go();
  queue_ = std::move(other.queue_);
  owner_ = std::move(other.owner_);
  handle_ = std::move(other.handle_);
  budget_ = other.budget_;
  what_ = std::move(other.what_);
  allocated_ = std::exchange(other.allocated_, 0);
  return *this;
}

RawBuffer::~RawBuffer() {
  let_go();
}

void RawBuffer::let_go() noexcept {
  budget_.release(allocated_);
  // Commands keep a buffer alive, but not the memory that was lent to it.
  if (owner_ && queue_) ::clFinish((*queue_)());
  handle_ = nullptr;
  owner_ = nullptr;
}

void RawBuffer::check_range(std::uint64_t offset, std::uint64_t bytes) const {
  if (offset > allocated_ || bytes > allocated_ - offset) {
    throw Error(ErrorKind::internal, fmt::format("bytes {} + {} are outside the {} bytes of {}",
                                                 offset, bytes, allocated_, what_));
  }
}

void RawBuffer::write(const void* data, std::uint64_t offset, std::uint64_t bytes) {
  check_range(offset, bytes);
  if (bytes == 0) return;
  guarded(fmt::format("copying {} to the device", what_).c_str(),
          [&] { queue_->enqueueWriteBuffer(*handle_, CL_TRUE, offset, bytes, data); });
}

void RawBuffer::read(void* data, std::uint64_t offset, std::uint64_t bytes) const {
  check_range(offset, bytes);
  if (bytes == 0) return;
  guarded(fmt::format("reading {} back from the device", what_).c_str(),
          [&] { queue_->enqueueReadBuffer(*handle_, CL_TRUE, offset, bytes, data); });
}

void RawBuffer::look_at(std::uint64_t offset, std::uint64_t bytes,
                        const std::function<void(const void*)>& look) const {
  check_range(offset, bytes);
  if (bytes == 0) return look(nullptr);
  const auto doing = fmt::format("reading {} from the device", what_);
  void* const data = guarded(doing.c_str(), [&] {
    return queue_->enqueueMapBuffer(*handle_, CL_TRUE, CL_MAP_READ, offset, bytes);
  });
  struct Unmapping {
    const cl::CommandQueue& queue;
    const cl::Buffer& buffer;
    void* data;
    ~Unmapping() { ::clEnqueueUnmapMemObject(queue(), buffer(), data, 0, nullptr, nullptr); }
  } const unmapping{*queue_, *handle_, data};
  look(data);
}

void require_range(std::size_t first, std::size_t count, std::size_t size) {
  if (first > size || count > size - first) {
    throw Error(ErrorKind::internal,
                fmt::format("elements {} + {} are outside a buffer of {}", first, count, size));
  }
}

}  // namespace aerostat::opencl
