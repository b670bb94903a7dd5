#include <cstdint>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/help_layout.hpp"
#include "cli/help_text.hpp"
#include "cli/parse.hpp"
#include "cli/render_arguments.hpp"
#include "cli/sandbox.hpp"
#include "cli/scene_input.hpp"
#include "cli/validators.hpp"
#include "cli/world_arguments.hpp"
#include "core/error.hpp"
#include "film/encoder.hpp"
#include "film/frames.hpp"

namespace aerostat::cli {

namespace {

constexpr int kLargestSide = 32768;
constexpr int kMostSamples = 65536;
constexpr std::int64_t kLargestSeed = 0xffffffffu;

/// The command line as a tree of options whose values are written to the structs.
class Arguments {
 public:
  Arguments() : app_(kDescription, "aerostat") {
    app_.footer(kMainFooter);
    app_.set_version_flag("--version", std::string("aerostat ") + AEROSTAT_VERSION,
                          "Print the version and exit");
    app_.require_subcommand(1);
    app_.get_formatter()->column_width(
        static_cast<std::size_t>(description_column(help_columns())));
    app_.get_formatter()->label("REQUIRED", "");
    app_.get_formatter()->label("SUBCOMMAND", "COMMAND");
    app_.get_formatter()->label("Subcommands", "Commands");
    app_.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    add_render();
    add_contact_sheet();
    add_film();
    add_merge(add("merge", "Join the bands of a large picture", kMergeFooter,
                  [this] { return merge(merge_); }),
              merge_);
    add_new();
    add_scenes();
    add_devices();
    add_check();
    add_dump();
    add_export();
    add_artwork();
  }

  /// Returns the command to run. Throws CLI::ParseError.
  std::function<int()> parse(int argc, const char* const* argv) {
    app_.parse(argc, argv);
    return command_;
  }

  CLI::App& app() { return app_; }

  /// Returns what is wrong, in words. CLI11 calls an unknown command a missing one.
  std::string complaint(const CLI::ParseError& error, int argc, const char* const* argv) {
    if (!app_.get_subcommands().empty()) return error.what();
    const std::string commands =
        "render, contact-sheet, film, merge, new, scenes, devices, check, dump, export or artwork";
    if (argc < 2) return fmt::format("no command; expected {}", commands);
    if (argv[1][0] == '-') return error.what();
    return fmt::format("there is no command '{}'; expected {}", argv[1], commands);
  }

  /// Returns the command that prints the help for the command that was parsed.
  std::string help_command() {
    const auto chosen = app_.get_subcommands();
    return chosen.empty() ? "aerostat --help"
                          : fmt::format("aerostat {} --help", chosen.front()->get_name());
  }

 private:
  CLI::App* add(const char* name, const char* description, const char* footer,
                std::function<int()> command) {
    CLI::App* sub = app_.add_subcommand(name, description);
    sub->footer(footer);
    sub->callback([this, command = std::move(command)] { command_ = command; });
    return sub;
  }

  template <typename Run, typename Options>
  static int confined(Run run, const Options& options) {
    enter_sandbox(options);
    return run(options);
  }

  static void add_scene(CLI::App* sub, SceneOptions& options) {
    sub->add_option(
           "SCENE", options.scene,
           "Scene file (JSON with comments), a file or folder of elevation data, the name of "
           "a scene that came with aerostat, such as snow (see 'aerostat scenes'), or - for "
           "standard input")
        ->required()
        ->type_name("");
    add_overrides(sub, options);
    add_safety(sub, options);
  }

  static void add_overrides(CLI::App* sub, SceneOptions& options) {
    sub->add_option("--set", options.overrides,
                    "Change the scene; the value is JSON or else text. Can be repeated; the "
                    "last one wins")
        ->allow_extra_args(false)
        ->take_all()
        ->type_name("POINTER=VALUE");
  }

  void add_render() {
    CLI::App* sub = add("render", "Render a scene to a PNG, EXR or GeoTIFF file", kRenderFooter,
                        [this] { return confined(render, render_); });
    add_scene(sub, render_.input);
    sub->add_option(
           "-o,--output", render_.output,
           "x.png (8-bit sRGB), x.exr (linear R G B A, Z, N, albedo, id, samples), x.tif (a map "
           "in the grid of its elevation data), or - for standard output; by default the scene's "
           "name and .png, in this folder")
        ->type_name("FILE");
    add_format(
        sub, render_.format, {"png", "exr", "tif"},
        "File format, png, exr or tif; by default the one that the name ends in, png for -o -");
    add_image(sub);
    sub->add_flag("--denoise", render_.denoise,
                  "Take the noise out of the picture with Open Image Denoise 2, which must be "
                  "installed");
    add_labels(sub);
    add_long_render(sub, render_);
    add_device(sub, render_.device);
    add_quiet(sub, render_.quiet);
    sub->add_flag("--stats", render_.stats, "Report rays, times and memory on stderr");
  }

