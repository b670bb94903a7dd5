#include "cli/sandbox.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "cli/parse.hpp"
#include "core/confine.hpp"
#include "core/environment.hpp"
#include "core/error.hpp"
#include "opencl/cache.hpp"
#include "scene/installed.hpp"

namespace aerostat::cli {
namespace {

namespace fs = std::filesystem;

using Paths = std::vector<fs::path>;

constexpr const char* kStandardOutput = "-";

void add(Paths& paths, const Paths& more) {
  paths.insert(paths.end(), more.begin(), more.end());
}

/// Returns the folder of a file, or the nearest folder above it that exists.
fs::path folder_of(const fs::path& file) {
  std::error_code code;
  fs::path folder = fs::absolute(file, code).parent_path();
  while (!fs::is_directory(folder, code) && folder != folder.parent_path()) {
    folder = folder.parent_path();
  }
  return folder;
}

/// Returns what a scene may read: its folder, or that of elevation data, and the installed scenes.
Paths of_scene(const fs::path& given) {
  std::error_code code;
  Paths paths{scene::installed_folder()};
  if (is_standard(given) || given.empty()) {
    add(paths, {fs::current_path(code), "/dev/stdin"});
    return paths;
  }
  const fs::path scene = scene::find_scene(given);
  paths.push_back(fs::is_directory(scene, code) ? scene : folder_of(scene));
  // A scene may be a link. What it names lies beside the link.
  const fs::path target = fs::canonical(scene, code);
  if (!code) paths.push_back(target);
  return paths;
}

/// Returns the folders of a program that an environment variable names.
Paths of_program(const char* variable) {
  const auto name = environment_variable(variable);
  if (!name) return {};
  std::error_code code;
  const fs::path program = fs::canonical(*name, code);
  if (code) return {};
  const fs::path prefix = program.parent_path().parent_path();
  return {program, prefix / "lib", prefix / "share"};
}

/// Returns what drivers, compilers and the programs that aerostat starts read.
Paths of_system() {
  Paths paths = system_folders();
  add(paths, {"/opt",
              "/usr/libexec",
              "/usr/include",
              "/etc/OpenCL",
              "/etc/fonts",
              "/etc/gdal",
              "/etc/localtime",
              "/etc/alternatives",
              "/var/cache/fontconfig",
              "/sys",
              "/proc/self",
              "/proc/cpuinfo",
              "/proc/meminfo",
              "/proc/stat",
              "/proc/filesystems",
              "/proc/sys/kernel",
              "/proc/sys/vm",
              "/proc/driver/nvidia",
              "/dev/urandom",
              "/dev/random",
              "/dev/zero"});
  for (const char* name : {"LD_LIBRARY_PATH", "OCL_ICD_VENDORS", "AEROSTAT_KERNEL_DIR", "GDAL_DATA",
                           "PROJ_DATA", "PROJ_LIB"}) {
    add(paths, folders_in_variable(name));
  }
  for (const char* name : {"AEROSTAT_FFMPEG", "AEROSTAT_GDAL_TRANSLATE", "AEROSTAT_RSVG_CONVERT"}) {
    add(paths, of_program(name));
  }
  std::error_code code;
  const fs::path own = fs::read_symlink("/proc/self/exe", code);
  if (!code) add(paths, {own, own.parent_path().parent_path() / "share" / "aerostat"});
  return paths;
}

/// Makes the folders of compiled kernels and of temporary files. Returns them with those in which
/// other drivers keep what they compile.
Paths of_kernels() {
  const std::string problem = opencl::ensure_pocl_cache();
  Paths paths;
  if (problem.empty()) paths.emplace_back(environment_variable("POCL_CACHE_DIR").value_or(""));
  if (const auto pocl = opencl::preferred_cache_path(opencl::CacheEnvironment::of_process())) {
    const fs::path folder = pocl->parent_path();
    const fs::path temporary = folder / "temporary";
    if (!opencl::make_private_folder(temporary)) {
      ::setenv("TMPDIR", temporary.c_str(), 1);
      paths.push_back(folder);
    }
    paths.push_back(folder.parent_path() / "mesa_shader_cache");
    paths.push_back(folder.parent_path() / "mesa_shader_cache_db");
  }
  if (const auto home = environment_variable("HOME")) {
    paths.push_back(fs::path(*home) / ".nv" / "ComputeCache");
  }
  return paths;
}

/// Returns the devices of drivers. A driver that finds none of its own does no harm.
Paths of_devices() {
  Paths paths{"/dev/null", "/dev/full", "/dev/shm", "/dev/dri", "/dev/kfd"};
  std::error_code code;
  for (const auto& entry : fs::directory_iterator("/dev", code)) {
    if (entry.path().filename().string().starts_with("nvidia")) paths.push_back(entry.path());
  }
  return paths;
}

/// Returns where an output goes. Without a name it goes to the current folder.
fs::path folder_of_output(const fs::path& output) {
  if (is_standard(output)) return "/dev/stdout";
  return folder_of(output.empty() ? "picture" : output);
}

void confine(const SceneOptions& options, const Paths& inputs, const Paths& outputs) {
  if (!options.sandbox) return;
  ReachableFiles reachable{of_system(), of_devices()};
  add(reachable.readable, of_scene(options.scene));
  add(reachable.readable, inputs);
  add(reachable.writable, of_kernels());
  for (const fs::path& output : outputs) reachable.writable.push_back(folder_of_output(output));
  if (!can_rename_confined() || !refuse_connections() || !confine_this_thread(reachable)) {
    throw Error(ErrorKind::usage,
                "--sandbox: this system cannot confine a program; Linux 5.19 with Landlock and "
                "seccomp is needed");
  }
}

}  // namespace

void enter_sandbox(const RenderOptions& options) {
  Paths outputs{options.output};
  if (!options.checkpoint.empty()) outputs.push_back(options.checkpoint);
  if (!options.labels_json.empty()) outputs.push_back(options.labels_json);
  confine(options.input, {options.labels}, outputs);
}

void enter_sandbox(const ContactSheetOptions& options) {
  confine(options.input, {}, {options.output});
}

void enter_sandbox(const FilmOptions& options) {
  confine(options.input, {}, {options.output});
}

void enter_sandbox(const CheckOptions& options) {
  confine(options.input, {options.land}, {kStandardOutput});
}

void enter_sandbox(const DumpOptions& options) {
  confine(options.input, {}, {kStandardOutput});
}

void enter_sandbox(const ExportOptions& options) {
  confine(options.input, {}, {options.output});
}

void enter_sandbox(const ArtworkOptions& options) {
  confine(options.input, {}, {options.output});
}

}  // namespace aerostat::cli
