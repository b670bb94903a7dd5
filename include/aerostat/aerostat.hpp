#pragma once

#include <functional>
#include <string>

#include "aerostat/devices.hpp"
#include "aerostat/error.hpp"
#include "aerostat/export.hpp"
#include "aerostat/film.hpp"
#include "aerostat/scene.hpp"
#include "aerostat/session.hpp"

/// Aerostat renders ray-traced pictures of landscapes. A program needs three lines:
///
///     aerostat::Session session;
///     const auto scene = aerostat::Scene::from_file("snow.json");
///     session.render(scene).save("snow.png");
namespace aerostat {

/// Returns the version of the library, such as "0.1.0".
AEROSTAT_API const char* version();

/// Sets the handler of the library's warnings and returns the former one. Each warning is one
/// complete sentence without a line end. The default handler writes a line to stderr. An empty
/// handler silences the library. This function must be called before other threads use the
/// library.
AEROSTAT_API std::function<void(const std::string&)> set_warning_handler(
    std::function<void(const std::string&)> handler);

}  // namespace aerostat
