#pragma once

#include <string>
#include <vector>

namespace aerostat::scene {

/// The kinds of controls that a window has for values. `seed` is a whole number that can be drawn
/// at random, `colors` a list of colours, and `triple` three numbers side by side.
enum class Editor { number, integer, seed, toggle, choice, color, colors, triple };

/// The groups in which a window shows its controls. The window says where each group stands and
/// what its heading is.
enum class EditGroup {
  land,
  snow_and_water,
  plants,
  model,
  shape,
  dunes,
  ground,
  sea,
  mood,
  sun,
  night,
  air,
  clouds,
  sky_light,
  lamps,
  air_in_detail,
  balloon,
  envelope,
  festival,
  material,
  lens,
  camera,
  picture,
  size,
  development,
  sampling
};

enum class Scale { linear, logarithmic };

/// Tells how a window edits one value, or one element of an array.
struct Edit {
  EditGroup group = EditGroup::land;
  /// The English label, in a few words.
  const char* label = nullptr;
  Editor editor = Editor::number;
  /// The range of a slider. It lies within the range that the schema allows.
  double from = 0.0, to = 1.0;
  int decimals = 0;  // decimals of the numbers that are shown
  Scale scale = Scale::linear;
  /// The English name of the least value, or null if that value has no special meaning.
  const char* none = nullptr;
  /// The sign of the unit, such as "m", or "" for a number without a unit.
  const char* unit = "";
};

struct FieldEdit : Edit {
  std::string pointer;  // JSON pointer of the value
};

/// Returns the controls for all values that a window edits, in the order of the scene file. Of the
/// balloons, models, lamps and materials, only /balloon, /objects/0, /lights/0 and
/// /materials/envelope are there.
const std::vector<FieldEdit>& field_edits();

}  // namespace aerostat::scene
