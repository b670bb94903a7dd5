#pragma once

#include <QString>
#include <span>

/// What the window lets one change, said once: the panels, the tests and the manual follow it.
namespace aerostat::viewer {

enum class Editor { number, integer, seed, toggle, choice, color, colors, triple };
enum class Panel { land, light, balloon, materials, view, picture };

/// A control of one value of the scene. Range, words and tooltip come from the schema. Of the lists
/// of balloons, lamps and materials the table names one; the panels bind its controls to others.
struct Control {
  const char* pointer;
  const char* label;  // English, context "Controls"
  Editor editor;
  Panel panel;
  const char* group = nullptr;  // heading above it, if another one than that of the former
  const char* unit = "";        // English, context "Units"
  double from = 0.0, to = 1.0;  // of the slider; the schema's range can be typed
  int decimals = 0;
  bool logarithmic = false;
  bool folded = false;         // the group that begins here is, until one asks for it
  const char* none = nullptr;  // English, context "Controls": what the least value means
};

std::span<const Control> controls();

/// Translated.
QString label_of(const Control& control);
QString group_of(const Control& control);
QString unit_of(const Control& control);
QString none_of(const Control& control);
QString description_of(const Control& control);
/// A word of an enumeration, such as "gaussian".
QString word_text(const QString& word);

}  // namespace aerostat::viewer
