#pragma once

#include <string>
#include <vector>

namespace aerostat::scene {

enum class FieldType { boolean, integer, number, word, text, array, object };

/// What the schema says of one value of a scene, for programs that offer it to a user.
struct FieldRule {
  FieldType type = FieldType::object;
  std::string description;
  double minimum = -1e300, maximum = 1e300;  // of numbers, and of an array's numbers
  std::vector<std::string> words;            // that a word may be
  int least_items = 0, most_items = 0;       // of arrays
};

/// The rule at a JSON pointer, an array's element by its index. A biome is an object here. Throws
/// Error{usage} if scenes have no such value.
FieldRule field_rule(const std::string& pointer);

/// The pointers of all values that a scene can have, of lists of objects those of the first one; an
/// array of numbers or colours is one value.
std::vector<std::string> field_pointers();

}  // namespace aerostat::scene
