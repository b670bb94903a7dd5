#include "model/envelope.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "model/phase_cut.hpp"
#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr int kFabricCells = 8;  // across a gore
constexpr int kTapeCells = 3;
constexpr int kCells = kFabricCells + kTapeCells;
constexpr int kStripsPerPanel = 7;
constexpr int kDiscStrips = 10;
constexpr double kHem = 0.004;  // in diameters
constexpr double kSeamHalf = 0.0006;
const vec3 kPlateColor(0.05f);
// Cross-section of a load tape: its raised part, and how far its edges lean.
constexpr double kTapeTop = 0.6;
constexpr std::array<double, 4> kTapeLean{-0.95, -0.35, 0.35, 0.95};

enum class Cloth { fabric, seam, hem, disc, plate };

/// A line of vertices around the envelope.
struct Row {
  double arc = 0.0;
  double panels_up = 0.0;
  double panel_share = 0.0;
};

/// What lies between row i and row i + 1.
struct Strip {
  Cloth cloth = Cloth::fabric;
  int panel = 0;
};

/// Where a vertex belongs decides its normal and its colour; it is shared while both stay.
struct Context {
  vec3 color{0.0f};
  bool tape = false;
  bool seam = false;
  bool operator==(const Context&) const = default;
};

/// A vertex of the grid, seen from a gore: cell 0 is the edge of the tape at which it begins.
struct Corner {
  int row = 0;
  int cell = 0;
};
using Corners = std::array<Corner, 3>;

class EnvelopeBuilder {
 public:
  EnvelopeBuilder(const EnvelopeShape& shape, const EnvelopePattern& pattern)
      : shape_(shape), pattern_(pattern), columns_(shape.gores() * kCells) {
    lay_rows();
    place_vertices();
  }

  TriangleMesh build() {
    shared_.assign(rows_.size() * columns_, {});
    for (int strip = 0; strip < static_cast<int>(strips_.size()); ++strip) {
      for (int column = 0; column < columns_; ++column) add_cell(strip, column);
    }
    return std::move(mesh_);
  }

 private:
  struct Shared {
    Context context;
    std::int64_t index = -1;
  };

  void add_row(double arc, double panels_up, double panel_share) {
    rows_.push_back({arc, panels_up, panel_share});
  }

  void lay_rows();
  void lay_panel(int panel, double from, double to);
  void place_vertices();
  dvec3 vertex_position(const Row& row, int gore, int cell) const;
  double share(const Row& row, int cell) const;
  dvec3 normal(const Row& row, int gore, int cell, const Context& context) const;
  std::size_t grid_index(int row, int column) const {
    return static_cast<std::size_t>(row * columns_ + column % columns_);
  }
  double phase(int row, int column) const {
    const double whole_turns = column == columns_ ? pattern_.phase_per_turn() : 0.0;
    return phases_[grid_index(row, column)] + whole_turns;
  }
  Context context(int strip, int gore, int cell, int band) const;
  void add_cell(int strip, int column);
  void add_triangle(int strip, int gore, const Corners& corners);
  void add_cut_triangle(int strip, int gore, const Corners& corners,
                        std::array<CutVertex, 3>& triangle);
  std::uint32_t shared_vertex(int row, int gore, int cell, const Context& context);

  const EnvelopeShape& shape_;
  const EnvelopePattern& pattern_;
  int columns_;
  std::vector<Row> rows_;
  std::vector<Strip> strips_;
  std::vector<vec3> positions_;
  std::vector<double> phases_;
  std::vector<Shared> shared_;
  TriangleMesh mesh_;
};

void EnvelopeBuilder::lay_panel(int panel, double from, double to) {
  const double hem = kHem * shape_.diameter(), seam = kSeamHalf * shape_.diameter();
  const double first = from + (panel == 0 ? hem : seam);
  const double last = to - (panel == shape_.panels() - 1 ? hem : seam);
  for (int i = 0; i <= kStripsPerPanel; ++i) {
    const double arc = first + (last - first) * i / kStripsPerPanel;
    const double share = (arc - from) / (to - from);
    add_row(arc, panel + share, share);
    const bool top = i == kStripsPerPanel;
    const bool last_panel = panel == shape_.panels() - 1;
    strips_.push_back({top ? (last_panel ? Cloth::hem : Cloth::seam) : Cloth::fabric, panel});
  }
}

void EnvelopeBuilder::lay_rows() {
  const double begin = shape_.mouth_arc(), end = shape_.disc_arc();
  const int panels = shape_.panels();
  add_row(begin, 0.0, 0.0);
  strips_.push_back({Cloth::hem, 0});
  for (int panel = 0; panel < panels; ++panel) {
    const double height = (end - begin) / panels;
    lay_panel(panel, begin + height * panel, begin + height * (panel + 1));
  }
  for (int i = 0; i <= kDiscStrips; ++i) {
    add_row(end + (shape_.plate_arc() - end) * i / kDiscStrips, panels, 1.0);
    strips_.push_back({i < kDiscStrips ? Cloth::disc : Cloth::plate, panels});
  }
  add_row(shape_.crown_arc(), panels, 1.0);
}

double EnvelopeBuilder::share(const Row& row, int cell) const {
  const double tape = shape_.tape_share(row.arc);
  switch (cell) {
    case 0:
      return -tape;
    case 1:
      return -kTapeTop * tape;
    case 2:
      return kTapeTop * tape;
    default:
      return tape + (1.0 - 2.0 * tape) * (cell - kTapeCells) / kFabricCells;
  }
}

