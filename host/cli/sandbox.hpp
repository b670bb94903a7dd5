#pragma once

#include "cli/options.hpp"

namespace aerostat::cli {

/// If the options ask for a sandbox, takes from this process all files but those that the command
/// needs, and all connections. Call it before threads are started. The process may read the folder
/// of the scene, that of the installed scenes, files of the command line, and the folders of the
/// system's programs and libraries; it may write to the folders of the outputs, those of compiled
/// kernels, and the devices of drivers. Throws Error{usage} if the system cannot confine programs
/// so.
void enter_sandbox(const RenderOptions& options);
void enter_sandbox(const ContactSheetOptions& options);
void enter_sandbox(const FilmOptions& options);
void enter_sandbox(const CheckOptions& options);
void enter_sandbox(const DumpOptions& options);
void enter_sandbox(const ExportOptions& options);
void enter_sandbox(const ArtworkOptions& options);

}  // namespace aerostat::cli
