#pragma once

#include <string>
#include <vector>

namespace aerostat::scene {

enum class FieldType { boolean, integer, number, word, text, array, object };

/// The schema's rule for one value of a scene, for programs that offer the value to a user.
struct FieldRule {
  FieldType type = FieldType::object;
  std::string description;
  double minimum = -1e300, maximum = 1e300;  // bounds of a number or of an array's numbers
  std::vector<std::string> words;            // the words that a value may be
  int least_items = 0, most_items = 0;       // bounds of the length of an array
};

/// Returns the rule at a JSON pointer, in which an element of an array stands by its index. A
/// biome counts as an object here. Throws Error{usage} if scenes have no such value.
FieldRule field_rule(const std::string& pointer);

/// Returns the pointers of all values that a scene can have. For a list of objects, they are the
/// pointers of the first object. An array of numbers or colours counts as one value.
std::vector<std::string> field_pointers();

}  // namespace aerostat::scene
