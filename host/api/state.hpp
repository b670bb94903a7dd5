#pragma once

#include "aerostat/film.hpp"
#include "aerostat/scene.hpp"
#include "image/film.hpp"
#include "scene/source.hpp"

/// The contents of the public classes.
namespace aerostat {

struct Scene::State {
  scene::SceneSource source;
};

struct Film::State {
  image::Film film;
  scene::Image image;  // settings that turn the film into a picture
};

}  // namespace aerostat
