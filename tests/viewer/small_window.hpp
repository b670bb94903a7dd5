#pragma once

#include <QCoreApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QString>

#include "scene/source.hpp"

/// Provides the common beginning of tests of the window.
namespace aerostat::viewer {

/// Selects settings for the test `name` only, and empties them.
inline void begin_with_no_settings(const QString& name) {
  QStandardPaths::setTestModeEnabled(true);
  QCoreApplication::setOrganizationName("aerostat");
  QCoreApplication::setApplicationName(name);
  QSettings().clear();
}

/// Returns a scene that is rendered quickly.
inline scene::SceneSource small_scene(const char* biome = "sand") {
  return scene::SceneSource().with({{"/biome/kind", biome},
                                    {"/terrain/cells", "96"},
                                    {"/vegetation/enabled", "false"},
                                    {"/image/width", "160"},
                                    {"/image/height", "90"}});
}

}  // namespace aerostat::viewer
