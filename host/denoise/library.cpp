#include "denoise/library.hpp"

#include <filesystem>
#include <string>

#include <dlfcn.h>
#include <fmt/format.h>

#include "core/environment.hpp"
#include "core/error.hpp"

namespace aerostat::denoise {
namespace {

/// The name under which versions 2.x are installed.
constexpr const char* kFile = "libOpenImageDenoise.so.2";

constexpr const char* kHowToInstall =
    "Open Image Denoise 2 comes with many distributions, from openimagedenoise.org and in the "
    "Python package pyoidn; AEROSTAT_OIDN_DIR names the folder of the library if the system's "
    "loader does not find it";

std::string file_to_load() {
  const auto folder = environment_variable("AEROSTAT_OIDN_DIR");
  return folder ? (std::filesystem::path(*folder) / kFile).string() : kFile;
}

void* open_library() {
  void* const opened = ::dlopen(file_to_load().c_str(), RTLD_NOW | RTLD_LOCAL);
  if (opened != nullptr) return opened;
  const char* const why = ::dlerror();
  throw Error(ErrorKind::no_device,
              fmt::format("denoising: {} cannot be loaded ({}); {}", kFile,
                          why != nullptr ? why : "no reason was given", kHowToInstall));
}

template <typename Function>
void find(void* opened, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(opened, name));
  if (function != nullptr) return;
  throw Error(ErrorKind::no_device,
              fmt::format("denoising: {} has no function {}, expected version 2; {}",
                          file_to_load(), name, kHowToInstall));
}

Library load() {
  void* const opened = open_library();
  Library library;
  find(opened, "oidnNewDevice", library.new_device);
  find(opened, "oidnReleaseDevice", library.release_device);
  find(opened, "oidnSetDeviceBool", library.set_device_bool);
  find(opened, "oidnGetDeviceInt", library.get_device_int);
  find(opened, "oidnGetDeviceError", library.get_device_error);
  find(opened, "oidnCommitDevice", library.commit_device);
  find(opened, "oidnNewFilter", library.new_filter);
  find(opened, "oidnReleaseFilter", library.release_filter);
  find(opened, "oidnSetSharedFilterImage", library.set_shared_filter_image);
  find(opened, "oidnSetFilterBool", library.set_filter_bool);
  find(opened, "oidnSetFilterInt", library.set_filter_int);
  find(opened, "oidnSetFilterProgressMonitorFunction", library.set_filter_progress);
  find(opened, "oidnCommitFilter", library.commit_filter);
  find(opened, "oidnExecuteFilter", library.execute_filter);
  return library;
}

}  // namespace

const Library& library() {
  static const Library loaded = load();
  return loaded;
}

}  // namespace aerostat::denoise
