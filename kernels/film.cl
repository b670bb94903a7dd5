#include "film/film.clh"
#include "trace_triangle.h"

/* Empties the film. */
__kernel void clear_film(__global AeroFilmPixel* film, const uint pixels) {
  const uint i = (uint)get_global_id(0);
  if (i >= pixels) return;
  AeroFilmPixel empty = {{0.0f, 0.0f, 0.0f}, 0.0f, INFINITY, AERO_OBJECT_SKY, 0u, 0u, 0.0f, 0.0f};
  film[i] = empty;
}

/* Empties the guides of a denoiser. */
__kernel void clear_guides(__global AeroFilmGuide* guides, const uint pixels) {
  const uint i = (uint)get_global_id(0);
  if (i >= pixels) return;
  AeroFilmGuide empty = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
  guides[i] = empty;
}

/* Marks the pixels as converged that have enough samples. */
__kernel void mark_converged(__global AeroFilmPixel* film, const AeroConvergence convergence) {
  const uint i = (uint)get_global_id(0);
  const AeroConvergence asked = convergence;
  if (i >= asked.width * asked.height) return;
  if (has_converged(film, i, &asked)) film[i].converged = 1u;
}
