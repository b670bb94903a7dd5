#include "model/envelope.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/phase_cut.hpp"
#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

using mesh::TriangleMesh;

/// The most cells across a gore.
constexpr int kMostCells = 8;
/// The most rows of cells up a panel.
constexpr int kMostRows = 7;
constexpr int kMostDiscRows = 10;
const vec3 kPlateColor(0.05f);

/// A line around the envelope. Each of two neighbouring panels has its own line at their seam.
struct Row {
  double arc = 0.0;
  double panels_up = 0.0;
  double panel_share = 0.0;
};

enum class Cloth { panel, disc, plate };

/// A part of the envelope of one kind of cloth, from the first to the last of its rows.
struct Band {
  Cloth cloth = Cloth::panel;
  int panel = 0;
  std::vector<Row> rows;
};

class EnvelopeBuilder {
 public:
  EnvelopeBuilder(const EnvelopeShape& shape, const EnvelopePattern& pattern, double tolerance_m)
      : shape_(shape), pattern_(pattern), tolerance_(tolerance_m) {
    // The number of cells is even, because the pattern may have a point in the middle of a gore.
    cells_ = 2 * ((steps_within(tolerance_, shape.gore_rise(), kMostCells) + 1) / 2);
  }

  TriangleMesh build() {
    const double begin = shape_.mouth_arc(), end = shape_.disc_arc();
    const int panels = shape_.panels();
    const double height = (end - begin) / panels;
    const int rows = steps_within(tolerance_, shape_.panel_rise(), kMostRows);
    for (int panel = 0; panel < panels; ++panel) {
      Band band{Cloth::panel, panel, {}};
      for (int i = 0; i <= rows; ++i) {
        const double share = static_cast<double>(i) / rows;
        band.rows.push_back({begin + height * (panel + share), panel + share, share});
      }
      add_band(band);
    }
    const double plate = shape_.plate_arc();
    const int disc_rows = steps_within(tolerance_, shape_.disc_rise(), kMostDiscRows);
    Band disc{Cloth::disc, panels, {}};
    for (int i = 0; i <= disc_rows; ++i) {
      const double share = static_cast<double>(i) / disc_rows;
      disc.rows.push_back({begin + height * panels + (plate - end) * share, panels + share, 1.0});
    }
    add_band(disc);
    add_band(
        {Cloth::plate,
         panels,
         {{disc.rows.back().arc, panels + 1.0, 1.0}, {shape_.crown_arc(), panels + 2.0, 1.0}}});
    return std::move(mesh_);
  }

 private:
  /// A vertex of a grid, with its index in the mesh for the colour that it was last used with.
  struct Corner {
    CutVertex vertex;
    int band = 0;
    std::int64_t index = -1;
  };
  using Corners = std::vector<Corner>;

  void add_band(const Band& band) {
    for (int gore = 0; gore < shape_.gores(); ++gore) {
      Corners corners;
      for (const Row& row : band.rows) {
        for (int cell = 0; cell <= cells_; ++cell) corners.push_back({vertex(row, gore, cell)});
      }
      const auto line = static_cast<std::size_t>(cells_ + 1);
      for (std::size_t i = 0; i + line < corners.size(); ++i) {
        if (i % line == line - 1) continue;
        add_triangle(band, gore, {&corners[i], &corners[i + 1], &corners[i + line + 1]});
        if (band.cloth != Cloth::plate)
          add_triangle(band, gore, {&corners[i], &corners[i + line + 1], &corners[i + line]});
      }
    }
  }

  CutVertex vertex(const Row& row, int gore, int cell) const;
  vec3 color(const Band& band, int gore, int phase_band) const;
  void add_triangle(const Band& band, int gore, const std::array<Corner*, 3>& corners);
  std::uint32_t add(const CutVertex& vertex, const vec3& color);

  const EnvelopeShape& shape_;
  const EnvelopePattern& pattern_;
  double tolerance_;
  int cells_ = kMostCells;
  TriangleMesh mesh_;
};

/// Returns a vertex of the grid. At the border of two gores or two panels, both get exactly the
/// same position and phase.
CutVertex EnvelopeBuilder::vertex(const Row& row, int gore, int cell) const {
  const EnvelopeRow place{row.arc, row.panel_share};
  const double share = static_cast<double>(cell) / cells_;
  const bool next = cell == cells_;
  const int owner = next ? (gore + 1) % shape_.gores() : gore;
  CutVertex result;
  result.position = vec3(shape_.fabric(owner, next ? 0.0 : share, place).position);
  result.normal = vec3(shape_.fabric(gore, share, place).normal);
  result.uv = vec2(gore + share, row.panels_up);
  if (!pattern_.crosses_panels()) return result;
  const double around = owner + (next ? 0.0 : share);
  result.phase = quantized_phase(pattern_.phase(around, row.panels_up));
  // The crown has no pattern. Between whole numbers nothing is cut, so the phase is rounded.
  if (row.panels_up >= shape_.panels()) result.phase = std::round(result.phase);
  if (next && owner == 0) result.phase += pattern_.phase_per_turn();
  return result;
}

vec3 EnvelopeBuilder::color(const Band& band, int gore, int phase_band) const {
  switch (band.cloth) {
    case Cloth::plate:
      return kPlateColor;
    case Cloth::disc:
      return pattern_.crown();
    case Cloth::panel:
      break;
  }
  return pattern_.fabric(gore, band.panel, phase_band);
}

std::uint32_t EnvelopeBuilder::add(const CutVertex& vertex, const vec3& color) {
  mesh_.uvs.push_back(vertex.uv);
  return add_vertex(mesh_, {vertex.position, vertex.normal, color});
}

void EnvelopeBuilder::add_triangle(const Band& band, int gore,
                                   const std::array<Corner*, 3>& corners) {
  const std::array<CutVertex, 3> triangle{corners[0]->vertex, corners[1]->vertex,
                                          corners[2]->vertex};
  int phase_band = 0;
  if (lies_in_one_band(triangle, phase_band)) {
    uvec3 indices(0u);
    for (int i = 0; i < 3; ++i) {
      Corner& corner = *corners[static_cast<std::size_t>(i)];
      if (corner.index < 0 || corner.band != phase_band) {
        corner.index = add(corner.vertex, color(band, gore, phase_band));
        corner.band = phase_band;
      }
      indices[i] = static_cast<std::uint32_t>(corner.index);
    }
    mesh_.triangles.push_back(indices);
    return;
  }
  for (const CutPiece& piece : cut_by_phase(triangle)) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const CutVertex& v : piece.corners) add(v, color(band, gore, piece.band));
    for (std::uint32_t i = 2; i < piece.corners.size(); ++i) {
      mesh_.triangles.emplace_back(first, first + i - 1, first + i);
    }
  }
}

}  // namespace

TriangleMesh build_envelope(const EnvelopeShape& shape, const EnvelopePattern& pattern,
                            const Detail& detail) {
  return EnvelopeBuilder(shape, pattern, detail.envelope_m).build();
}

}  // namespace aerostat::model
