#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/film.hpp"
#include "image/write.hpp"

/// A large picture in bands of rows, each rendered by itself and kept in an OpenEXR file, and the
/// files of the whole picture that are made from them.
namespace aerostat::image {

/// A band as its file tells it.
struct Band {
  Film film;         // all layers that are in the file
  std::string mark;  // what the picture was made from (image/mark.hpp)
  Development development;
};

/// Returns the bytes of an OpenEXR file of a band, with all that is needed to join it with others.
/// Throws the errors of encode_exr.
std::vector<std::uint8_t> encode_band(const Film& film, const std::string& mark,
                                      const Development& development);

/// Reads the file of a band. Returns nothing if the file is damaged, no OpenEXR file, or no band
/// with all layers.
std::optional<Band> decode_band(std::span<const std::uint8_t> exr);

/// Writes an OpenEXR file in runs of rows from the top to the bottom, so that no more of the
/// picture than one run needs to be in memory. The bytes are those of encode_exr of the whole
/// picture.
class ExrWriter {
 public:
  /// Takes the first run: its layers are those of the file, and its columns those of the picture.
  /// The file has `rows` rows from its first row on. Throws Error{internal} if a layer's length is
  /// wrong.
  ExrWriter(const Film& top, int rows);
  ~ExrWriter();
  ExrWriter(const ExrWriter&) = delete;
  ExrWriter& operator=(const ExrWriter&) = delete;

  /// Adds the next run of rows. Throws Error{internal} if it has other columns or layers, if it
  /// does not begin where the last one ended, or if the encoder fails.
  void add(const Film& rows);

  /// Returns the file. All rows must have been added.
  std::vector<std::uint8_t> take();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aerostat::image
