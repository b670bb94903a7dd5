#include "elevation/gdal_program.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "core/child_process.hpp"
#include "core/environment.hpp"
#include "core/error.hpp"
#include "elevation/gdal_variables.hpp"
#include "elevation/geotiff.hpp"
#include "elevation/reading.hpp"
#include "elevation/tiff_handle.hpp"

namespace aerostat::elevation {
namespace {

using std::filesystem::path;

/// A format that GDAL reads, and the bytes with which its files begin.
struct Kind {
  const char* name;
  std::string_view start;
  const char* driver;
  /// The driver for a single variable of a file that has several, or null.
  const char* variable_driver;
  const char* ending = "";
};
constexpr std::array kKinds{
    Kind{"netCDF", "CDF\x01", "netCDF", "netCDF", ".nc"},
    Kind{"netCDF", "CDF\x02", "netCDF", "netCDF", ".nc"},
    Kind{"netCDF", "CDF\x05", "netCDF", "netCDF", ".nc"},
    Kind{"netCDF", "\x89HDF\r\n\x1a\n", "netCDF", "netCDF", ".nc"},
    Kind{"HDF4", "\x0e\x03\x13\x01", "HDF4", "HDF4Image"},
    Kind{"ERDAS IMAGINE", "EHFA_HEADER_TAG", "HFA", nullptr},
    Kind{"GRIB", "GRIB", "GRIB", nullptr},
    Kind{"Surfer grid", "DSAA", "GSAG", nullptr},
    Kind{"Surfer grid", "DSBB", "GSBG", nullptr},
    Kind{"Surfer grid", "DSRB", "GS7BG", nullptr},
    Kind{"Terragen", "TERRAGENTERRAIN", "Terragen", nullptr},
    Kind{"VTP binary terrain", "binterr", "BT", nullptr},
    Kind{"PCIDSK", "PCIDSK", "PCIDSK", nullptr},
    Kind{"JPEG 2000", std::string_view("\0\0\0\x0cjP  ", 8), "JP2OpenJPEG", nullptr}};

/// Returns the kind of a file. Of HDF5, the name tells which of several conventions it follows.
std::optional<Kind> kind_of(std::span<const std::uint8_t> head, const path& file) {
  for (Kind kind : kKinds) {
    if (head.size() < kind.start.size() ||
        !std::equal(kind.start.begin(), kind.start.end(), head.begin(),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; })) {
      continue;
    }
    if (kind.start[0] != '\x89') return kind;
    const std::string ending = ending_of(file);
    if (ending == ".bag") return Kind{"BAG", "", "BAG", nullptr, ".bag"};
    if (ending == ".h5" || ending == ".hdf5" || ending == ".he5") {
      return Kind{"HDF5", "", "HDF5", "HDF5Image", ".h5"};
    }
    return kind;
  }
  return std::nullopt;
}

/// Returns the environment of GDAL: no network, no files beside the one that it is given, and only
/// drivers that open no other files.
std::vector<std::string> environment_of(const path& folder) {
  std::vector<std::string> all{
      "PATH=/usr/bin:/bin",
      "LC_ALL=C",
      "HOME=" + folder.string(),
      "TMPDIR=" + folder.string(),
      "CPL_TMPDIR=" + folder.string(),
      "GDAL_PAM_ENABLED=NO",
      "GDAL_DISABLE_READDIR_ON_OPEN=EMPTY_DIR",
      "CPL_VSIL_CURL_ALLOWED_FILENAME=nothing",
      "GDAL_SKIP=VRT DERIVED HTTP WMS WCS WMTS MEM MRF MBTiles PDF Rasterlite KMLSUPEROVERLAY "
      "STACTA STACIT PLMOSAIC PLSCENES EEDAI DAAS NGW OGCAPI PostGISRaster GPKG",
      "GDAL_CONFIG_FILE=",
      "GDAL_VRT_ENABLE_PYTHON=NO",
      "GDAL_CACHEMAX=128",
      "GDAL_NUM_THREADS=1",
      "PROJ_NETWORK=OFF",
      "HDF5_EXTFILE_PREFIX=" + folder.string(),
      "HDF5_EXT_PREFIX=" + folder.string()};
  // Where an installation outside the system's folders keeps its parts.
  for (const char* name : {"GDAL_DATA", "PROJ_DATA", "PROJ_LIB", "LD_LIBRARY_PATH"}) {
    if (const auto value = environment_variable(name)) all.push_back(name + ("=" + *value));
  }
  return all;
}

/// Returns the files that GDAL needs for a file, so that a file which names others cannot show
/// them.
ReachableFiles files_for(const path& file, const path& program, const path& folder) {
  ReachableFiles files = files_of_program(program, folder, {"GDAL_DATA", "PROJ_DATA", "PROJ_LIB"});
  files.readable.insert(files.readable.end(), {"/etc/gdal", file});
  return files;
}

/// The work on one file.
class Conversion {
 public:
  Conversion(path file, Kind kind, path translate)
      : file_(std::move(file)), kind_(kind), translate_(std::move(translate)) {
    // A name without anything that GDAL could take for its own syntax stands for the file.
    std::error_code code;
    whole_ = std::filesystem::canonical(file_, code);
    if (!code) std::filesystem::create_symlink(whole_, input(), code);
    if (code) refuse(file_, "it cannot be handed to GDAL: " + code.message());
  }

