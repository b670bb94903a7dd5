#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aerostat::elevation {

/// What lies beside a file under the same name with another ending.
struct SideFiles {
  std::string prj;                             // of .prj; empty if there is none
  std::string hdr;                             // of .hdr
  std::string aux_wkt;                         // the system that .aux.xml names; empty if none
  std::optional<std::array<double, 6>> world;  // of a world file, in its order A, D, B, E, C, F
};

/// Reads what lies beside a file. Only regular files of at most 64 KiB count.
SideFiles side_files_of(const std::filesystem::path& path);

/// Returns a text for geo::crs_info from that of a .prj file: WKT as it is, and the older form of
/// ARC/INFO for degrees and UTM. Returns an empty text and adds a note for any other text.
std::string crs_of_prj(const std::string& prj, std::vector<std::string>& notes);

/// Returns the six numbers of a world file, or nothing if the text is none.
std::optional<std::array<double, 6>> world_of(const std::string& text);

}  // namespace aerostat::elevation
