#include "denoise/denoise.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/memory_left.hpp"
#include "denoise/library.hpp"

namespace aerostat::denoise {
namespace {

constexpr int kMajorVersion = 2;

/// The library may use one part in so many of the memory that the layers leave free. It divides
/// large pictures into tiles that fit. Chosen by eye.
constexpr std::uint64_t kShareOfMemory = 2;
/// The least memory with which the library can work, and the most that it gets. Chosen by eye.
constexpr std::uint64_t kLeastBytes = 256ull << 20, kMostBytes = 4096ull << 20;

using Device = std::unique_ptr<DeviceHandle, void (*)(DeviceHandle*)>;
using Filter = std::unique_ptr<FilterHandle, void (*)(FilterHandle*)>;

/// Throws the error that the library has for the calling thread, if there is one.
void throw_error(const Library& library, DeviceHandle* device, const char* what) {
  const char* message = nullptr;
  const int error = library.get_device_error(device, &message);
  if (error == kNoError) return;
  const ErrorKind kind = error == kOutOfMemory ? ErrorKind::exhausted
                         : error == kCancelled ? ErrorKind::interrupted
                                               : ErrorKind::internal;
  throw Error(kind, fmt::format("denoising: Open Image Denoise failed to {}: {} (error {})", what,
                                message != nullptr ? message : "no message", error));
}

void require_version(const Library& library, DeviceHandle* device) {
  const int version = library.get_device_int(device, "version");
  if (version / 10000 == kMajorVersion) return;
  throw Error(ErrorKind::no_device,
              fmt::format("denoising: found version {}.{}.{} of Open Image Denoise, expected {}.x",
                          version / 10000, version / 100 % 100, version % 100, kMajorVersion));
}

/// Returns a device that computes on the cores of the host, where the film is.
Device make_device(const Library& library) {
  Device device(library.new_device(kCpuDevice), library.release_device);
  throw_error(library, device.get(), "make a device");
  // Threads that are bound to cores would stay so for what the process does next.
  library.set_device_bool(device.get(), "setAffinity", false);
  library.commit_device(device.get());
  throw_error(library, device.get(), "make a device");
  require_version(library, device.get());
  return device;
}

void require_layers(const image::Film& film) {
  const std::size_t pixels = film.radiance.size();
  if (pixels > 0 && film.albedo.size() == pixels && film.normal_ws.size() == pixels) return;
  throw Error(ErrorKind::internal,
              fmt::format("denoising: found {} radiances, {} albedos and {} normals, expected as "
                          "many of each",
                          pixels, film.albedo.size(), film.normal_ws.size()));
}

/// Returns the bytes that the library may take. Throws Error{exhausted} if they are too few for a
/// picture of `pixels` pixels.
std::uint64_t memory_for(std::size_t pixels) {
  const MemoryLeft left = memory_left();
  const std::uint64_t output = pixels * sizeof(vec3);
  if (left.bytes < output + kLeastBytes) {
    throw Error(ErrorKind::exhausted,
                fmt::format("denoising {} pixels needs {} MiB of memory, and {} leaves {} MiB",
                            pixels, (output + kLeastBytes) >> 20, left.bound, left.bytes >> 20));
  }
  return std::clamp((left.bytes - output) / kShareOfMemory, kLeastBytes, kMostBytes);
}

/// Tells the library whether to go on.
bool watch_progress(void* user, double share) {
  const auto& options = *static_cast<const Options*>(user);
  if (options.progress) options.progress(share);
  return !options.stop.stop_requested();
}

void set_image(const Library& library, FilterHandle* filter, const char* name,
               const image::Film& film, const Array<vec3>& layer) {
  // The library writes to the image "output" alone.
  void* const pixels = const_cast<vec3*>(layer.data());
  library.set_shared_filter_image(filter, name, pixels, kFloat3,
                                  static_cast<std::size_t>(film.width),
                                  static_cast<std::size_t>(film.height), 0, 0, 0);
}

}  // namespace

void require_library() {
  make_device(library());
}

void denoise(image::Film& film, const Options& options) {
  require_layers(film);
  const Library& oidn = library();
  const Device device = make_device(oidn);
  const std::uint64_t memory = memory_for(film.radiance.size());
  Array<vec3> output(film.radiance.size());
  const Filter filter(oidn.new_filter(device.get(), "RT"), oidn.release_filter);
  throw_error(oidn, device.get(), "make a filter");
  set_image(oidn, filter.get(), "color", film, film.radiance);
  set_image(oidn, filter.get(), "albedo", film, film.albedo);
  set_image(oidn, filter.get(), "normal", film, film.normal_ws);
  set_image(oidn, filter.get(), "output", film, output);
  oidn.set_filter_bool(filter.get(), "hdr", true);
  oidn.set_filter_int(filter.get(), "maxMemoryMB", static_cast<int>(memory >> 20));
  Options watched = options;
  oidn.set_filter_progress(filter.get(), watch_progress, &watched);
  oidn.commit_filter(filter.get());
  throw_error(oidn, device.get(), "prepare the filter");
  oidn.execute_filter(filter.get());
  throw_error(oidn, device.get(), "filter the picture");
  film.radiance = std::move(output);
}

}  // namespace aerostat::denoise
