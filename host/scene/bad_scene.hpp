#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace aerostat::scene {

/// One thing that is wrong with a scene.
struct Fault {
  std::vector<std::string> pointer;  // reference tokens of a JSON pointer, unescaped
  std::string found;
  std::string expected;
  int line = 0;    // in the scene's text, from 1; 0: it is not in there ("--set", an edit)
  int column = 0;  // in characters, from 1
};

/// Error{bad_data} of a scene, with all that is wrong with it as far as one fault does not hide
/// others. what() tells the first of them, without its line.
class BadScene : public Error {
 public:
  /// `name` stands for the file in messages. At least one fault.
  BadScene(const std::string& name, std::vector<Fault> faults);

  const std::vector<Fault>& faults() const { return faults_; }

  /// A line for each fault, such as "a.json:3:8: /image/width: found 0, expected an integer from 1
  /// to 32768", in the order of the text; of very many the first, and how many there are more.
  std::vector<std::string> lines() const;

 private:
  std::string name_;
  std::vector<Fault> faults_;
};

}  // namespace aerostat::scene
