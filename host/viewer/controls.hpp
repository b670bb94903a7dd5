#pragma once

#include <QString>
#include <span>

/// Lists every control of the window in one place. The panels, the tests and the manual use this
/// list.
namespace aerostat::viewer {

enum class Editor { number, integer, seed, toggle, choice, color, colors, triple };
enum class Panel { land, light, balloon, materials, view, picture };

/// A control of one value of the scene. Its range, words and tooltip come from the schema. For the
/// lists of balloons, lamps and materials, the table names one object, and the panels bind the
/// controls to others.
struct Control {
  const char* pointer;
  /// The English label in the translation context "Controls".
  const char* label;
  Editor editor;
  Panel panel;
  /// The heading above the control, or null if the control belongs to the group of the one before
  /// it.
  const char* group = nullptr;
  /// The English unit in the translation context "Units".
  const char* unit = "";
  /// The range of the slider. The box accepts the whole range of the schema.
  double from = 0.0, to = 1.0;
  int decimals = 0;
  bool logarithmic = false;
  /// Tells whether the group that begins with this control is hidden until somebody opens it.
  bool folded = false;
  /// The English name of the least value in the translation context "Controls", or null if that
  /// value has no special meaning.
  const char* none = nullptr;
};

std::span<const Control> controls();

/// Returns the translated label of a control.
QString label_of(const Control& control);
QString group_of(const Control& control);
QString unit_of(const Control& control);
QString none_of(const Control& control);
QString description_of(const Control& control);
/// Returns the translation of a word of an enumeration, such as "gaussian".
QString word_text(const QString& word);

}  // namespace aerostat::viewer
