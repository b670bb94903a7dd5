#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "aerostat/export.hpp"

namespace aerostat {

/// What is to be rendered: a scene file as a value. It never changes; `with` gives another scene.
/// A scene always is a valid one. It is cheap to copy, and safe to read from any thread. The keys
/// of scene files, with their ranges and defaults, are in the manual's page "The scene file".
class AEROSTAT_API Scene {
 public:
  /// The defaults of the biome snow, seen from outside.
  Scene();

  /// Reads a scene file, JSON with comments. Throws Error{io} if it cannot be read, and
  /// Error{bad_data} with file, JSON pointer, what was found and what was expected.
  static Scene from_file(const std::filesystem::path& path);

  /// The same from text. `name` stands for the file in messages.
  static Scene from_json(const std::string& text, const std::string& name = "scene");

  /// This scene with the value at a JSON pointer replaced: `scene.with("/sun/azimuth_deg", "250")`.
  /// The value is JSON, or else is taken as a string. Throws Error{bad_data} if the result is not a
  /// valid scene, and Error{usage} if the pointer is malformed.
  Scene with(const std::string& pointer, const std::string& value) const;

  /// The scene as JSON with every default filled in.
  std::string to_json() const;

  /// Size of the picture in pixels.
  int width() const;
  int height() const;

  struct AEROSTAT_HIDDEN State;  ///< internal
  const State& state() const { return *state_; }

 private:
  explicit Scene(std::shared_ptr<const State> state);
  std::shared_ptr<const State> state_;
};

}  // namespace aerostat
