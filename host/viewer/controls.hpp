#pragma once

#include <QString>
#include <span>
#include <vector>

#include "scene/field_edit.hpp"

/// Lists every control of the window in one place. The panels, the tests and the manual use this
/// list.
namespace aerostat::viewer {

using scene::Editor;

/// A control of one value of the scene. Its range, words and tooltip come from the schema. For the
/// lists of balloons, models, lamps and materials, the list has the controls of one object, and the
/// panels bind them to others.
using Control = scene::FieldEdit;

enum class Panel { land, light, balloon, materials, view, picture };

/// Controls that stand together under a heading.
struct ControlGroup {
  scene::EditGroup group;
  Panel panel;
  /// The English heading in the translation context "Controls", or null for no heading.
  const char* heading = nullptr;
  /// Tells whether the controls are hidden until somebody opens the group.
  bool folded = false;
};

/// Returns all groups, in the order in which the panels show them.
std::span<const ControlGroup> control_groups();

/// Returns all controls, in the order of the scene file.
const std::vector<Control>& controls();

/// Returns the translated label of a control.
QString label_of(const Control& control);
QString heading_of(const ControlGroup& group);
QString unit_of(const Control& control);
QString none_of(const Control& control);
QString description_of(const Control& control);
/// Returns the translation of a word of an enumeration, such as "gaussian".
QString word_text(const QString& word);

}  // namespace aerostat::viewer
