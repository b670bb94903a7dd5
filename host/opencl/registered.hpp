#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Explains why registered drivers cannot be used. OpenCL's loader silently passes over drivers
/// that it cannot load, so its search is repeated here. Source: libOpenCL(7) of ocl-icd.
namespace aerostat::opencl {

/// The variables and the folder that decide where drivers are registered. Unset and empty variables
/// are nullopt.
struct VendorEnvironment {
  std::optional<std::string> ocl_icd_vendors;
  std::optional<std::string> opencl_vendor_path;
  std::filesystem::path system_folder = "/etc/OpenCL/vendors";

  static VendorEnvironment of_process();
};

struct RegisteredDriver {
  /// The library as dlopen takes it, or an empty string if the file names none.
  std::string library;
  /// The file that names the library. It is empty if OCL_ICD_VENDORS itself names it.
  std::filesystem::path file = {};
};

/// Returns the drivers that the loader would try to load.
std::vector<RegisteredDriver> registered_drivers(const VendorEnvironment& environment);

/// Descriptions of why registered drivers cannot be used.
struct DriverProblems {
  std::vector<std::string> texts;
  /// Tells whether one of the drivers could not be loaded because memory was short.
  bool lack_memory = false;
};

/// Returns the problems of `drivers`. Loads each library that is not loaded yet, and closes it
/// again. `some_are_usable` tells whether there are platforms. These are taken to belong to the
/// drivers that are loaded.
DriverProblems problems_of(const std::vector<RegisteredDriver>& drivers, bool some_are_usable);

/// Returns whether a message of dlopen or of an exception reports too little memory.
bool speaks_of_memory(const std::string& reason);

}  // namespace aerostat::opencl
