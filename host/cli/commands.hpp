#pragma once

#include "cli/options.hpp"

/// These functions are the commands of the program. Each returns the exit code of the process or
/// throws Error. Data go to stdout, and everything else goes to stderr.
namespace aerostat::cli {

/// Parses the command line and runs the command. Throws Error{usage}, whose one line names the
/// option, what was found and what was expected.
int run(int argc, const char* const* argv);

int render(RenderOptions options);
int contact_sheet(const ContactSheetOptions& options);
int make_film(const FilmOptions& options);
int merge(const MergeOptions& options);
int new_scene(const NewOptions& options);
int scenes(const ScenesOptions& options);
int devices(const DevicesOptions& options);
int check(const CheckOptions& options);
int dump(const DumpOptions& options);
int export_world(const ExportOptions& options);
int make_artwork(const ArtworkOptions& options);

}  // namespace aerostat::cli