  void add_labels(CLI::App* sub) {
    sub->add_option("--labels", render_.labels,
                    "On real land, name the places of a GeoJSON or CSV file that are in sight, in "
                    "x.svg beside x.png")
        ->type_name("FILE");
    sub->add_option("--labels-json", render_.labels_json,
                    "Write pixel, distance and whether hidden of each of these places to a .json "
                    "file, or - for standard output")
        ->type_name("FILE");
    sub->add_flag("--world-file", render_.world_file,
                  "On real land, seen orthographically from straight above, write x.pgw and x.prj "
                  "beside x.png, which tell programs for maps where it lies");
  }

  static void add_size(CLI::App* sub, std::optional<int>& width, std::optional<int>& height) {
    CLI::Validator side = in_range(1, kLargestSide);
    sub->add_option("--width", width, "Pixels across, 1 to 32768; overrides the scene")
        ->transform(side)
        ->type_name("W");
    sub->add_option("--height", height, "Pixels down, 1 to 32768; overrides the scene")
        ->transform(side)
        ->type_name("H");
  }

  void add_image(CLI::App* sub) {
    add_size(sub, render_.width, render_.height);
    add_quality(sub, render_.quality);
    sub->add_option("--spp", render_.spp,
                    "Samples per pixel, 1 to 65536; a single one passes through the pixel's centre")
        ->transform(in_range(1, kMostSamples))
        ->type_name("N");
    sub->add_option("--seed", render_.seed, "Seed of the samples, 0 to 4294967295")
        ->transform(in_range(0, kLargestSeed))
        ->type_name("S");
    sub->add_option_function<std::string>(
           "--crop", [this](const std::string& text) { render_.crop = parse_crop(text); },
           "Render only x0 <= x < x1 and y0 <= y < y1, in pixels from the top left")
        ->type_name("X0,Y0,X1,Y1");
    add_shard(sub, render_);
  }

  static void add_format(CLI::App* sub, std::string& format, const std::vector<std::string>& words,
                         const char* description) {
    sub->add_option("--format", format, description)->check(one_of(words))->type_name("F");
  }

  static void add_quality(CLI::App* sub, std::string& quality) {
    sub->add_option("--quality", quality,
                    "draft, standard or final: samples, soft shadows and ambient occlusion where "
                    "the scene does not set them")
        ->check(one_of({"draft", "standard", "final"}))
        ->type_name("Q");
  }

  static void add_quiet(CLI::App* sub, bool& quiet) {
    sub->add_flag("--quiet,-q", quiet, "Print only errors");
  }

  void add_contact_sheet() {
    CLI::App* sub = add("contact-sheet", "Render a scene with many terrain seeds onto one sheet",
                        kContactSheetFooter, [this] { return confined(contact_sheet, sheet_); });
    add_scene(sub, sheet_.input);
    sub->add_option_function<std::string>(
           "--seeds", [this](const std::string& text) { sheet_.seeds = parse_seeds(text); },
           "Seeds and ranges of seeds, one a tile, such as 1,5,9-11; by default 1-12")
        ->type_name("LIST");
    sub->add_option(
           "--views", sheet_.views,
           "On real land, show so many views in place of seeds, 1 to 1000, the best one first")
        ->transform(in_range(1, kMostTiles))
        ->excludes("--seeds")
        ->type_name("N");
    sub->add_option("-o,--output", sheet_.output,
                    "A .png file, or - for standard output; by default the scene's name and "
                    "-seeds.png, in this folder")
        ->type_name("FILE");
    sub->add_option("--columns", sheet_.columns,
                    "Tiles across, 1 to 1000; by default chosen by their number")
        ->transform(in_range(1, kMostTiles))
        ->type_name("N");
    sub->add_option("--tile-width", sheet_.tile_width,
                    "Pixels across a tile, 1 to 32768; by default 320. Its height follows from the "
                    "scene's picture")
        ->transform(in_range(1, kLargestSide))
        ->type_name("W");
    add_quality(sub, sheet_.quality);
    add_device(sub, sheet_.device);
    add_quiet(sub, sheet_.quiet);
  }

  void add_film() {
    CLI::App* sub = add("film", "Render the film of a scene", kFilmFooter,
                        [this] { return confined(make_film, film_); });
    add_scene(sub, film_.input);
    sub->add_option(
           "-o,--output", film_.output,
           "x.mp4, .mov, .mkv or .webm, whose frames are kept in x.frames, or the frames "
           "themselves, such as frames/####.png or frames/####.exr; by default the scene's "
           "name and .mp4, in this folder")
        ->type_name("FILE");
    add_frames(sub);
    sub->add_option(
           "--codec", film_.codec,
           "h264, av1, prores (.mov) or lossless (.mkv); by default h264, or av1 for .webm")
        ->check(one_of(film::codec_names()))
        ->type_name("C");
    add_size(sub, film_.width, film_.height);
    add_quality(sub, film_.quality);
    sub->add_flag("--preview", film_.preview,
                  "Render small frames of one sample, 480 pixels across; those of x.mp4 go to "
                  "x.preview-frames");
    add_device(sub, film_.device);
    add_quiet(sub, film_.quiet);
  }

