#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "core/error.hpp"
#include "scene/bad_scene.hpp"

namespace {

int fail(int code, const char* message) {
  std::fprintf(stderr, "aerostat: %s\n", message);
  return code;
}

int exit_code(const aerostat::Error& error) {
  return error.kind() == aerostat::ErrorKind::interrupted ? aerostat::cli::interrupt_exit_code()
                                                          : error.exit_code();
}

}  // namespace

int main(int argc, char** argv) {
  // A reader of stdout that went away is an error to report, not a reason to die silently.
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return aerostat::cli::run(argc, argv);
  } catch (const aerostat::scene::BadScene& bad) {
    for (const std::string& line : bad.lines()) fail(bad.exit_code(), line.c_str());
    return bad.exit_code();
  } catch (const aerostat::Error& error) {
    return fail(exit_code(error), error.what());
  } catch (const std::bad_alloc&) {
    return fail(static_cast<int>(aerostat::ErrorKind::exhausted), "out of memory");
  } catch (const std::exception& error) {
    return fail(static_cast<int>(aerostat::ErrorKind::internal),
                fmt::format("internal error: {}", error.what()).c_str());
  } catch (...) {
    return fail(static_cast<int>(aerostat::ErrorKind::internal), "internal error");
  }
}
