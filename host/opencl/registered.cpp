#include "opencl/registered.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

#include <dlfcn.h>
#include <fmt/format.h>

#include "core/environment.hpp"

namespace aerostat::opencl {
namespace {

namespace fs = std::filesystem;

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

RegisteredDriver read_icd(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  line.erase(line.find_last_not_of(" \t\r\n") + 1);
  return {line, file};
}

std::vector<RegisteredDriver> drivers_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entries(folder, error), end; !error && entries != end;
       entries.increment(error)) {
    if (entries->path().extension() == ".icd") files.push_back(entries->path());
  }
  std::sort(files.begin(), files.end());
  std::vector<RegisteredDriver> drivers;
  for (const fs::path& file : files) drivers.push_back(read_icd(file));
  return drivers;
}

/// Returns why a driver cannot be used, or nothing if it can. The loader keeps libraries loaded
/// even if they are useless, so a loaded library need not be a usable driver.
std::optional<std::string> obstacle(const RegisteredDriver& driver, bool some_are_usable) {
  std::error_code ignored;
  if (driver.library.empty()) {
    return fs::is_regular_file(driver.file, ignored) ? "the file names no library"
                                                     : "the file cannot be read";
  }
  void* library = dlopen(driver.library.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  const bool was_loaded = library != nullptr;
  if (!was_loaded) library = dlopen(driver.library.c_str(), RTLD_LAZY);
  if (library == nullptr) {
    const char* const reason = dlerror();
    return fmt::format("it cannot be loaded: {}", reason != nullptr ? reason : "unknown reason");
  }
  const bool is_driver = dlsym(library, "clGetExtensionFunctionAddress") != nullptr;
  dlclose(library);
  if (!is_driver) return "it is not an OpenCL driver";
  if (was_loaded && some_are_usable) return std::nullopt;
  return "it can be loaded, but offers no platform";
}

}  // namespace

VendorEnvironment VendorEnvironment::of_process() {
  return {environment_variable("OCL_ICD_VENDORS"), environment_variable("OPENCL_VENDOR_PATH")};
}

std::vector<RegisteredDriver> registered_drivers(const VendorEnvironment& environment) {
  const fs::path usual = environment.opencl_vendor_path ? fs::path(*environment.opencl_vendor_path)
                                                        : environment.system_folder;
  if (!environment.ocl_icd_vendors) return drivers_in(usual);
  const fs::path given = *environment.ocl_icd_vendors;
  if (is_folder(given)) return drivers_in(given);
  if (given.extension() != ".icd") return {{given.string()}};
  std::error_code ignored;
  const bool is_in_usual = !given.has_parent_path() && fs::exists(usual / given, ignored);
  return {read_icd(is_in_usual ? usual / given : given)};
}

DriverProblems problems_of(const std::vector<RegisteredDriver>& drivers, bool some_are_usable) {
  DriverProblems problems;
  for (const RegisteredDriver& driver : drivers) {
    const auto reason = obstacle(driver, some_are_usable);
    if (!reason) continue;
    const std::string by = driver.file.empty() ? "OCL_ICD_VENDORS" : driver.file.string();
    const std::string library = driver.library.empty() ? "" : " " + driver.library;
    problems.texts.push_back(
        fmt::format("the driver{}, which {} registers: {}", library, by, *reason));
    problems.lack_memory = problems.lack_memory || speaks_of_memory(*reason);
  }
  return problems;
}

bool speaks_of_memory(const std::string& reason) {
  const auto has = [&](const char* words) { return reason.find(words) != std::string::npos; };
  return has("annot allocate memory") || has("failed to map segment") ||
         has("cannot map zero-fill") || has("annot create shared object descriptor") ||
         has("bad_alloc") || has("ut of memory");
}

}  // namespace aerostat::opencl
