#pragma once

#include <QCoreApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QString>

#include "scene/source.hpp"

/// What tests of the window begin with.
namespace aerostat::viewer {

/// Settings of the test `name` alone, and none yet.
inline void begin_with_no_settings(const QString& name) {
  QStandardPaths::setTestModeEnabled(true);
  QCoreApplication::setOrganizationName("aerostat");
  QCoreApplication::setApplicationName(name);
  QSettings().clear();
}

/// Soon rendered.
inline scene::SceneSource small_scene(const char* biome = "sand") {
  return scene::SceneSource().with({{"/biome/kind", biome},
                                    {"/terrain/cells", "96"},
                                    {"/vegetation/enabled", "false"},
                                    {"/image/width", "160"},
                                    {"/image/height", "90"}});
}

}  // namespace aerostat::viewer
