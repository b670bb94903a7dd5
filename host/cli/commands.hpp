#pragma once

#include "cli/options.hpp"

/// The commands. Each returns the exit code of the process or throws Error; data goes to stdout,
/// everything else to stderr.
namespace aerostat::cli {

/// Parses the command line and runs the command. Throws Error{usage} in one line that names the
/// option, what was found and what was expected.
int run(int argc, const char* const* argv);

int render(const RenderOptions& options);
int contact_sheet(const ContactSheetOptions& options);
int scenes(const ScenesOptions& options);
int devices(const DevicesOptions& options);
int check(const SceneOptions& options);
int dump(const SceneOptions& options);
int export_world(const ExportOptions& options);

}  // namespace aerostat::cli
