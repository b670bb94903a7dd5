#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

/// Makes damaged copies of scene files.
namespace aerostat::test {

/// Makes texts out of those of a corpus. The same seed gives the same texts.
class Mutator {
 public:
  Mutator(std::vector<std::string> corpus, std::uint32_t seed);

  /// Returns a text of the corpus with one to eight changes of bytes, pieces, or values and keys of
  /// the JSON.
  std::string next();

  /// Returns a text that could stand behind --set.
  std::string next_override();

 private:
  std::size_t below(std::size_t count);
  const std::string& any_text() { return corpus_[below(corpus_.size())]; }
  void change_bytes(std::string& text);
  void change_piece(std::string& text);
  void change_token(std::string& text);

  std::vector<std::string> corpus_;
  std::mt19937 random_;
};

}  // namespace aerostat::test
