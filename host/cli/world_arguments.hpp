#pragma once

#include "cli/options.hpp"

namespace CLI {
class App;
}

namespace aerostat::cli {

/// Adds the options of the command export, apart from the scene.
void add_export_options(CLI::App* command, ExportOptions& options);

/// Adds the options of the command artwork, apart from changes of the scene.
void add_artwork_options(CLI::App* command, ArtworkOptions& options);

}  // namespace aerostat::cli
