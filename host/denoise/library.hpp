#pragma once

#include <cstddef>

/// The part of the C interface of Open Image Denoise 2 that aerostat calls. Its header is not used,
/// so that aerostat is built without the library.
namespace aerostat::denoise {

struct DeviceHandle;
struct FilterHandle;

using ProgressFunction = bool (*)(void* user, double share);

// Values of the library's enumerations.
inline constexpr int kCpuDevice = 1;
inline constexpr int kFloat3 = 3;
inline constexpr int kNoError = 0;
inline constexpr int kOutOfMemory = 4;
inline constexpr int kCancelled = 6;

/// The functions of the library, which stays loaded until the process ends.
struct Library {
  DeviceHandle* (*new_device)(int type) = nullptr;
  void (*release_device)(DeviceHandle*) = nullptr;
  void (*set_device_bool)(DeviceHandle*, const char* name, bool value) = nullptr;
  int (*get_device_int)(DeviceHandle*, const char* name) = nullptr;
  int (*get_device_error)(DeviceHandle*, const char** message) = nullptr;
  void (*commit_device)(DeviceHandle*) = nullptr;
  FilterHandle* (*new_filter)(DeviceHandle*, const char* type) = nullptr;
  void (*release_filter)(FilterHandle*) = nullptr;
  void (*set_shared_filter_image)(FilterHandle*, const char* name, void* pixels, int format,
                                  std::size_t width, std::size_t height, std::size_t byte_offset,
                                  std::size_t pixel_stride, std::size_t row_stride) = nullptr;
  void (*set_filter_bool)(FilterHandle*, const char* name, bool value) = nullptr;
  void (*set_filter_int)(FilterHandle*, const char* name, int value) = nullptr;
  void (*set_filter_progress)(FilterHandle*, ProgressFunction, void* user) = nullptr;
  void (*commit_filter)(FilterHandle*) = nullptr;
  void (*execute_filter)(FilterHandle*) = nullptr;
};

/// Returns the library. It is loaded at the first call, from the folder in AEROSTAT_OIDN_DIR if
/// that is set, or else from where the system's loader looks. Throws Error{no_device} if it is
/// missing or lacks a function.
const Library& library();

}  // namespace aerostat::denoise
