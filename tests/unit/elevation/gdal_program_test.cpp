// Formats that only the programs of GDAL read.
#include "elevation/gdal_program.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/child_process.hpp"
#include "core/confine.hpp"
#include "elevation/gdal_variables.hpp"
#include "elevation/open.hpp"
#include "files.hpp"
#include "tiff_files.hpp"

namespace aerostat::elevation {
namespace {

bool has_gdal() {
  return std::system("gdal_translate --version >/dev/null 2>&1") == 0;
}
#define SKIP_WITHOUT_GDAL() \
  if (!has_gdal()) GTEST_SKIP() << "gdal_translate is not installed; the package gdal-bin has it"

/// Sets a variable of the environment until the end of the test.
class Setting {
 public:
  Setting(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Setting() {
    if (before_) {
      setenv(name_, before_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

/// Writes files of the classic form of netCDF. All its numbers are big-endian.
class NetCdf {
 public:
  void number(std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
  }
  void text(const std::string& word) {
    number(static_cast<std::uint32_t>(word.size()));
    bytes += word;
    while (bytes.size() % 4 != 0) bytes += '\0';
  }
  void real(double value) {
    const std::vector<std::uint8_t> stored = sample_bytes(value, 64, 3);
    bytes.append(stored.rbegin(), stored.rend());
  }
  std::string bytes;
};

struct Variable {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<double> values;  // of two dimensions, or of one for coordinates
};

/// Returns a file with variables of 3 rows by 4 columns from 46 N, 9 E; rows run to the north.
std::string net_cdf(std::vector<Variable> variables) {
  variables.insert(
      variables.begin(),
      {{"lat", {{"units", "degrees_north"}, {"standard_name", "latitude"}}, {46.0, 46.25, 46.5}},
       {"lon",
        {{"units", "degrees_east"}, {"standard_name", "longitude"}},
        {9.0, 9.25, 9.5, 9.75}}});
  // The first pass finds out how long the header is, the second one writes where the values are.
  std::string header, data;
  for (int pass = 0; pass < 2; ++pass) {
    NetCdf file;
    const std::size_t start = header.size();
    file.bytes = "CDF\x01";
    file.number(0);
    for (const std::uint32_t value : {0x0Au, 2u}) file.number(value);
    file.text("lat");
    file.number(3);
    file.text("lon");
    file.number(4);
    for (const std::uint32_t value : {0u, 0u, 0x0Bu}) file.number(value);
    file.number(static_cast<std::uint32_t>(variables.size()));
    NetCdf values;
    for (const Variable& variable : variables) {
      file.text(variable.name);
      const bool is_plane = variable.values.size() == 12;
      file.number(is_plane ? 2 : 1);
      if (is_plane) file.number(0);
      file.number(variable.name == "lat" ? 0 : 1);
      file.number(0x0C);
      file.number(static_cast<std::uint32_t>(variable.attributes.size()));
      for (const auto& [name, value] : variable.attributes) {
        file.text(name);
        file.number(2);  // characters
        file.text(value);
      }
      file.number(6);  // double
      file.number(static_cast<std::uint32_t>(8 * variable.values.size()));
      file.number(static_cast<std::uint32_t>(start + values.bytes.size()));
      for (const double value : variable.values) values.real(value);
    }
    header = file.bytes;
    data = values.bytes;
  }
  return header + data;
}

std::vector<double> plane(double first) {
  std::vector<double> values;
  for (int i = 0; i < 12; ++i) values.push_back(first + i);
  return values;
}

TEST(GdalProgram, SaysWhatToInstall) {
  const Setting program("AEROSTAT_GDAL_TRANSLATE", "/nonexistent/gdal_translate");
  const Folder folder;
  const auto path = folder.write("a.nc", net_cdf({{"z", {}, plane(0.0)}}));
  const std::string message = refusal_of([&] { open(path); });
  EXPECT_TRUE(says(message, "a.nc: this is a netCDF file"));
  EXPECT_TRUE(says(message, "gdal-bin"));
  EXPECT_TRUE(says(message, "AEROSTAT_GDAL_TRANSLATE"));
}

TEST(GdalProgram, ReadsNetCdf) {
  SKIP_WITHOUT_GDAL();
  const Folder folder;
  const auto path = folder.write(
      "a \"b\".nc",
      net_cdf({{"mask", {}, plane(0.0)}, {"elevation", {{"units", "m"}}, plane(100.0)}}));
  const auto raster = open(path);
  const RasterInfo& info = raster->info();
  EXPECT_EQ(info.format, "netCDF by GDAL");
  EXPECT_EQ(info.path, path);
  EXPECT_EQ(info.width, 4);
  EXPECT_EQ(info.height, 3);
  // Rows run from the north.
  EXPECT_EQ(height_at(*raster, 0, 0), 108.0f);
  EXPECT_EQ(height_at(*raster, 3, 2), 103.0f);
  EXPECT_NEAR(centre_of(*raster, 0, 0).x, 9.0, 1e-9);
  EXPECT_NEAR(centre_of(*raster, 0, 0).y, 46.5, 1e-9);
  EXPECT_TRUE(has_note(*raster, "Of 2 variables, elevation is taken as heights."));
  EXPECT_FALSE(has_note(*raster, "no unit"));
}

TEST(GdalProgram, TakesTheVariableThatIsAskedFor) {
  SKIP_WITHOUT_GDAL();
  const Folder folder;
  const auto path =
      folder.write("a.nc", net_cdf({{"mask", {}, plane(0.0)}, {"snow", {}, plane(50.0)}}));
  const std::string message = refusal_of([&] { open(path); });
  EXPECT_TRUE(says(message, "it has mask, snow"));
  EXPECT_TRUE(says(message, "/terrain/variable"));
  OpenOptions options;
  options.variable = "SNOW";
  EXPECT_EQ(height_at(*open(path, options), 0, 2), 50.0f);
  options.variable = "x\":/etc/passwd";
  EXPECT_TRUE(says(refusal_of([&] { open(path, options); }), "it has no variable"));
}

TEST(GdalProgram, TurnsDepthsIntoHeights) {
  SKIP_WITHOUT_GDAL();
  const Folder folder;
  const auto path = folder.write(
      "a.nc", net_cdf({{"depth", {{"positive", "down"}, {"units", "m"}}, plane(10.0)}}));
  const auto raster = open(path);
  EXPECT_EQ(height_at(*raster, 0, 2), -10.0f);
  EXPECT_TRUE(has_note(*raster, "counts downwards"));
}

TEST(GdalProgram, LeavesNothingBehind) {
  SKIP_WITHOUT_GDAL();
  const Folder folder, temporary;
  const Setting place("TMPDIR", temporary.path().string());
  const auto path = folder.write("a.nc", net_cdf({{"z", {}, plane(0.0)}}));
  EXPECT_EQ(height_at(*open(path), 0, 2), 0.0f);
  const auto bad = folder.write("b.nc", net_cdf({{"z", {}, plane(0.0)}}).substr(0, 60));
  EXPECT_TRUE(says(refusal_of([&] { open(bad); }), "gdalinfo cannot read this netCDF file"));
  EXPECT_TRUE(std::filesystem::is_empty(temporary.path()));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

TEST(GdalProgram, IsRunWithoutNetworkSideFilesAndOtherDrivers) {
  const Folder folder;
  // This script takes the place of gdalinfo and gdal_translate, and reports every setting that is
  // wrong.
  const std::string program =
      "#!/bin/sh\n"
      "expect() { [ \"$1\" = \"$2\" ] || printf '%s for %s, ' \"$1\" \"$2\"; }\n"
      "expect \"$GDAL_PAM_ENABLED\" NO\n"
      "expect \"$GDAL_DISABLE_READDIR_ON_OPEN\" EMPTY_DIR\n"
      "expect \"$CPL_VSIL_CURL_ALLOWED_FILENAME\" nothing\n"
      "expect \"$PROJ_NETWORK\" OFF\n"
      "expect \"${GDAL_SKIP%% *}\" VRT\n"
      "expect \"$AEROSTAT_SECRET\" ''\n"
      "expect \"$2 $3\" '-if HFA'\n"
      "expect \"${13##*/}\" output.tif\n"
      "expect \"$(ulimit -v)\" 4194304\n"
      "echo that is all\nexit 3\n";
  for (const char* name : {"gdal_translate", "gdalinfo"}) {
    std::filesystem::permissions(folder.write(name, program), std::filesystem::perms::owner_all);
  }
  const Setting chosen("AEROSTAT_GDAL_TRANSLATE", (folder.path() / "gdal_translate").string());
  const Setting secret("AEROSTAT_SECRET", "secret");
  const auto path = folder.write("a.img", "EHFA_HEADER_TAG, and so on");
  EXPECT_TRUE(says(refusal_of([&] { open(path); }),
                   "gdal_translate cannot read this ERDAS IMAGINE file (that is all)"));
}

TEST(GdalProgram, ReachesNoOtherFile) {
  const Folder folder, elsewhere;
  const auto secret = elsewhere.write("secret", "secret");
  std::filesystem::permissions(
      folder.write("gdal_translate",
                   "#!/bin/sh\ncat " + secret.string() + " 2>/dev/null || echo nothing; exit 3\n"),
      std::filesystem::perms::owner_all);
  const Setting chosen("AEROSTAT_GDAL_TRANSLATE", (folder.path() / "gdal_translate").string());
  const auto path = folder.write("a.img", "EHFA_HEADER_TAG, and so on");
  bool can_confine = false;
  std::thread([&] { can_confine = confine_this_thread({}); }).join();
  if (!can_confine) GTEST_SKIP() << "this system has no Landlock";
  EXPECT_TRUE(says(refusal_of([&] { open(path); }), "(nothing)"));
  // This process itself still reaches it.
  EXPECT_EQ(std::filesystem::file_size(secret), 6u);
  EXPECT_TRUE(std::ifstream(secret).good());
}

TEST(GdalVariables, AreChosenByTheirNames) {
  const std::string printed =
      "Subdatasets:\n  SUBDATASET_1_NAME=NETCDF:\"/t/input\":mask\n  SUBDATASET_1_DESC=[2x2] mask\n"
      "  SUBDATASET_2_NAME=HDF5:\"/t/input\"://land/DEM\n"
      "  SUBDATASET_3_NAME=NETCDF:\"/t/input\":a;b$(c)\n  SUBDATASET_4_NAME=nothing\n";
  const std::vector<std::string> names = variables_in(printed);
  EXPECT_EQ(names, (std::vector<std::string>{"mask", "//land/DEM"}));
  EXPECT_EQ(variable_of_heights(names, ""), "//land/DEM");
  EXPECT_EQ(variable_of_heights(names, "mask"), "mask");
  EXPECT_EQ(variable_of_heights(names, "dem"), "//land/DEM");
  EXPECT_EQ(variable_of_heights(names, "nothing"), "");
  EXPECT_EQ(variable_of_heights({"a", "b"}, ""), "");
  EXPECT_EQ(variable_of_heights({"a"}, ""), "a");
  EXPECT_EQ(variable_of_heights({"height", "Band1", "z"}, ""), "z");
  EXPECT_TRUE(counts_downwards("Band 1\n    positive=down\n"));
  EXPECT_FALSE(counts_downwards("  depth#positive=down\n"));
}

TEST(ChildProcess, IsStoppedAtItsLimits) {
  ChildLimits limits;
  limits.waiting_s = 1;
  const ChildResult sleeping = run_limited({"/bin/sh", "-c", "exec sleep 100"}, {}, limits);
  EXPECT_TRUE(sleeping.took_too_long);
  EXPECT_EQ(sleeping.status, 128 + 9);
  const ChildResult echo =
      run_limited({"/bin/sh", "-c", "echo \"$A $1\"; cat; exit 7", "x", "a b; c"}, {"A=1"}, limits);
  EXPECT_EQ(echo.status, 7);
  EXPECT_EQ(echo.output, "1 a b; c\n");
  EXPECT_EQ(run_limited({"/nonexistent"}, {}, limits).status, 127);
  const Folder folder;
  limits.file_bytes = 4096;
  run_limited({"/bin/sh", "-c", "head -c 100000 /dev/zero >\"$0\"", (folder.path() / "a").string()},
              {"PATH=/usr/bin:/bin"}, limits);
  EXPECT_EQ(std::filesystem::file_size(folder.path() / "a"), 4096u);
}

}  // namespace
}  // namespace aerostat::elevation
