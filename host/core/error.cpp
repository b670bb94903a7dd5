#include "core/error.hpp"

namespace aerostat {

Error::Error(ErrorKind kind, const std::string& message)
    : std::runtime_error(message), kind_(kind) {}

}  // namespace aerostat
