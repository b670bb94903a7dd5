#pragma once

#include <vector>

#include "film/frames.hpp"
#include "image/write.hpp"

namespace aerostat::film {

/// Returns the frames of a film that its contact sheet shows: all of them if they are few, or else
/// some that are evenly apart, the first and the last one among them.
std::vector<int> sheet_frames(const std::vector<int>& frames);

/// Returns a sheet of small pictures of frames, each with its number below. The files of the frames
/// must be whole PNG files of one size. Throws Error{io} and Error{bad_data} with their names.
image::Pixels contact_sheet(const FrameNames& names, const std::vector<int>& frames);

/// Returns a picture whose sides are `width` and `height`, at most its own. Each pixel is the mean
/// of those below it.
image::Pixels shrunk(const image::Pixels& pixels, int width, int height);

}  // namespace aerostat::film
