#pragma once

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace aerostat::test {

/// The error that `f` ends in; fails the test if it ends well.
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