  void add_frames(CLI::App* sub) {
    sub->add_option_function<std::string>(
           "--frames", [this](const std::string& text) { film_.frames = film::parse_frames(text); },
           "Only these frames, which count from 1: 17, 1-500, 100-, or 1-500:2 for every second "
           "one")
        ->type_name("LIST");
    sub->add_option_function<std::string>(
           "--shard", [this](const std::string& text) { film_.shard = film::parse_shard(text); },
           "Only one of several equal parts of the frames, such as 3/8; makes frames and no film")
        ->type_name("K/N");
    sub->add_option_function<std::string>(
           "--time-limit",
           [this](const std::string& text) { film_.time_limit_s = parse_duration(text); },
           "Begin no further frame after this time, such as 90s, 10m or 2h, and exit with 75 if "
           "frames are left")
        ->type_name("TIME");
    sub->add_flag(
        "--verify", film_.verify,
        "Make nothing; list the frames that are missing, broken or foreign, and exit with "
        "65 if there are any");
  }

  void add_new() {
    CLI::App* sub = add("new", "Write a scene around a file of elevation data", kNewFooter,
                        [this] { return new_scene(new_); });
    sub->add_option("FILE", new_.input.scene,
                    "File of elevation data (GeoTIFF, .hgt, .asc, DTED and others), or a folder of "
                    "them")
        ->required()
        ->type_name("");
    add_overrides(sub, new_.input);
    sub->add_option(
           "-o,--output", new_.output,
           "A .json file, or - for standard output; by default the file's name and .json, in "
           "this folder, if there is none yet")
        ->type_name("FILE");
    sub->add_option("--view", new_.view, "Which of the views to take, 1 (the best) to 1000")
        ->transform(in_range(1, kMostTiles))
        ->type_name("N");
  }

  void add_scenes() {
    CLI::App* sub = add("scenes", "List the scenes that came with aerostat", kScenesFooter,
                        [this] { return scenes(scenes_); });
    sub->add_flag("--folder", scenes_.folder, "Print only the folder that they are in");
  }

  void add_devices() {
    CLI::App* sub = add("devices", "List OpenCL platforms and devices", kDevicesFooter,
                        [this] { return devices(devices_); });
    sub->add_flag("--json", devices_.json, "Print JSON");
  }

  void add_check() {
    CLI::App* sub = add("check", "Validate a scene, or report on elevation data or a flight track",
                        kCheckFooter, [this] { return confined(check, check_); });
    add_scene(sub, check_.input);
    sub->add_flag("--json", check_.json, "Print the report on elevation data or a track as JSON");
    sub->add_option("--device", check_.device,
                    "Print what memory a render of the scene needs, and compare it with what this "
                    "device has; it is chosen as for 'render'")
        ->type_name("SEL");
    sub->add_option("--land", check_.land,
                    "Elevation data below a track: fit its heights to the ground and say how")
        ->type_name("FILE");
  }

  void add_dump() {
    CLI::App* sub = add("dump", "Print the resolved scene with every default filled in, as JSON",
                        kDumpFooter, [this] { return confined(dump, dump_); });
    add_scene(sub, dump_.input);
    sub->add_flag("--view", dump_.view,
                  "Instead, print what another renderer needs beside exported triangles: the axes "
                  "and the fields of view of the camera, the sun and the sky, as JSON");
  }

  void add_export() {
    CLI::App* sub = add("export", "Write the world's triangles, as they are rendered, to a file",
                        kExportFooter, [this] { return confined(export_world, export_); });
    add_scene(sub, export_.input);
    add_export_options(sub, export_);
  }

  void add_artwork() {
    CLI::App* sub = add("artwork", "Write a template for artwork on the envelope", kArtworkFooter,
                        [this] { return confined(make_artwork, artwork_); });
    add_artwork_options(sub, artwork_);
    add_overrides(sub, artwork_.input);
    add_safety(sub, artwork_.input);
  }

  CLI::App app_;
  std::function<int()> command_;
  RenderOptions render_;
  ContactSheetOptions sheet_;
  FilmOptions film_;
  MergeOptions merge_;
  NewOptions new_;
  ScenesOptions scenes_;
  DevicesOptions devices_;
  CheckOptions check_;
  DumpOptions dump_;
  ExportOptions export_;
  ArtworkOptions artwork_;
};

// Prints the help or the version. CLI11 reports a request for them as an exception.
int answer(CLI::App& app, const CLI::ParseError& request) {
  std::ostringstream text, ignored;
  app.exit(request, text, ignored);
  write_stdout(wrapped(text.str(), help_columns()));
  return 0;
}

}  // namespace

int run(int argc, const char* const* argv) {
  Arguments arguments;
  std::function<int()> command;
  try {
    command = arguments.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return answer(arguments.app(), request);
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorKind::usage,
                fmt::format("{} (see '{}')", arguments.complaint(error, argc, argv),
                            arguments.help_command()));
  }
  return command();
}

}  // namespace aerostat::cli
