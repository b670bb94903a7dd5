#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "aerostat/export.hpp"

namespace aerostat {

/// The description of a picture to render, which holds the contents of a scene file. A scene
/// never changes, and `with` returns another one. A scene is always valid. It is cheap to copy
/// and can be read from any thread. The page "The scene file" of the manual lists the keys of
/// scene files with their ranges and defaults.
class AEROSTAT_API Scene {
 public:
  /// Makes a scene with the defaults of the biome snow, seen from outside.
  Scene();

  /// Reads a scene file, which is JSON with comments. Throws Error{io} if the file cannot be
  /// read. Throws Error{bad_data} if it is not a scene, with the file, the JSON pointer, what was
  /// found and what was expected.
  static Scene from_file(const std::filesystem::path& path);

  /// Reads a scene from a text in the format of scene files. `name` stands for the file in
  /// messages. Throws Error{bad_data} if the text is not a scene.
  static Scene from_json(const std::string& text, const std::string& name = "scene");

  /// Returns this scene with the value at a JSON pointer replaced, for instance
  /// `scene.with("/sun/azimuth_deg", "250")`. The value is taken as JSON if it is valid JSON,
  /// else as a string. Throws Error{bad_data} if the result is not a valid scene, and
  /// Error{usage} if the pointer is malformed.
  Scene with(const std::string& pointer, const std::string& value) const;

  /// Returns the scene as JSON with every default filled in.
  std::string to_json() const;

  /// These functions return the size of the picture in pixels.
  int width() const;
  int height() const;

  struct AEROSTAT_HIDDEN State;  ///< internal
  const State& state() const { return *state_; }

 private:
  explicit Scene(std::shared_ptr<const State> state);
  std::shared_ptr<const State> state_;
};

}  // namespace aerostat
