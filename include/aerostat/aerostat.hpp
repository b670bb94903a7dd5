#pragma once

#include <functional>
#include <string>

#include "aerostat/devices.hpp"
#include "aerostat/error.hpp"
#include "aerostat/export.hpp"
#include "aerostat/film.hpp"
#include "aerostat/scene.hpp"
#include "aerostat/session.hpp"

/// Ray-traced pictures of landscapes as a library. A program needs three lines:
///
///     aerostat::Session session;
///     const auto scene = aerostat::Scene::from_file("snow.json");
///     session.render(scene).save("snow.png");
namespace aerostat {

/// The version of the library, such as "0.1.0".
AEROSTAT_API const char* version();

/// Receives the library's warnings, one complete sentence each, without a line end. The default
/// writes a line to stderr. An empty handler silences the library. Returns the former handler. Call
/// it before other threads use the library.
AEROSTAT_API std::function<void(const std::string&)> set_warning_handler(
    std::function<void(const std::string&)> handler);

}  // namespace aerostat
