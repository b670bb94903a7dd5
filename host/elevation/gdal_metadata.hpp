#pragma once

#include <optional>
#include <string>

namespace aerostat::elevation {

/// The metadata of the first band, which GDAL writes as XML.
struct GdalMetadata {
  std::optional<double> scale, offset;
  std::string unit;           // as written, for example "m"; empty if not said
  bool signed_bytes = false;  // samples of 8 bits are int8
  bool thematic = false;      // the samples are classes
};

/// Reads the text of the tag GDAL_METADATA. What it does not understand, it passes over.
GdalMetadata gdal_metadata_of(const std::string& xml);

}  // namespace aerostat::elevation
