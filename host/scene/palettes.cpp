#include "scene/palettes.hpp"

namespace aerostat::scene {

std::vector<vec3> palette_colors(Palette palette) {
  switch (palette) {
    case Palette::ember:
      return {{0.62f, 0.03f, 0.03f}, {0.80f, 0.36f, 0.02f}, {0.82f, 0.66f, 0.06f}};
    case Palette::lagoon:
      return {{0.78f, 0.05f, 0.08f},
              {0.85f, 0.60f, 0.04f},
              {0.02f, 0.30f, 0.42f},
              {0.80f, 0.78f, 0.70f}};
    case Palette::spectrum:
      return {{0.05f, 0.09f, 0.40f}, {0.03f, 0.38f, 0.50f}, {0.82f, 0.80f, 0.72f},
              {0.84f, 0.55f, 0.05f}, {0.75f, 0.16f, 0.03f}, {0.42f, 0.02f, 0.06f}};
    case Palette::glacier:
      return {{0.02f, 0.07f, 0.26f}, {0.06f, 0.28f, 0.60f}, {0.82f, 0.84f, 0.85f}};
    case Palette::orchard:
      return {{0.05f, 0.22f, 0.04f},
              {0.36f, 0.52f, 0.05f},
              {0.84f, 0.72f, 0.20f},
              {0.66f, 0.06f, 0.03f}};
    case Palette::plum:
      return {{0.16f, 0.02f, 0.20f},
              {0.55f, 0.03f, 0.22f},
              {0.84f, 0.42f, 0.10f},
              {0.86f, 0.76f, 0.52f}};
    case Palette::regatta:
      return {{0.015f, 0.03f, 0.14f}, {0.82f, 0.81f, 0.77f}, {0.62f, 0.02f, 0.03f}};
    case Palette::meadow:
      return {{0.03f, 0.32f, 0.34f},
              {0.82f, 0.68f, 0.08f},
              {0.83f, 0.82f, 0.76f},
              {0.74f, 0.13f, 0.26f}};
  }
  return {vec3(0.5f)};
}

Palette palette_of_place(std::size_t i) {
  constexpr Palette kOrder[] = {Palette::glacier, Palette::plum,    Palette::meadow,
                                Palette::ember,   Palette::regatta, Palette::orchard,
                                Palette::lagoon,  Palette::spectrum};
  return kOrder[i % std::size(kOrder)];
}

void dress(Balloon& balloon, Palette palette) {
  balloon.palette = palette;
  balloon.colors = palette_colors(palette);
}

}  // namespace aerostat::scene
