#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/io.hpp"

namespace aerostat::scene {

/// What a scene file says, as something that can be edited. A value: it never changes, an edit
/// gives another one. It always makes a scene that is right. Cheap to copy; safe from any thread.
class SceneSource {
 public:
  /// A scene that says nothing: the first biome's defaults.
  SceneSource();

  /// As read_file and read_text, with their errors.
  static SceneSource from_file(const std::filesystem::path& path);
  static SceneSource from_text(const std::string& text, const std::string& name);

  /// With every default filled in, not resolved.
  const Scene& scene() const;

  /// This source with the changes made, in their order, as "--set" makes them. Throws
  /// Error{bad_data} with the JSON pointer if that is no scene, Error{usage} on a bad pointer.
  SceneSource with(const std::vector<Override>& changes) const;

  /// This source without what it says at these pointers, so that their defaults count again; an
  /// array's element gets its default's; what an object of a list says goes, the object stays.
  /// Errors as of `with`.
  SceneSource without(const std::vector<std::string>& pointers) const;

  /// The value that counts at a pointer, given or by default, as JSON text; empty if there is none.
  /// The sun has its two angles whatever way it was given.
  std::string value(const std::string& pointer) const;

  /// Whether that value is another one than the default of the biome, view and quality.
  bool differs(const std::string& pointer) const;

  /// The scene file: what differs from the defaults and nothing else, in the usual order, with a
  /// line end. Reading it gives the same scene. Comments are lost.
  std::string text() const;

  /// The changes that make this of `base`; nothing if "--set" cannot make them, because a value
  /// without default was taken away.
  std::optional<std::vector<Override>> changes_from(const SceneSource& base) const;

 private:
  struct State;
  explicit SceneSource(std::shared_ptr<const State> state) : state_(std::move(state)) {}

  std::shared_ptr<const State> state_;
};

}  // namespace aerostat::scene
