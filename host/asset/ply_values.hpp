#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "asset/ply_header.hpp"

namespace aerostat::asset {

/// Reads the numbers of the body of a PLY file one by one, from text or from bytes.
class PlyValues {
 public:
  PlyValues(std::string_view bytes, const PlyHeader& header);

  /// Takes the next number. Throws Error{bad_data} with the line or the byte if there is none.
  double next(PlyType type);

  /// Takes the length of a list whose numbers have the type `type`. Throws Error{bad_data} if the
  /// file cannot hold so many.
  std::size_t next_length(PlyType count_type, PlyType type);

  /// Throws Error{bad_data} if the rest of the file cannot hold the elements of a kind.
  void require_room(const PlyElement& element) const;

  /// Throws Error{bad_data} that says what was found and expected behind the last number.
  [[noreturn]] void fail(std::string_view found, std::string_view expected) const;

 private:
  std::uint64_t least_bytes(PlyType type) const { return header_.is_text ? 2 : bytes_of(type); }
  std::size_t left() const { return bytes_.size() - at_; }
  double next_word();

  std::string_view bytes_;
  const PlyHeader& header_;
  std::size_t at_ = 0;    // the next byte
  std::size_t line_ = 0;  // of a text: the line of the next byte
};

}  // namespace aerostat::asset
