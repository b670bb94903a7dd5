#pragma once

#include <functional>
#include <stop_token>

#include "image/film.hpp"

/// Removes noise from films with Open Image Denoise. The library need not be installed, because it
/// is loaded at run time by the first call (docs/decisions/0034-open-image-denoise.md).
namespace aerostat::denoise {

struct Options {
  std::stop_token stop = {};
  /// A function that is called with the share that is done, from 0 to 1, from any thread.
  std::function<void(double)> progress = {};
};

/// Throws Error{no_device} if the library cannot be loaded or is of a version that does not fit.
/// The message says what to install. Call it before work that would be in vain.
void require_library();

/// Takes the noise out of the radiance of a film, guided by its albedos and normals. Each of the
/// three layers has the linear values that the samples averaged to. The result is deterministic on
/// one machine. Throws the errors of require_library, Error{exhausted} if memory does not suffice,
/// Error{interrupted} if a stop is requested, and Error{internal} if the film lacks a layer or the
/// library fails, with the library's own words.
void denoise(image::Film& film, const Options& options = {});

}  // namespace aerostat::denoise
