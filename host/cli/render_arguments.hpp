#pragma once

#include <CLI/CLI.hpp>

#include "cli/options.hpp"

namespace aerostat::cli {

/// Adds the options of what computes: --device, --lanes, --memory-limit and --skip-self-test.
void add_device(CLI::App* command, DeviceOptions& options);

/// Adds the options of long renders: --time-limit, --save-partial, --checkpoint and
/// --checkpoint-every.
void add_long_render(CLI::App* command, RenderOptions& options);

/// Adds --shard. The command must have --crop.
void add_shard(CLI::App* command, RenderOptions& options);

/// Adds all of `merge`.
void add_merge(CLI::App* command, MergeOptions& options);

/// Adds the options on what a scene file from a stranger may do.
void add_safety(CLI::App* command, SceneOptions& options);

}  // namespace aerostat::cli
