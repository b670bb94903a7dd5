#include "labels/layout.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace aerostat::labels {
namespace {

// In heights of letters. Latin letters of usual fonts are some 0.55 wide, and those of East Asia 1.
constexpr double kLetter = 0.62, kWideLetter = 1.05, kLine = 1.35, kGap = 0.4;
constexpr int kRows = 12;
constexpr double kShifts[] = {0.0, -0.25, 0.25, -0.5, 0.5};

double width_of(const std::string& text) {
  double width = 0.0;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte >= 0xE2) {
      width += kWideLetter;  // first of three or four bytes
    } else if (byte < 0x80 || byte >= 0xC0) {
      width += kLetter;
    }
  }
  return width;
}

bool boxes_meet(const Label& a, const Label& b) {
  return a.lo.x < b.hi.x && b.lo.x < a.hi.x && a.lo.y < b.hi.y && b.lo.y < a.hi.y;
}

/// Returns whether the leader line of `a`, which rises straight to its box, crosses the box of `b`.
bool leader_meets(const Label& a, const Label& b) {
  return a.point.x > b.lo.x && a.point.x < b.hi.x && a.hi.y < b.hi.y && a.point.y > b.lo.y;
}

class Layout {
 public:
  Layout(const dvec2& size, const std::vector<Point>& points)
      : size_(size), em_(text_size(size.y)), points_(points) {}

  /// Returns the lowest free place above a point. Of several in a row, it is the one that is in the
  /// way of the fewest other leader lines.
  std::optional<Label> room_for(const Point& point) const {
    const double width = width_of(point.name) * em_, height = kLine * em_;
    for (int row = 0; row < kRows; ++row) {
      const double bottom = point.pixel.y - (1.0 + kGap) * em_ - row * height;
      std::optional<Label> best;
      std::ptrdiff_t fewest = 0;
      for (const double shift : kShifts) {
        const double left = point.pixel.x + (shift - 0.5) * width;
        const Label label{point.name, point.pixel, {left, bottom - height}, {left + width, bottom}};
        if (!is_free(label)) continue;
        const std::ptrdiff_t blocked = lines_blocked(label);
        if (best && blocked >= fewest) continue;
        best = label;
        fewest = blocked;
      }
      if (best) return best;
    }
    return std::nullopt;
  }

  void add(Label label) { labels_.push_back(std::move(label)); }
  std::vector<Label> take() { return std::move(labels_); }

 private:
  bool is_free(const Label& label) const {
    if (label.lo.x < 0.0 || label.lo.y < 0.0 || label.hi.x > size_.x || label.hi.y > size_.y) {
      return false;
    }
    return std::none_of(labels_.begin(), labels_.end(), [&](const Label& other) {
      return boxes_meet(label, other) || leader_meets(label, other) || leader_meets(other, label);
    });
  }

  std::ptrdiff_t lines_blocked(const Label& label) const {
    return std::count_if(points_.begin(), points_.end(), [&](const Point& other) {
      return other.pixel != label.point && other.pixel.x > label.lo.x &&
             other.pixel.x < label.hi.x && other.pixel.y > label.lo.y;
    });
  }

  dvec2 size_;
  double em_;
  const std::vector<Point>& points_;
  std::vector<Label> labels_;
};

}  // namespace

double text_size(double picture_height) {
  return std::max(10.0, picture_height / 45.0);
}

std::vector<Label> lay_out(std::vector<Point> points, const dvec2& size) {
  std::stable_sort(points.begin(), points.end(),
                   [](const Point& a, const Point& b) { return a.height_m > b.height_m; });
  Layout layout(size, points);
  for (const Point& point : points) {
    if (std::optional<Label> label = layout.room_for(point)) layout.add(std::move(*label));
  }
  return layout.take();
}

}  // namespace aerostat::labels
