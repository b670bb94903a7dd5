#include "film/encoding.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "film/frame_files.hpp"
#include "image/write.hpp"

namespace aerostat::film {
Encoding::Encoding(const EncoderOptions& options, const FrameNames& names, std::vector<int> frames)
    : options_(options), names_(names), frames_(std::move(frames)), encoder_(options) {
  thread_ = std::thread([this] {
    try {
      work();
    } catch (...) {
      failure_ = std::current_exception();
    }
  });
}

Encoding::~Encoding() {
  {
    const std::lock_guard lock(mutex_);
    is_given_up_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Encoding::add(int frame) {
  {
    const std::lock_guard lock(mutex_);
    there_.insert(frame);
  }
  changed_.notify_all();
}

bool Encoding::wait_for(int frame) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return is_given_up_ || there_.contains(frame); });
  return !is_given_up_;
}

void Encoding::work() {
  for (const int frame : frames_) {
    if (!wait_for(frame)) return;
    const auto file = names_.name(frame);
    const image::Pixels image = pixels_of(file);
    if (image.width != options_.width || image.height != options_.height) {
      throw Error(ErrorKind::bad_data,
                  fmt::format("'{}': found {} x {} pixels, expected {} x {}", file.string(),
                              image.width, image.height, options_.width, options_.height));
    }
    encoder_.add(image.rgb);
  }
  encoder_.finish();
}

void Encoding::finish() {
  thread_.join();
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace aerostat::film
