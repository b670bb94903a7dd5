#include "artwork/check.hpp"

#include <cstddef>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "artwork/picture.hpp"
#include "core/error.hpp"
#include "scene/scene.hpp"

namespace aerostat::artwork {
namespace {

/// The size at which drawings are tried out.
constexpr DrawingSize kTrial{256, 256, true};

}  // namespace

std::vector<std::string> check_pictures(const scene::Scene& scene) {
  std::set<std::string> known;
  std::vector<std::string> sentences;
  const auto check = [&](const scene::Balloon& balloon, const std::string& pointer) {
    if (!balloon.enabled) return;
    for (std::size_t i = 0; i < balloon.artwork.size(); ++i) {
      const std::string& file = balloon.artwork[i].file;
      if (!known.insert(file).second) continue;
      try {
        const Picture picture = read_picture(file, kTrial);
        const std::string name = std::filesystem::path(file).filename().string();
        const std::string size =
            picture.is_drawing
                ? std::string("a drawing")
                : fmt::format("{} x {} pixels", picture.texture.width, picture.texture.height);
        sentences.push_back(fmt::format("{}: {}.", name, size));
        for (const std::string& note : picture.notes) {
          sentences.push_back(fmt::format("{}: {}", name, note));
        }
      } catch (const Error& error) {
        throw Error(error.kind(), fmt::format("{}/artwork/{}: {}", pointer, i, error.what()));
      }
    }
  };
  check(scene.balloon, "/balloon");
  for (std::size_t i = 0; i < scene.balloons.size(); ++i) {
    check(scene.balloons[i], fmt::format("/balloons/{}", i));
  }
  return sentences;
}

}  // namespace aerostat::artwork
