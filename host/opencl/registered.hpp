#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// OpenCL's loader passes over drivers that it cannot load and does not say so. Here its search is
/// repeated, to tell why. Source: libOpenCL(7) of ocl-icd.
namespace aerostat::opencl {

/// What decides where drivers are registered; unset and empty variables are nullopt.
struct VendorEnvironment {
  std::optional<std::string> ocl_icd_vendors;
  std::optional<std::string> opencl_vendor_path;
  std::filesystem::path system_folder = "/etc/OpenCL/vendors";

  static VendorEnvironment of_process();
};

struct RegisteredDriver {
  std::string library;              // as dlopen takes it; empty if the file names none
  std::filesystem::path file = {};  // that names it; empty: OCL_ICD_VENDORS itself does
};

/// The drivers that the loader would try to load.
std::vector<RegisteredDriver> registered_drivers(const VendorEnvironment& environment);

/// What keeps registered drivers from being used, in words.
struct DriverProblems {
  std::vector<std::string> texts;
  bool lack_memory = false;  // one of them could not be loaded for want of memory
};

/// Loads what is not loaded yet, and lets it go again. `some_are_usable`: there are platforms,
/// which are taken to be those of the drivers that are loaded.
DriverProblems problems_of(const std::vector<RegisteredDriver>& drivers, bool some_are_usable);

/// Whether words of dlopen or of an exception speak of too little memory.
bool speaks_of_memory(const std::string& reason);

}  // namespace aerostat::opencl
