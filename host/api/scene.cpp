#include "aerostat/scene.hpp"

#include "api/state.hpp"
#include "core/log.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "staging/stage.hpp"

namespace aerostat {

namespace {

/// Returns the scene with what it leaves open on real land chosen.
scene::SceneSource staged(const scene::SceneSource& source) {
  terrain::ReliefCache reliefs;
  const staging::Staged result = staging::stage(source, reliefs);
  for (const std::string& note : result.notes) warn(note);
  return result.source;
}

}  // namespace

Scene::Scene() : state_(std::make_shared<State>()) {}
Scene::Scene(std::shared_ptr<const State> state) : state_(std::move(state)) {}

Scene Scene::from_file(const std::filesystem::path& path) {
  return Scene(std::make_shared<State>(State{staged(scene::SceneSource::from_file(path))}));
}

Scene Scene::from_json(const std::string& text, const std::string& name) {
  return Scene(std::make_shared<State>(State{staged(scene::SceneSource::from_text(text, name))}));
}

Scene Scene::with(const std::string& pointer, const std::string& value) const {
  return Scene(std::make_shared<State>(State{state_->source.with({{pointer, value}})}));
}

std::string Scene::to_json() const {
  return scene::write_text(state_->source.scene());
}

int Scene::width() const {
  return state_->source.scene().image.width;
}

int Scene::height() const {
  return state_->source.scene().image.height;
}

}  // namespace aerostat