dvec3 EnvelopeBuilder::vertex_position(const Row& row, int gore, int cell) const {
  const EnvelopeRow place{row.arc, row.panel_share, false};
  const FabricPoint point = shape_.fabric(gore, share(row, cell), place);
  const bool raised = (cell == 1 || cell == 2) && row.arc < shape_.plate_arc();
  return raised ? point.position + shape_.tape_height() * point.normal : point.position;
}

void EnvelopeBuilder::place_vertices() {
  positions_.reserve(rows_.size() * columns_);
  for (const Row& row : rows_) {
    for (int column = 0; column < columns_; ++column) {
      const int gore = column / kCells, cell = column % kCells;
      positions_.emplace_back(vertex_position(row, gore, cell));
      if (!pattern_.crosses_panels()) continue;
      const double phase = quantized_phase(pattern_.phase(gore + share(row, cell), row.panels_up));
      // The crown has no pattern: between whole numbers nothing is cut.
      phases_.push_back(row.panels_up < shape_.panels() ? phase : std::round(phase));
    }
  }
}

dvec3 EnvelopeBuilder::normal(const Row& row, int gore, int cell, const Context& context) const {
  const EnvelopeRow place{row.arc, row.panel_share, context.seam};
  if (!context.tape) return shape_.fabric(gore, share(row, cell), place).normal;
  const double half = shape_.tape_share(row.arc);
  const FabricPoint left = shape_.fabric(gore, -half, place);
  const FabricPoint right = shape_.fabric(gore, half, place);
  const double lean =
      row.arc < shape_.plate_arc() ? kTapeLean[static_cast<std::size_t>(cell)] : 0.0;
  const dvec3 middle = glm::normalize(left.normal + right.normal);
  return middle * std::cos(lean) + shape_.fabric(gore, 0.0, place).around * std::sin(lean);
}

Context EnvelopeBuilder::context(int strip_index, int gore, int cell, int band) const {
  const Strip& strip = strips_[static_cast<std::size_t>(strip_index)];
  const bool tape = cell < kTapeCells;
  switch (strip.cloth) {
    case Cloth::plate:
      return {kPlateColor, false, true};
    case Cloth::hem:
      return {pattern_.tape(), tape, true};
    case Cloth::disc:
      return {tape ? pattern_.tape() : pattern_.crown(), tape, true};
    case Cloth::fabric:
    case Cloth::seam:
      break;
  }
  const bool seam = strip.cloth == Cloth::seam;
  if (tape) return {pattern_.tape(), true, true};
  const vec3 color = pattern_.fabric(gore, strip.panel, band);
  return {seam ? color * 0.6f : color, false, seam};
}

std::uint32_t EnvelopeBuilder::shared_vertex(int row, int gore, int cell, const Context& context) {
  const std::size_t place = grid_index(row, gore * kCells + cell);
  Shared& shared = shared_[place];
  if (shared.index < 0 || !(shared.context == context)) {
    const dvec3 direction = normal(rows_[static_cast<std::size_t>(row)], gore, cell, context);
    shared = {context, add_vertex(mesh_, {positions_[place], direction, context.color})};
  }
  return static_cast<std::uint32_t>(shared.index);
}

void EnvelopeBuilder::add_triangle(int strip, int gore, const Corners& corners) {
  std::array<CutVertex, 3> triangle;
  if (pattern_.crosses_panels()) {
    for (std::size_t i = 0; i < 3; ++i) {
      triangle[i].phase = phase(corners[i].row, gore * kCells + corners[i].cell);
    }
  }
  int band = 0;
  if (!lies_in_one_band(triangle, band)) return add_cut_triangle(strip, gore, corners, triangle);
  const Context at = context(strip, gore, corners[0].cell, band);
  uvec3 indices(0u);
  for (int i = 0; i < 3; ++i) {
    const Corner& corner = corners[static_cast<std::size_t>(i)];
    indices[i] = shared_vertex(corner.row, gore, corner.cell, at);
  }
  mesh_.triangles.push_back(indices);
}

void EnvelopeBuilder::add_cut_triangle(int strip, int gore, const Corners& corners,
                                       std::array<CutVertex, 3>& triangle) {
  const int cell = corners[0].cell;
  const Context any = context(strip, gore, cell, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner& corner = corners[i];
    const Row& row = rows_[static_cast<std::size_t>(corner.row)];
    triangle[i].position = positions_[grid_index(corner.row, gore * kCells + corner.cell)];
    triangle[i].normal = vec3(normal(row, gore, corner.cell, any));
  }
  for (const CutPiece& piece : cut_by_phase(triangle)) {
    const vec3 color = context(strip, gore, cell, piece.band).color;
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const CutVertex& v : piece.corners) add_vertex(mesh_, {v.position, v.normal, color});
    for (std::uint32_t i = 2; i < piece.corners.size(); ++i) {
      mesh_.triangles.emplace_back(first, first + i - 1, first + i);
    }
  }
}

void EnvelopeBuilder::add_cell(int strip, int column) {
  const int gore = column / kCells, cell = column % kCells;
  add_triangle(strip, gore, {{{strip, cell}, {strip, cell + 1}, {strip + 1, cell + 1}}});
  const bool crown = strip + 1 == static_cast<int>(strips_.size());
  if (!crown)
    add_triangle(strip, gore, {{{strip, cell}, {strip + 1, cell + 1}, {strip + 1, cell}}});
}

}  // namespace

TriangleMesh build_envelope(const EnvelopeShape& shape, const EnvelopePattern& pattern) {
  return EnvelopeBuilder(shape, pattern).build();
}

}  // namespace aerostat::model
