#include "asset/mtl.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "asset/reading.hpp"
#include "asset/words.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

/// An option of a map and the most values that it takes. Those of `-s`, `-o` and `-t` may be fewer.
struct MapOption {
  std::string_view name;
  int values;
};

constexpr std::array<MapOption, 14> kMapOptions = {{{"-blendu", 1},
                                                    {"-blendv", 1},
                                                    {"-boost", 1},
                                                    {"-bm", 1},
                                                    {"-cc", 1},
                                                    {"-clamp", 1},
                                                    {"-colorspace", 1},
                                                    {"-imfchan", 1},
                                                    {"-mm", 2},
                                                    {"-o", 3},
                                                    {"-s", 3},
                                                    {"-t", 3},
                                                    {"-texres", 1},
                                                    {"-type", 1}}};

/// Returns GGX's roughness of Phong's exponent: both lobes have the same width around their middle
/// (Walter and others, Microfacet Models for Refraction through Rough Surfaces, 2007).
float roughness_of(double exponent) {
  return static_cast<float>(std::pow(2.0 / (std::max(exponent, 0.0) + 2.0), 0.25));
}

/// The numbers of a material whose meaning depends on others of it.
struct Pending {
  std::optional<double> d, tr, exponent, roughness;
  bool is_shiny = false;   // it has a specular colour
  bool has_color = false;  // it has a diffuse colour
};

class MtlReader {
 public:
  MtlReader(std::string_view text, std::size_t most, std::vector<std::string>& notes)
      : lines_(text), most_(most), notes_(notes) {}

  std::vector<MtlMaterial> read() {
    std::string_view line;
    while (lines_.next(line)) {
      Words words(line);
      const std::string key = lower_case(words.next());
      if (key.empty() || key[0] == '#') continue;
      if (key == "newmtl") {
        settle();
        if (materials_.size() == most_) {
          refuse(fmt::format("line {}: found one more material, and at most {} are read",
                             lines_.number(), most_));
        }
        materials_.push_back({plain_material(), {}, {}, {}, {}});
        materials_.back().material.name = words.rest();
        pending_ = Pending();
      } else if (!materials_.empty()) {
        if (!take_number(key, words)) take_map(key, words);
      }
    }
    settle();
    if (!are_finite_) notes_.emplace_back("Numbers of materials that are not finite became 0.");
    for (const std::string& key : left_out_) {
      notes_.push_back(fmt::format("Textures of the kind {} are left out.", in_quotes(key)));
    }
    return std::move(materials_);
  }

 private:
  Material& material() { return materials_.back().material; }
  double number(Words& words) { return number(words.next()); }
  float small(Words& words) { return static_cast<float>(number(words)); }

  double number(std::string_view word) {
    const double value = real_at(word, lines_.number());
    if (std::isfinite(value)) return value;
    are_finite_ = false;
    return 0.0;
  }

  /// Reads a colour in sRGB. One number stands for a grey.
  std::optional<glm::vec3> color(Words& words) {
    const std::string_view first = words.next();
    if (first == "spectral" || first == "xyz") {
      left_out_.emplace(first);
      return std::nullopt;
    }
    glm::dvec3 encoded(number(first));
    const std::string_view second = words.next();
    if (!second.empty()) {
      encoded.y = number(second);
      encoded.z = number(words);
    }
    glm::vec3 linear(0.0f);
    for (int i = 0; i < 3; ++i) {
      // No light is so bright, and the powers of such numbers stay finite.
      linear[i] = linear_of_srgb(static_cast<float>(std::clamp(encoded[i], 0.0, 1e6)));
    }
    return linear;
  }

  bool take_number(const std::string& key, Words& words) {
    if (key == "kd") {
      const std::optional<glm::vec3> diffuse = color(words);
      if (diffuse) {
        const glm::vec3 albedo = glm::min(*diffuse, glm::vec3(1.0f));
        material().base_color = glm::vec4(albedo, material().base_color.a);
        pending_.has_color = true;
      }
    } else if (key == "ks") {
      const std::optional<glm::vec3> specular = color(words);
      pending_.is_shiny = specular && *specular != glm::vec3(0.0f);
    } else if (key == "ke") {
      material().emission = color(words).value_or(glm::vec3(0.0f));
    } else if (key == "ns") {
      pending_.exponent = number(words);
    } else if (key == "pr") {
      pending_.roughness = number(words);
    } else if (key == "pm") {
      material().metallic = std::clamp(small(words), 0.0f, 1.0f);
    } else if (key == "ni") {
      const float ior = small(words);
      if (ior >= 1.0f && ior < 10.0f) material().ior = ior;
    } else if (key == "d") {
      const std::string_view first = words.next();
      pending_.d = first == "-halo" ? number(words) : number(first);
    } else if (key == "tr") {
      pending_.tr = number(words);
    } else {
      return false;
    }
    return true;
  }

