#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/array.hpp"
#include "film_pixel.h"
#include "render/row_queue.hpp"
#include "render/session.hpp"

/// A render that pauses, and the sums from which it goes on. They are what checkpoints hold.
namespace aerostat::render {

struct FilmRows;

/// The sums over the samples of a render that is not finished. A render that goes on from them ends
/// with the same bits as one that was never interrupted, if its devices have the same lanes.
struct FilmSums {
  /// The pixels of the image that the sums cover: the crop and its apron (PassPlan).
  Crop window;
  /// The samples of each pixel that whole passes have taken. Pixels that have converged are marked
  /// already for the pass that comes next.
  int samples_done = 0;
  /// The rows that still wait in that pass, from the top. The others are finished in it.
  std::vector<RowRange> waiting;
  /// The exposure that metering found, in stops.
  double metered_ev = 0.0;
  /// The sums of the window, row by row.
  Array<AeroFilmPixel> pixels;
  /// The sums of the guides of a denoiser, or nothing if the films of the session have none.
  Array<AeroFilmGuide> guides;
};

/// A moment in which nothing is being launched.
struct Pause {
  int samples_done = 0;
  /// Whether each pixel has a sample, so that the film is a picture.
  bool is_picture = false;
  /// The share of the rays that are done, from 0 to 1.
  double fraction = 0.0;
  /// Reads the sums from the devices. It may be called only before `at_pause` returns.
  std::function<FilmSums()> sums;
};

/// What happens to a long render on its way.
struct Course {
  /// The sums from which the render goes on. Null means that it begins at the beginning.
  std::shared_ptr<const FilmSums> from = nullptr;
  /// Is asked every 20 ms while rays are traced. If it returns true, the render pauses within 100
  /// ms of device work. Null means that it never pauses.
  std::function<bool(const Progress&)> wants_pause = nullptr;
  /// Is called at each pause. If it returns false, the render ends with the film so far. Pixels of
  /// that may have different numbers of samples.
  std::function<bool(const Pause&)> at_pause = nullptr;
  /// The samples of each pixel after which the render ends with the film so far, as at a pause:
  /// `at_pause` is called there. 0 means that all samples are taken.
  int until = 0;
};

/// Reads the sums of the window from the films that hold its rows, and those of the guides if
/// `with_guides`.
FilmSums read_sums(std::span<const FilmRows> parts, const Crop& window, bool with_guides);

/// Throws Error{usage} if the sums are of another window than `window`, or if a render with
/// `samples` samples never has their numbers of samples and rows. The pixels are not looked at.
void require_fitting(const FilmSums& sums, const Crop& window, int samples);

/// Throws Error{usage} also if the sums have another number of pixels or guides.
void require_fitting(const FilmSums& sums, const Crop& window, int samples, bool with_guides);

}  // namespace aerostat::render
