#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "asset/model.hpp"
#include "core/last_made.hpp"
#include "core/math.hpp"
#include "scene/placed_model.hpp"
#include "world/group.hpp"

namespace aerostat::scene {
struct Scene;
}

/// The models from files that a scene places.
namespace aerostat::world {

/// What decides on the content of a model.
struct ModelKey {
  std::filesystem::path file;
  scene::UpAxis up = scene::UpAxis::y;

  auto operator<=>(const ModelKey&) const = default;
};

/// A model that was read from a file, with all that it is put together of moved to its place. Its
/// foot, which is the lowest point in the middle of its box, is the origin.
struct FileModel {
  ModelKey key;
  /// One object for each material that is used. Object::file_material is an index into
  /// `materials`.
  std::shared_ptr<const Objects> parts;
  std::vector<asset::Material> materials;  // at least one
  std::vector<asset::Texture> textures;
  dvec3 size{0.0};  // of the box around it, in the file's units
  /// The corners in plan of what lies lowest: a house's walls, or a tree's trunk.
  dvec2 base_least{0.0}, base_most{0.0};
  std::uint64_t triangles = 0;
  std::vector<std::string> notes;  // sentences of the reader
};

/// Returns a model as it was read, in one piece for each material. Throws Error{bad_data} if it has
/// no triangles.
FileModel file_model(const ModelKey& key, asset::Model model);

/// All models that a scene places.
struct SceneModels {
  /// The models, each once, in the order in which the scene names them first.
  std::vector<std::shared_ptr<const FileModel>> models;
  /// The models that are envelopes of special shapes, one for each of scene::balloons_of(), null
  /// for a usual envelope. They are not among `models`, and their materials have no numbers.
  std::vector<std::shared_ptr<const FileModel>> envelopes;
  /// The index in `models` of each of Scene::objects.
  std::vector<std::size_t> of_object;
  /// The index in `models` of each species of plants from files.
  std::vector<std::size_t> of_species;
  /// The number of the first material of each model among those of all models.
  std::vector<std::uint32_t> first_material;
  std::uint32_t material_count = 0;

  const FileModel& model_of(std::size_t object) const { return *models[of_object[object]]; }
};

/// Keeps the models of the scenes of a session or a command, so that each file is read once. It may
/// be used from any thread.
class ModelCache {
 public:
  /// Returns the models of a scene. Files that the last scene did not name are read, and the user
  /// is told their sizes and what the reader has to say. Throws Error{bad_data} if the models have
  /// more materials than kernels know, and the errors of asset::read().
  std::shared_ptr<const SceneModels> models_of(const scene::Scene& scene);

  /// Returns how many files were read.
  int files_read() const;

 private:
  /// The files of a scene: those of its objects, of its species of plants, and of the envelopes of
  /// its balloons, which are empty for usual ones.
  struct Keys {
    std::vector<ModelKey> objects, species, envelopes;

    bool operator==(const Keys&) const = default;
  };

  std::shared_ptr<const SceneModels> make(const Keys& keys);
  std::shared_ptr<const FileModel> model(const ModelKey& key);
  void tell(const scene::Scene& scene, const SceneModels& models);

  LastMade<Keys, SceneModels> last_;
  /// Guards what follows.
  mutable std::mutex mutex_;
  std::shared_ptr<const SceneModels> held_;
  std::map<ModelKey, std::weak_ptr<const FileModel>> known_;
  std::set<std::string> told_;
  int files_read_ = 0;
};

/// Returns the metres for each unit of a file at which a model is placed.
double scale_of(const scene::PlacedModel& placed, const FileModel& model);

/// Returns a sentence about the size of a model as placed, such as "church.glb: 12.0 x 31.5 x
/// 24.0 m, 5,204 triangles.", and what mends it if the size makes no sense.
std::string size_note(const scene::PlacedModel& placed, const FileModel& model);

}  // namespace aerostat::world
