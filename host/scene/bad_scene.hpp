#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace aerostat::scene {

/// One thing that is wrong with a scene.
struct Fault {
  std::vector<std::string> pointer;  // unescaped reference tokens of a JSON pointer
  std::string found;
  std::string expected;
  int line = 0;    // line of the scene's text, from 1; 0 for "--set" or an edit
  int column = 0;  // column in characters, from 1
};

/// The Error{bad_data} of a scene, with all its faults. A fault that another one hides is
/// missing. what() tells the first fault, without its line.
class BadScene : public Error {
 public:
  /// Takes at least one fault. `name` stands for the file in messages.
  BadScene(const std::string& name, std::vector<Fault> faults);

  const std::vector<Fault>& faults() const { return faults_; }

  /// Returns a line for each fault, in the order of the text. An example is "a.json:3:8:
  /// /image/width: found 0, expected an integer from 1 to 32768". After 50 faults, a last line
  /// says how many more there are.
  std::vector<std::string> lines() const;

 private:
  std::string name_;
  std::vector<Fault> faults_;
};

}  // namespace aerostat::scene
