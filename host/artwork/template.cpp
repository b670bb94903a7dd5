#include "artwork/template.hpp"

#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "artwork/svg.hpp"
#include "artwork/unrolled.hpp"

namespace aerostat::artwork {
namespace {

/// The pixels for each metre at which programs show the drawing first, the points of an outline,
/// and the distance of the heights that are written in metres. Chosen by eye.
constexpr double kPixelsPerMetre = 40.0;
constexpr int kOutlinePoints = 60;
constexpr double kHeightStep_m = 2.0;

class Template {
 public:
  explicit Template(const scene::Balloon& balloon) : cloth_(balloon) {}

  std::string run() {
    const double width = cloth_.gores() * cloth_.widest_gore(), height = cloth_.height();
    put("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
        "viewBox=\"0 0 {:.5g} {:.5g}\">\n",
        width * kPixelsPerMetre, height * kPixelsPerMetre, width, height);
    put("  <!-- The unrolled gores of an envelope of {:g} m with {} gores, seen from outside, in "
        "metres.\n       Draw above the group of guides, which is left out when the file is read. "
        "Each gore begins\n       where the one on its left ends, also where there is room between "
        "them here. -->\n",
        cloth_.diameter(), cloth_.gores());
    put("  <g id=\"{}\" fill=\"none\" stroke=\"#888\" stroke-width=\"0.02\" "
        "font-family=\"sans-serif\" font-size=\"0.32\">\n",
        kGuidesId);
    for (int gore = 0; gore < cloth_.gores(); ++gore) add_outline(gore);
    for (int gore = 0; gore < cloth_.gores(); ++gore) add_seams(gore);
    add_heights();
    add_directions();
    put("  </g>\n  <g id=\"artwork\">\n  </g>\n</svg>\n");
    return std::move(text_);
  }

 private:
  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  double middle(int gore) const { return (gore + 0.5) * cloth_.widest_gore(); }
  /// Returns the y of a height in the drawing.
  double down(double height) const { return cloth_.height() - height; }

  void add_outline(int gore) {
    put("    <polygon fill=\"#f7f7f4\" points=\"");
    for (const double side : {-0.5, 0.5}) {
      for (int i = 0; i <= kOutlinePoints; ++i) {
        const double share = static_cast<double>(side < 0.0 ? i : kOutlinePoints - i);
        const double height = cloth_.height() * share / kOutlinePoints;
        put("{:.3f},{:.3f} ", middle(gore) + side * cloth_.gore_width(height), down(height));
      }
    }
    put("\"/>\n");
  }

  void add_seams(int gore) {
    put("    <path stroke-width=\"0.01\" stroke-dasharray=\"0.1\" d=\"");
    for (int panel = 1; panel <= cloth_.panels(); ++panel) {
      const double height = panel * cloth_.panel_height();
      const double half = 0.5 * cloth_.gore_width(height);
      put("M{:.3f} {:.3f}h{:.3f}", middle(gore) - half, down(height), 2.0 * half);
    }
    put("\"/>\n");
  }

  /// Writes the heights in metres at every quarter turn, and marks the widest place.
  void add_heights() {
    const double width = cloth_.gores() * cloth_.widest_gore();
    put("    <path stroke=\"#c60\" d=\"M0 {:.3f}h{:.3f}\"/>\n", down(cloth_.widest_height()),
        width);
    for (int quarter = 0; quarter < 4; ++quarter) {
      const int gore = quarter * cloth_.gores() / 4;
      put("    <g fill=\"#555\" stroke=\"none\" text-anchor=\"middle\">\n");
      for (double height = kHeightStep_m; height < cloth_.height(); height += kHeightStep_m) {
        put("      <text x=\"{:.3f}\" y=\"{:.3f}\">{:g} m</text>\n", middle(gore),
            down(height) + 0.1, height);
      }
      put("    </g>\n");
    }
  }

  void add_directions() {
    put("    <g fill=\"#06c\" stroke=\"#06c\" text-anchor=\"middle\">\n");
    const double top = down(cloth_.widest_height());
    const char* const names[] = {"front, 0°", "right, 90°", "back, 180°", "left, 270°"};
    for (int i = 0; i < 4; ++i) {
      double place = cloth_.place_of(90.0 * i);
      if (place < 0.0) place += cloth_.gores();
      const double x = place * cloth_.widest_gore();
      put("      <path d=\"M{:.3f} {:.3f}v-1\"/>\n", x, top + 0.5);
      put("      <text x=\"{:.3f}\" y=\"{:.3f}\" stroke=\"none\">{}</text>\n", x, top - 0.6,
          names[i]);
    }
    put("    </g>\n");
  }

  Unrolled cloth_;
  std::string text_;
};

}  // namespace

std::string gores_template(const scene::Balloon& balloon) {
  return Template(balloon).run();
}

}  // namespace aerostat::artwork