  void take_map(const std::string& key, Words& words) {
    MtlMaterial& owner = materials_.back();
    if (key == "map_kd") {
      owner.color = map(words);
    } else if (key == "map_ke") {
      owner.emission = map(words);
    } else if (key == "norm" || key == "map_norm") {
      owner.normal = map(words);
    } else if (key == "map_d") {
      owner.opacity = map(words);
    } else if (key.starts_with("map_") || key == "bump" || key == "disp" || key == "refl") {
      left_out_.insert(key.substr(0, 20));
    }
  }

  /// Reads the options of a map and the name of its file, in which there may be spaces.
  MtlMap map(Words& words) {
    MtlMap map;
    for (Words ahead = words;; words = ahead) {
      const std::string option = lower_case(ahead.next());
      const auto known = std::find_if(kMapOptions.begin(), kMapOptions.end(),
                                      [&](const MapOption& each) { return each.name == option; });
      if (known == kMapOptions.end()) break;
      if (known->values == 3) {
        take_triple(option, ahead, map);
      } else {
        const std::string_view value = ahead.next();
        if (option == "-clamp") map.clamp = lower_case(value) == "on";
        if (option == "-bm") map.strength = static_cast<float>(number(value));
        if (known->values == 2) ahead.next();
      }
    }
    map.file = words.rest();
    if (map.file.size() > 1 && map.file.front() == '"' && map.file.back() == '"') {
      map.file = map.file.substr(1, map.file.size() - 2);
    }
    return map;
  }

  /// Reads one to three numbers, of which the first two count.
  void take_triple(const std::string& option, Words& words, MtlMap& map) {
    glm::vec2 pair(option == "-s" ? 1.0f : 0.0f);
    for (int i = 0; i < 3; ++i) {
      Words ahead = words;
      const std::optional<double> value = real_of(ahead.next());
      if (!value || !std::isfinite(*value)) break;
      if (i < 2) pair[i] = static_cast<float>(*value);
      words = ahead;
    }
    if (option == "-s") map.scale = pair;
    if (option == "-o") map.offset = pair;
  }

  /// Works out what depends on several lines of a material.
  void settle() {
    if (materials_.empty()) return;
    Material& done = material();
    if (pending_.roughness) {
      done.roughness = static_cast<float>(std::clamp(*pending_.roughness, 0.0, 1.0));
    } else if (pending_.is_shiny && pending_.exponent) {
      done.roughness = roughness_of(*pending_.exponent);
    }
    // Some programs write Tr with the meaning of d, so that d counts if both are there.
    double opacity = pending_.d.value_or(1.0 - pending_.tr.value_or(0.0));
    if (!(opacity > 0.0)) {
      notes_.push_back(fmt::format("The material {} would be invisible, and is opaque instead.",
                                   in_quotes(done.name)));
      opacity = 1.0;
    }
    done.base_color.a = static_cast<float>(std::min(opacity, 1.0));
    if (done.base_color.a < 1.0f) done.alpha = AlphaMode::blend;
    if (!materials_.back().color) return;
    const bool is_black = glm::vec3(done.base_color) == glm::vec3(0.0f);
    if (!pending_.has_color || is_black) {
      done.base_color = glm::vec4(1.0f, 1.0f, 1.0f, done.base_color.a);
    }
    if (is_black) {
      notes_.push_back(
          fmt::format("The material {} has a texture and a black colour, which is not "
                      "multiplied.",
                      in_quotes(done.name)));
    }
  }

  Lines lines_;
  std::size_t most_;  // of the materials
  std::vector<std::string>& notes_;
  std::vector<MtlMaterial> materials_;
  Pending pending_;
  bool are_finite_ = true;          // the numbers so far
  std::set<std::string> left_out_;  // kinds of maps
};

}  // namespace

std::vector<MtlMaterial> read_mtl(std::string_view text, std::size_t most,
                                  std::vector<std::string>& notes) {
  return MtlReader(text, most, notes).read();
}

}  // namespace aerostat::asset
