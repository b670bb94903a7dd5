// A stand-in for Open Image Denoise with the same C functions. It "denoises" by a sum that shows
// which layers it was given: the colour plus 10 times the albedo plus 100 times the normal. The
// environment variable FAKE_OIDN makes it fail.
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

namespace {

struct Image {
  float* pixels = nullptr;
  std::size_t width = 0, height = 0;
};

/// The device and the filter. There is one of each.
struct State {
  int error = 0;
  std::string message;
  bool device_committed = false, filter_committed = false, hdr = false, affinity = true;
  int memory_mb = 0;
  std::map<std::string, Image> images;
  bool (*progress)(void*, double) = nullptr;
  void* user = nullptr;
};

State state;

bool is_asked(const char* what) {
  const char* value = std::getenv("FAKE_OIDN");
  return value != nullptr && std::strcmp(value, what) == 0;
}

void fail(int error, const char* message) {
  if (state.error != 0) return;
  state.error = error;
  state.message = message;
}

bool is_ready() {
  const Image output = state.images["output"];
  for (const char* name : {"color", "albedo", "normal", "output"}) {
    const Image& image = state.images[name];
    if (image.pixels == nullptr || image.width != output.width || image.height != output.height) {
      return false;
    }
  }
  return state.device_committed && state.filter_committed && state.hdr && !state.affinity &&
         state.memory_mb >= 256;
}

}  // namespace

extern "C" {

void* oidnNewDevice(int type) {
  state = {};
  if (type != 1) fail(5, "only a CPU was expected");
  return &state;
}

void oidnReleaseDevice(void*) {}

void oidnSetDeviceBool(void*, const char* name, bool value) {
  if (std::strcmp(name, "setAffinity") == 0) state.affinity = value;
}

int oidnGetDeviceInt(void*, const char* name) {
  if (std::strcmp(name, "version") != 0 || !state.device_committed) return -1;
  return is_asked("old") ? 10403 : 20501;
}

int oidnGetDeviceError(void*, const char** message) {
  *message = state.message.c_str();
  const int error = state.error;
  state.error = 0;
  return error;
}

void oidnCommitDevice(void*) {
  state.device_committed = true;
  if (is_asked("unsupported")) fail(5, "this processor is too old");
}

void* oidnNewFilter(void*, const char* type) {
  if (std::strcmp(type, "RT") != 0) fail(2, "unknown filter");
  return &state;
}

void oidnReleaseFilter(void*) {}

void oidnSetSharedFilterImage(void*, const char* name, void* pixels, int format, std::size_t width,
                              std::size_t height, std::size_t, std::size_t, std::size_t) {
  if (format != 3) fail(2, "three floats a pixel were expected");
  state.images[name] = {static_cast<float*>(pixels), width, height};
}

void oidnSetFilterBool(void*, const char* name, bool value) {
  if (std::strcmp(name, "hdr") == 0) state.hdr = value;
}

void oidnSetFilterInt(void*, const char* name, int value) {
  if (std::strcmp(name, "maxMemoryMB") == 0) state.memory_mb = value;
}

void oidnSetFilterProgressMonitorFunction(void*, bool (*progress)(void*, double), void* user) {
  state.progress = progress;
  state.user = user;
}

void oidnCommitFilter(void*) {
  state.filter_committed = true;
}

void oidnExecuteFilter(void*) {
  if (is_asked("memory")) return fail(4, "no memory for the weights");
  if (!is_ready()) return fail(3, "something was not set");
  for (const double share : {0.0, 0.5, 1.0}) {
    if (state.progress != nullptr && !state.progress(state.user, share)) {
      return fail(6, "execution was cancelled");
    }
  }
  const Image output = state.images["output"];
  for (std::size_t i = 0; i < 3 * output.width * output.height; ++i) {
    output.pixels[i] = state.images["color"].pixels[i] + 10.0f * state.images["albedo"].pixels[i] +
                       100.0f * state.images["normal"].pixels[i];
  }
}

}  // extern "C"
