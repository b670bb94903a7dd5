#pragma once

#include <array>
#include <cstddef>

#include "scene/field_edit.hpp"

namespace aerostat::scene::detail {

/// Says all about a field that the struct in scene.hpp does not say: its text, its range and how a
/// window edits it. The functions below make one, and the members add to it.
struct About {
  /// In the text, "{from}" and "{to}" stand for the ends of the range.
  const char* text = "";
  const char* ending = "";  // the end of the text, which has the same placeholders
  /// The range of a number, of each number of an array, or of the length of a list.
  double from = 0.0, to = 0.0;
  bool is_above = false;       // true: `from` itself is not allowed
  bool is_required = false;    // true: an object must have the key
  std::size_t word_count = 0;  // only the first words of an enumeration are allowed; 0: all are
  /// A word beside those of the enumeration that means the same as leaving the field out, or null.
  const char* left_out_word = nullptr;
  const char* part_text = nullptr;  // the text of an element of a list, or of a short form
  Editor editor = Editor::number;   // the control that the window has unless an edit says otherwise
  const char* own_unit = nullptr;   // the unit in the window; null: it follows from the key
  /// The controls: one for the value, or one for each element of an array.
  std::array<Edit, 3> edits{};
  std::size_t edit_count = 0;

  /// Excludes the lower end of the range itself.
  constexpr About above() const {
    About result = *this;
    result.is_above = true;
    return result;
  }

  /// Demands that an object has the key.
  constexpr About required() const {
    About result = *this;
    result.is_required = true;
    return result;
  }

  /// Allows only the first `count` words of the enumeration.
  constexpr About words(std::size_t count) const {
    About result = *this;
    result.word_count = count;
    return result;
  }

  /// Allows a further word that means the same as leaving the field out.
  constexpr About or_left_out(const char* further) const {
    About result = *this;
    result.left_out_word = further;
    return result;
  }

  /// Sets the unit in the window where the key does not end with it.
  constexpr About unit(const char* unit) const {
    About result = *this;
    result.own_unit = unit;
    return result;
  }

  /// Adds a slider with a box for its number. For an array, each call adds that of the next
  /// element.
  constexpr About slider(EditGroup group, const char* label, double least, double most,
                         int decimals = 0, Scale scale = Scale::linear) const {
    return with({group, label, Editor::number, least, most, decimals, scale});
  }

  /// Gives the least value of the last slider a name.
  constexpr About none(const char* name) const {
    About result = *this;
    result.edits[edit_count - 1].none = name;
    return result;
  }

  /// Adds the control that suits the type: a switch, a list of words or colours. A table in which a
  /// number has this control does not compile.
  constexpr About control(EditGroup group, const char* label) const {
    if (editor == Editor::number) throw "a number has a slider or boxes";
    return with({group, label, editor});
  }

  /// Adds a box for a whole number, with a button that draws one at random.
  constexpr About dice(EditGroup group, const char* label) const {
    return with({group, label, Editor::seed});
  }

  /// Adds three boxes for the numbers of an array.
  constexpr About boxes(EditGroup group, const char* label, int decimals) const {
    return with({group, label, Editor::triple, 0.0, 1.0, decimals});
  }

 private:
  constexpr About with(const Edit& edit) const {
    About result = *this;
    result.edits[result.edit_count++] = edit;
    return result;
  }
};

/// Describes a number, or an array of numbers that all have this range.
constexpr About number(double from, double to, const char* text) {
  return {.text = text, .from = from, .to = to};
}

/// Describes a value that is true or false.
constexpr About truth(const char* text) {
  return {.text = text, .editor = Editor::toggle};
}

/// Describes a word of an enumeration, or any text.
constexpr About word(const char* text) {
  return {.text = text, .editor = Editor::choice};
}

/// Describes a colour whose components go from 0 to `to`. `ending` ends the text.
constexpr About color(
    const char* text, double to = 1.0,
    const char* ending = " Linear Rec. 709 [red, green, blue], each {from} to {to}.") {
  return {.text = text, .ending = ending, .to = to, .editor = Editor::color};
}

/// Describes a list of colours. `part_text` is the text of one colour.
constexpr About colors(int least, int most, const char* text, const char* part_text) {
  return {.text = text,
          .from = static_cast<double>(least),
          .to = static_cast<double>(most),
          .part_text = part_text,
          .editor = Editor::colors};
}

/// Describes a text.
constexpr About text(const char* text) {
  return {.text = text};
}

/// Describes a list of texts. `part_text` is the text of an element.
constexpr About texts(int most, const char* text, const char* part_text) {
  return {.text = text, .to = static_cast<double>(most), .part_text = part_text};
}

/// Describes a point in space whose coordinates are at most `reach` metres from 0.
constexpr About place(const char* text, double reach = 1e6) {
  return {.text = text,
          .ending = " [x, y, z] in metres, y up.",
          .from = -reach,
          .to = reach,
          .own_unit = "m"};
}

/// Describes a list of at most `most` objects.
constexpr About list(int most, const char* text) {
  return {.text = text, .to = static_cast<double>(most)};
}

/// Describes an object whose struct has no text of its own. With a `short_text`, the word of its
/// "kind" may stand for the object.
constexpr About object(const char* text, const char* short_text = nullptr) {
  return {.text = text, .part_text = short_text};
}

}  // namespace aerostat::scene::detail
