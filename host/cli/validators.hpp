#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

/// Checks of single values of the command line.
namespace aerostat::cli {

/// Returns a validator for `transform` that accepts whole numbers in decimal digits. Leading
/// zeros are dropped, because CLI11 would take such numbers for octal. CLI11's own ranges word
/// their errors differently in each version. The help texts state the ranges.
CLI::Validator in_range(std::int64_t least, std::int64_t most);

/// Returns a validator that accepts only these words.
CLI::Validator one_of(const std::vector<std::string>& words);

}  // namespace aerostat::cli
