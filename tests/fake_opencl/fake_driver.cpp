// An OpenCL driver for tests. It is PoCL, but the calls of a program go through this library, which
// makes some of them fail. The loader of OpenCL finds it by OCL_ICD_VENDORS. Environment variables
// say what it does:
//
//   FAKE_CL_DRIVER   the driver that works, by default libpocl.so.2
//   FAKE_CL_FAULTS   a list of faults with commas between them, each FUNCTION[@TEXT]:FIRST[+]:WHAT.
//                    The call with the number FIRST fails, or with + all from it on. If FIRST is
//                    the path of a file, all calls fail from the moment when that file exists.
//                    Only calls count whose kernel or device has TEXT in its name; the devices of
//                    the platform are also called device0, device1 and so on. WHAT is a status of
//                    OpenCL such as -5, hang, which never returns, or skip, which does nothing and
//                    tells of success.
//   FAKE_CL_COUNTS   a file that receives the number of calls of each function, as numbers of 8
//                    bytes in the order of functions.hpp. It holds them even if the program is
//                    killed.
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#define CL_TARGET_OPENCL_VERSION 300
#define CL_USE_DEPRECATED_OPENCL_1_2_APIS
#include <CL/cl_icd.h>

#include "functions.hpp"

namespace {

using aerostat::test::kFakedFunctions;

[[noreturn]] void give_up(const std::string& why) {
  std::fprintf(stderr, "fake OpenCL driver: %s\n", why.c_str());
  std::_Exit(99);
}

enum class What { status, hang, skip };

struct Fault {
  std::size_t function = 0;
  std::string text;
  std::uint64_t first = 1;
  bool goes_on = false;
  std::string path;  // if not empty, it stands in place of `first` and `goes_on`
  What what = What::status;
  cl_int status = 0;
  std::atomic<std::uint64_t> calls = 0;
};

std::size_t index_of(std::string_view function) {
  for (std::size_t i = 0; i < kFakedFunctions.size(); ++i) {
    if (function == kFakedFunctions[i]) return i;
  }
  give_up("there is no function " + std::string(function));
}

/// All that the library knows. It is never destroyed, because drivers are called until the end.
struct State {
  cl_icd_dispatch real{};
  std::vector<Fault*> faults;
  std::atomic<std::uint64_t>* counts = nullptr;
};

State& state() {
  static auto& one = *new State;
  return one;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == at) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Fault* parse_fault(const std::string& text) {
  const auto parts = split(text, ':');
  if (parts.size() != 3 || parts[1].empty()) give_up("'" + text + "' is no fault");
  auto* fault = new Fault;
  const auto at = parts[0].find('@');
  fault->function = index_of(parts[0].substr(0, at));
  if (at != std::string::npos) fault->text = parts[0].substr(at + 1);
  fault->first = std::strtoull(parts[1].c_str(), nullptr, 10);
  fault->goes_on = parts[1].back() == '+';
  if (parts[1].front() == '/') fault->path = parts[1];
  fault->what = parts[2] == "hang" ? What::hang : parts[2] == "skip" ? What::skip : What::status;
  fault->status = static_cast<cl_int>(std::strtol(parts[2].c_str(), nullptr, 10));
  return fault;
}

std::atomic<std::uint64_t>* open_counts(const char* path) {
  constexpr std::size_t kBytes = kFakedFunctions.size() * sizeof(std::uint64_t);
  const int file = ::open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0 || ::ftruncate(file, kBytes) != 0) give_up("the counts cannot be written");
  void* const memory = ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  if (memory == MAP_FAILED) give_up("the counts cannot be mapped");
  return static_cast<std::atomic<std::uint64_t>*>(memory);
}

/// Returns a text of a driver's object, such as the name of a kernel.
template <typename Get, typename Object, typename Key>
std::string text_of(Get get, Object object, Key key) {
  std::array<char, 256> name{};
  if (get(object, key, name.size() - 1, name.data(), nullptr) != CL_SUCCESS) return {};
  return name.data();
}

