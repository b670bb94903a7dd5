#pragma once

#include <string>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "track/read.hpp"

/// Helpers of the tests of tracks.
namespace aerostat::track {

/// Returns all notes as one text.
inline std::string notes_of(const Track& track) {
  std::string text;
  for (const std::string& note : track.notes) text += note + "\n";
  return text;
}

inline testing::AssertionResult says(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "'" << part << "' is not in: " << text;
}

/// Returns the message of the error of reading `bytes`, or an empty text if they can be read.
inline std::string complaint(const std::string& bytes, const ReadOptions& options = {}) {
  try {
    read_bytes(bytes, "x", options);
  } catch (const Error& error) {
    const bool is_expected =
        error.kind() == ErrorKind::bad_data || error.kind() == ErrorKind::usage;
    EXPECT_TRUE(is_expected) << error.what();
    return error.what();
  }
  return "";
}

}  // namespace aerostat::track
