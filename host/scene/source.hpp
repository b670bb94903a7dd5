#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/io.hpp"

namespace aerostat::scene {

/// The contents of a scene file in a form that can be edited. A source is a value: it never
/// changes, and an edit gives a new source. It always describes a valid scene. It is cheap to
/// copy and can be used from any thread.
class SceneSource {
 public:
  /// Makes a source without any values, so that the defaults of the first biome hold.
  SceneSource();

  /// These functions read a source as read_file and read_text read a scene, and throw the same
  /// errors.
  static SceneSource from_file(const std::filesystem::path& path);
  static SceneSource from_text(const std::string& text, const std::string& name);

  /// Returns the scene with every default filled in. It is not resolved.
  const Scene& scene() const;

  /// Returns this source with the changes made in their order, as "--set" makes them. Throws
  /// Error{bad_data} with the JSON pointer if the result is not a scene, and Error{usage} on a
  /// bad pointer.
  SceneSource with(const std::vector<Override>& changes) const;

  /// Returns this source without the values at these pointers, so that their defaults hold again.
  /// An element of an array gets its default value. An object in a list loses the value but stays
  /// in the list. Throws the errors that `with` throws.
  SceneSource without(const std::vector<std::string>& pointers) const;

  /// Returns the given or default value at a pointer as JSON text, or an empty text if there is
  /// none. The two angles of the sun have values however its direction was given.
  std::string value(const std::string& pointer) const;

  /// Returns whether the source itself gives the value at a pointer or a part of it.
  bool gives(const std::string& pointer) const;

  /// Returns whether the value at a pointer differs from the default of the biome, view and
  /// quality.
  bool differs(const std::string& pointer) const;

  /// Returns the text of a scene file that holds only what differs from the defaults, in the
  /// usual order and with a line end. Reading the text gives the same scene. Comments are lost.
  std::string text() const;

  /// Returns the same text for a file in `folder`: files there or below it are named from it. All
  /// other files keep their absolute paths.
  std::string text_in(const std::filesystem::path& folder) const;

  /// Returns the absolute paths of the files that `text_in` cannot name from the folder.
  std::vector<std::string> files_outside(const std::filesystem::path& folder) const;

  /// Returns the changes that turn `base` into this source. Returns nothing if "--set" cannot
  /// make them, because a value without a default was removed.
  std::optional<std::vector<Override>> changes_from(const SceneSource& base) const;

 private:
  struct State;
  explicit SceneSource(std::shared_ptr<const State> state) : state_(std::move(state)) {}

  std::shared_ptr<const State> state_;
};

}  // namespace aerostat::scene
