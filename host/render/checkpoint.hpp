#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/film_sums.hpp"

/// Files that hold the sums of a render that is not finished. Such a file begins with a line that
/// names the format. Its head says what the render is, and head and sums each have a checksum.
namespace aerostat::render {

/// A property of a render, such as its size, with words for messages.
struct Trait {
  std::string name, value;

  bool operator==(const Trait&) const = default;
};

/// All that the bits of a picture depend on. Checkpoints of a render with other traits are refused.
using Traits = std::vector<Trait>;

/// The most bytes of the head of a checkpoint. The traits and the waiting rows of the largest
/// picture take less.
inline constexpr std::uint32_t kMostHeadBytes = 1u << 20;

/// Writes a checkpoint whole or not at all. Throws Error{io} as write_file does, and Error{usage}
/// if the traits are too long.
void write_checkpoint(const std::filesystem::path& path, const Traits& traits,
                      const FilmSums& sums);

/// Reads a checkpoint, or returns nothing if there is no file. The traits must be those of the
/// render, and the sums must fit its window. Throws Error{io} if the file cannot be read, and
/// Error{bad_data} if it is no checkpoint, is damaged, or belongs to another render. The message
/// names the file, the first trait that differs, what was found and what was expected. Nothing is
/// allocated before the size of the file is known to be right.
std::optional<FilmSums> read_checkpoint(const std::filesystem::path& path, const Traits& traits,
                                        const Crop& window, int samples, bool with_guides);

/// Reads a checkpoint from the bytes of a file, as read_checkpoint does. `name` stands for the file
/// in messages.
FilmSums parse_checkpoint(std::span<const std::uint8_t> bytes, const std::string& name,
                          const Traits& traits, const Crop& window, int samples, bool with_guides);

}  // namespace aerostat::render