  /// Converts the file. Returns the GeoTIFF file, which goes away with this object.
  path convert(const OpenOptions& options);

  std::vector<std::string> notes;
  bool is_depth = false;

 private:
  /// The drivers for HDF5 want names that end as usual.
  path input() const { return folder_.path() / (std::string("input") + kind_.ending); }
  std::string run(const path& program, std::vector<std::string> arguments) const;
  std::string choose(const std::string& about, const OpenOptions& options);

  path file_;
  path whole_;  // without symbolic links
  Kind kind_;
  path translate_;
  PrivateFolder folder_;
};

/// Runs a program of GDAL and returns what it prints. Throws Error{bad_data} with its complaint.
std::string Conversion::run(const path& program, std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), program.string());
  ChildLimits limits;
  limits.files = files_for(whole_, program, folder_.path());
  const ChildResult result = run_limited(arguments, environment_of(folder_.path()), limits);
  if (result.status == 0 && !result.took_too_long) return result.output;
  const std::string name = program.filename().string();
  if (result.took_too_long) refuse(file_, fmt::format("{} took too long and was stopped", name));
  refuse(file_,
         fmt::format("{} cannot read this {} file ({})", name, kind_.name, complaint_of(result)));
}

/// Returns the name by which GDAL's programs open the raster of heights, which is that of the file
/// or of a part of it, and sets the driver that reads it.
std::string Conversion::choose(const std::string& about, const OpenOptions& options) {
  const std::vector<std::string> variables = variables_in(about);
  if (kind_.variable_driver == nullptr || variables.empty()) return input().string();
  const std::string variable = variable_of_heights(variables, options.variable);
  if (variable.empty()) {
    std::vector<std::string> names;
    for (const std::string& name : variables) {
      if (names.size() < 30) names.push_back(last_part(name));
    }
    refuse(file_, fmt::format("{}; it has {}. Set /terrain/variable to the one with heights",
                              options.variable.empty()
                                  ? std::string("none of its variables has a usual name of heights")
                                  : fmt::format("it has no variable \"{}\"", options.variable),
                              fmt::join(names, ", ")));
  }
  notes.push_back(fmt::format("Of {} variables, {} is taken as heights.", variables.size(),
                              last_part(variable)));
  const std::string prefix = kind_.driver == std::string_view("netCDF") ? "NETCDF" : kind_.driver;
  kind_.driver = kind_.variable_driver;
  return fmt::format("{}:\"{}\":{}", prefix, input().string(), variable);
}

path Conversion::convert(const OpenOptions& options) {
  path info = translate_;
  info.replace_filename("gdalinfo");
  std::string source = input().string();
  if (kind_.variable_driver != nullptr) {
    if (!is_program(info)) {
      refuse(file_, fmt::format("the program gdalinfo is missing beside {}", translate_.string()));
    }
    source = choose(run(info, {"-if", kind_.driver, "-norat", "-noct", source}), options);
    const std::string about = run(info, {"-if", kind_.driver, "-norat", "-noct", source});
    is_depth = counts_downwards(about);
  }
  path output = folder_.path() / "output.tif";
  run(translate_, {"-q", "-if", kind_.driver, "-of", "GTiff", "-b", "1", "-co", "TILED=YES", "-co",
                   "BIGTIFF=IF_SAFER", source, output.string()});
  return output;
}

bool is_for_gdal(std::span<const std::uint8_t> head, const path& file) {
  return kind_of(head, file).has_value();
}

std::unique_ptr<Raster> open_by_gdal(const path& file, const OpenOptions& options) {
  std::vector<std::uint8_t> head(16);
  const OpenFile whole(file, file);
  head.resize(whole.read(0, head.data(), head.size()));
  const std::optional<Kind> kind = kind_of(head, file);
  if (!kind) refuse(file, "the file changed while it was opened");
  const path translate = find_program("gdal_translate", "AEROSTAT_GDAL_TRANSLATE");
  if (translate.empty()) {
    refuse(file, fmt::format("this is a {} file, which only the program gdal_translate of GDAL "
                             "reads, and it was not found. Install it (on Debian and Ubuntu, the "
                             "package gdal-bin), or set AEROSTAT_GDAL_TRANSLATE to its path",
                             kind->name));
  }
  Conversion conversion(file, *kind, translate);
  const path converted = conversion.convert(options);
  if (conversion.is_depth) {
    conversion.notes.emplace_back(
        "The variable counts downwards, so its values are taken as depths below 0.");
  }
  return open_geotiff_for(
      converted,
      {file, fmt::format("{} by GDAL", kind->name), conversion.is_depth, conversion.notes},
      options);
}

}  // namespace

const Format kGdalFormat{"formats of GDAL", is_for_gdal, open_by_gdal};

}  // namespace aerostat::elevation
