#pragma once

#include "aerostat/film.hpp"
#include "aerostat/scene.hpp"
#include "image/film.hpp"
#include "scene/source.hpp"

/// What the public classes hold.
namespace aerostat {

struct Scene::State {
  scene::SceneSource source;
};

struct Film::State {
  image::Film film;
  scene::Image image;  // how the scene wants it developed
};

}  // namespace aerostat
