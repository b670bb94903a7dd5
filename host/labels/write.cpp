#include "labels/write.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labels/layout.hpp"

namespace aerostat::labels {
namespace {

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (k < count ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[word >> (18 - 6 * k) & 63u] : '=';
    }
  }
  return text;
}

/// Returns a text in which nothing is markup. Control characters were removed when it was read.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::vector<Point> points_of(const std::vector<NameInView>& names, const Part& part) {
  std::vector<Point> points;
  for (const NameInView& name : names) {
    if (!name.pixel || name.hidden) continue;
    const dvec2 pixel = *name.pixel - part.first;
    const bool inside =
        pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < part.size.x && pixel.y < part.size.y;
    if (inside) points.push_back({name.named.name, pixel, name.height_m});
  }
  return points;
}

/// Returns a label, first in wide black lines, so that it can be read on anything. Attributes say
/// how it looks, because not every program knows style sheets.
std::string label_text(const Label& label, double em) {
  const std::string line = fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\"/>", label.point.x,
                                       label.point.y, label.hi.y + 0.1 * em);
  const std::string text =
      fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", 0.5 * (label.lo.x + label.hi.x),
                  label.hi.y - 0.35 * em, escaped(label.name));
  return fmt::format(
      "<g fill=\"#000\" stroke=\"#000\" stroke-width=\"{0:.2f}\">{2}{3}</g>\n"
      "<g stroke=\"#fff\" stroke-width=\"{1:.2f}\">{2}</g><g fill=\"#fff\">{3}</g>\n",
      0.18 * em, 0.07 * em, line, text);
}

}  // namespace

std::string svg_text(const std::vector<NameInView>& names, const Part& part,
                     std::span<const std::uint8_t> png) {
  const double em = text_size(part.size.y);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\">\n"
      "<image width=\"{0:.0f}\" height=\"{1:.0f}\" xlink:href=\"data:image/png;base64,",
      part.size.x, part.size.y);
  text += base64(png) + "\"/>\n";
  text += fmt::format(
      "<g font-family=\"sans-serif\" font-weight=\"bold\" font-size=\"{:.1f}\" "
      "text-anchor=\"middle\" "
      "stroke-linejoin=\"round\">\n",
      em);
  for (const Label& label : lay_out(points_of(names, part), part.size)) {
    text += label_text(label, em);
  }
  return text + "</g>\n</svg>\n";
}

std::string json_text(const std::vector<NameInView>& names, const Part& part) {
  using Json = nlohmann::ordered_json;
  Json places = Json::array();
  for (const NameInView& name : names) {
    Json place;
    place["name"] = name.named.name;
    place["latitude"] = name.named.place.latitude_deg;
    place["longitude"] = name.named.place.longitude_deg;
    place["height"] = name.height_m;
    place["x"] = name.pixel ? Json(name.pixel->x - part.first.x) : Json();
    place["y"] = name.pixel ? Json(name.pixel->y - part.first.y) : Json();
    place["distance_m"] = name.pixel ? Json(name.distance_m) : Json();
    place["in_picture"] = name.in_picture;
    place["hidden"] = name.hidden;
    places.push_back(std::move(place));
  }
  return Json{{"width", part.size.x}, {"height", part.size.y}, {"places", places}}.dump(2) + "\n";
}

}  // namespace aerostat::labels
