#include "cli/render_arguments.hpp"

#include <string>

#include "cli/parse.hpp"
#include "cli/validators.hpp"
#include "film/frames.hpp"

namespace aerostat::cli {

void add_device(CLI::App* command, DeviceOptions& options) {
  command
      ->add_option("--device", options.selector,
                   "platform:device, part of a name, cpu, gpu or auto; or several, 0:0,1:0; all; "
                   "or parts of one, 0:0/2 (below)")
      ->type_name("SEL");
  command
      ->add_option("--lanes", options.lanes,
                   "Rays per work-item, 1, 4, 8 or 16; by default what the device prefers")
      ->check(one_of({"1", "4", "8", "16"}))
      ->type_name("N");
  command
      ->add_option_function<std::string>(
          "--memory-limit",
          [&options](const std::string& text) {
            options.memory_limit_bytes = parse_byte_size(text);
          },
          "Most memory to take on each device: whole bytes, or a number with K, M, G or T (powers "
          "of 1024), such as 1.5G")
      ->type_name("SIZE");
  command->add_flag("--skip-self-test", options.skip_self_test,
                    "Do not test whether a device computes what it should when it is used for the "
                    "first time");
}

void add_long_render(CLI::App* command, RenderOptions& options) {
  command
      ->add_option_function<std::string>(
          "--time-limit",
          [&options](const std::string& text) { options.time_limit_s = parse_duration(text); },
          "End after this time, such as 90s, 10m or 2h, with the picture so far; the first sample "
          "of each pixel is always taken")
      ->type_name("TIME");
  command->add_flag("--save-partial", options.save_partial,
                    "On Ctrl-C, write the picture so far before the end");
  CLI::Option* const checkpoint =
      command
          ->add_option("--checkpoint", options.checkpoint,
                       "Save the samples to this file every minute and at an early end; the same "
                       "command goes on with them")
          ->type_name("FILE");
  command
      ->add_option_function<std::string>(
          "--checkpoint-every",
          [&options](const std::string& text) {
            options.checkpoint_every_s = parse_duration(text, "--checkpoint-every");
          },
          "The time between two savings, such as 10s or 15m; by default 60s")
      ->needs(checkpoint)
      ->type_name("TIME");
}

void add_shard(CLI::App* command, RenderOptions& options) {
  command
      ->add_option_function<std::string>(
          "--shard",
          [&options](const std::string& text) { options.shard = film::parse_shard(text); },
          "Render only one of several bands of rows, such as 3/8, to an .exr file that 'aerostat "
          "merge' joins with the others; a band that is there is kept")
      ->excludes("--crop")
      ->type_name("K/N");
}

void add_merge(CLI::App* command, MergeOptions& options) {
  command
      ->add_option("FILE", options.bands,
                   "The .exr files of 'aerostat render --shard', in any order")
      ->required()
      ->type_name("");
  command->add_option("-o,--output", options.output, "x.png or x.exr")
      ->required()
      ->type_name("FILE");
  command->add_flag("--quiet,-q", options.quiet, "Print only errors");
}

void add_safety(CLI::App* command, SceneOptions& options) {
  command->add_flag("--allow-external-paths", options.allow_external_paths,
                    "Let the scene file name files outside of its folder");
  command
      ->add_flag("--sandbox", options.sandbox,
                 "Let the system keep aerostat from all files but those of the scene's folder, the "
                 "outputs and drivers, and from the network")
      ->excludes("--allow-external-paths");
}

}  // namespace aerostat::cli