/// Returns "device0", "device1" and so on, by the order in which the platform has its devices.
std::string number_of(cl_device_id device) {
  cl_platform_id platform = nullptr;
  std::array<cl_device_id, 16> all{};
  cl_uint count = 0;
  const cl_icd_dispatch& real = state().real;
  real.clGetDeviceInfo(device, CL_DEVICE_PLATFORM, sizeof(platform), &platform, nullptr);
  real.clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, all.size(), all.data(), &count);
  for (std::size_t i = 0; i < all.size() && i < count; ++i) {
    if (all[i] == device) return "device" + std::to_string(i);
  }
  return "part";
}

std::string name_of(cl_device_id device) {
  return text_of(state().real.clGetDeviceInfo, device, CL_DEVICE_NAME) + " " + number_of(device);
}
std::string name_of(cl_kernel kernel) {
  return text_of(state().real.clGetKernelInfo, kernel, CL_KERNEL_FUNCTION_NAME);
}
std::string name_of(cl_command_queue queue) {
  cl_device_id device = nullptr;
  state().real.clGetCommandQueueInfo(queue, CL_QUEUE_DEVICE, sizeof(device), &device, nullptr);
  return name_of(device);
}
template <typename T>
std::string name_of(T) {
  return {};
}

/// Returns the fault of this call, or null if it works. `names` tells what the call is about.
template <typename Names>
const Fault* fault_of(std::size_t function, Names&& names) {
  State& all = state();
  if (all.counts != nullptr) ++all.counts[function];
  for (Fault* fault : all.faults) {
    if (fault->function != function) continue;
    if (!fault->text.empty() && names().find(fault->text) == std::string::npos) continue;
    if (!fault->path.empty()) {
      if (::access(fault->path.c_str(), F_OK) == 0) return fault;
      continue;
    }
    const std::uint64_t number = ++fault->calls;
    if (number == fault->first || (fault->goes_on && number > fault->first)) return fault;
  }
  return nullptr;
}

template <std::size_t I, auto Member, typename F>
struct Wrapped;

/// Stands in front of one function of the driver.
template <std::size_t I, auto Member, typename R, typename... Arguments>
struct Wrapped<I, Member, R(CL_API_CALL*)(Arguments...)> {
  static R CL_API_CALL call(Arguments... arguments) {
    const Fault* const fault =
        fault_of(I, [&] { return (std::string() + ... + (name_of(arguments) + " ")); });
    if (fault == nullptr) return (state().real.*Member)(arguments...);
    if (fault->what == What::hang) {
      for (;;) ::pause();
    }
    const auto all = std::tie(arguments...);
    using Last = std::tuple_element_t<sizeof...(Arguments) - 1, std::tuple<Arguments...>>;
    if constexpr (std::is_same_v<R, cl_int>) {
      if (fault->what == What::status) return fault->status;
      if constexpr (std::is_same_v<Last, cl_event*>) return skip(all);
      return CL_SUCCESS;
    } else {
      if constexpr (std::is_same_v<Last, cl_int*>) {
        cl_int* const status = std::get<sizeof...(Arguments) - 1>(all);
        if (status != nullptr) *status = fault->status;
      }
      return nullptr;
    }
  }

 private:
  /// Enqueues a marker in place of a command.
  template <typename Tuple>
  static cl_int skip(const Tuple& all) {
    if constexpr (std::is_same_v<std::tuple_element_t<0, std::tuple<Arguments...>>,
                                 cl_command_queue>) {
      return state().real.clEnqueueMarkerWithWaitList(std::get<0>(all), 0, nullptr,
                                                      std::get<sizeof...(Arguments) - 1>(all));
    }
    return CL_SUCCESS;
  }
};

