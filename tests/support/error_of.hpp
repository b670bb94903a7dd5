#pragma once

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace aerostat::test {

/// Returns the error that `f` throws. Fails the test if `f` throws none.
template <typename F>
Error error_of(F&& f) {
  try {
    f();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was thrown";
  return {ErrorKind::internal, "nothing was thrown"};
}

}  // namespace aerostat::test