template <std::size_t I, auto Member>
void wrap(cl_icd_dispatch& table) {
  using F = std::remove_reference_t<decltype(table.*Member)>;
  table.*Member = &Wrapped<I, Member, F>::call;
}

/// Puts this library in front of the driver's functions. All objects of the driver point to one
/// table of functions, which is changed in its place.
void take_over(cl_icd_dispatch& table) {
  state().real = table;
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto first = reinterpret_cast<std::uintptr_t>(&table) / page * page;
  const auto end = reinterpret_cast<std::uintptr_t>(&table + 1);
  if (::mprotect(reinterpret_cast<void*>(first), end - first, PROT_READ | PROT_WRITE) != 0) {
    give_up("the driver's table of functions cannot be changed");
  }
  std::size_t next = 0;
#define AEROSTAT_WRAP(function)                                         \
  wrap<__COUNTER__ - kFirstCounter, &cl_icd_dispatch::function>(table); \
  ++next;
  constexpr std::size_t kFirstCounter = __COUNTER__ + 1;
  AEROSTAT_FAKED_FUNCTIONS(AEROSTAT_WRAP)
#undef AEROSTAT_WRAP
  if (next != kFakedFunctions.size()) give_up("a function is missing");
}

using GetPlatforms = cl_int (*)(cl_uint, cl_platform_id*, cl_uint*);
using GetFunction = void* (*)(const char*);

void* driver() {
  static void* const library = [] {
    const char* const name = std::getenv("FAKE_CL_DRIVER");
    void* const opened = ::dlopen(name != nullptr ? name : "libpocl.so.2", RTLD_NOW | RTLD_LOCAL);
    if (opened == nullptr) give_up(::dlerror());
    return opened;
  }();
  return library;
}

GetFunction real_get_function() {
  return reinterpret_cast<GetFunction>(::dlsym(driver(), "clGetExtensionFunctionAddress"));
}

cl_int get_platforms(cl_uint count, cl_platform_id* platforms, cl_uint* found) {
  static const auto real =
      reinterpret_cast<GetPlatforms>(real_get_function()("clIcdGetPlatformIDsKHR"));
  static const bool is_ready = [] {
    if (const char* const faults = std::getenv("FAKE_CL_FAULTS"); faults != nullptr) {
      for (const std::string& fault : split(faults, ',')) {
        if (!fault.empty()) state().faults.push_back(parse_fault(fault));
      }
    }
    if (const char* const counts = std::getenv("FAKE_CL_COUNTS")) {
      state().counts = open_counts(counts);
    }
    cl_platform_id platform = nullptr;
    if (real(1, &platform, nullptr) != CL_SUCCESS) give_up("the driver has no platform");
    take_over(**reinterpret_cast<cl_icd_dispatch**>(platform));
    return true;
  }();
  static_cast<void>(is_ready);
  return real(count, platforms, found);
}

}  // namespace

#define AEROSTAT_FAKE_API extern "C" __attribute__((visibility("default")))

AEROSTAT_FAKE_API cl_int clIcdGetPlatformIDsKHR(cl_uint count, cl_platform_id* platforms,
                                                cl_uint* found) {
  return get_platforms(count, platforms, found);
}

AEROSTAT_FAKE_API cl_int clGetPlatformInfo(cl_platform_id platform, cl_platform_info key,
                                           std::size_t bytes, void* value, std::size_t* size) {
  return (*reinterpret_cast<cl_icd_dispatch**>(platform))
      ->clGetPlatformInfo(platform, key, bytes, value, size);
}

AEROSTAT_FAKE_API void* clGetExtensionFunctionAddress(const char* name) {
  if (std::string_view(name) == "clIcdGetPlatformIDsKHR") {
    return reinterpret_cast<void*>(&clIcdGetPlatformIDsKHR);
  }
  if (std::string_view(name) == "clGetPlatformInfo") {
    return reinterpret_cast<void*>(&clGetPlatformInfo);
  }
  return real_get_function()(name);
}
