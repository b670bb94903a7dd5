#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/parse.hpp"
#include "cli/picture.hpp"
#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/stop_scope.hpp"
#include "core/stopwatch.hpp"
#include "image/sheet.hpp"
#include "render/scene_cache.hpp"
#include "scene/scene.hpp"
#include "staging/stage.hpp"

namespace aerostat::cli {

namespace {

namespace fs = std::filesystem;

fs::path output_of(const ContactSheetOptions& options) {
  if (options.output.empty()) return default_picture(options.input.scene, "-seeds.png");
  if (picture_format(options.output) != PictureFormat::png) {
    throw Error(ErrorKind::usage, fmt::format("--output: a contact sheet is a .png, not '{}'",
                                              options.output.string()));
  }
  return options.output;
}

/// A picture of the sheet.
struct Tile {
  scene::Scene scene;
  std::string label;   // for progress
  std::string number;  // below the picture
};

/// Gives the pictures the shape of the scene's picture.
void settle_size(const ContactSheetOptions& options, scene::Image& image) {
  const double shape = static_cast<double>(image.height) / image.width;
  image.width = options.tile_width;
  image.height = std::max(1, static_cast<int>(std::lround(options.tile_width * shape)));
}

SceneOptions input_of(const ContactSheetOptions& options) {
  SceneOptions input = options.input;
  if (!options.quality.empty()) input.overrides.emplace_back("/quality=" + options.quality);
  return input;
}

std::vector<Tile> tiles_of_seeds(const ContactSheetOptions& options, world::ReliefCache& reliefs) {
  const scene::Scene scene = read_scene(input_of(options), reliefs);
  std::vector<Tile> tiles;
  for (const std::uint32_t seed : options.seeds.empty() ? parse_seeds("1-12") : options.seeds) {
    tiles.push_back({scene, fmt::format("seed {}", seed), std::to_string(seed)});
    tiles.back().scene.terrain.seed = seed;
  }
  return tiles;
}

std::vector<Tile> tiles_of_views(const ContactSheetOptions& options, world::ReliefCache& reliefs) {
  const scene::SceneSource source = read_source(input_of(options));
  if (source.scene().terrain.kind != scene::TerrainKind::elevation) {
    throw Error(
        ErrorKind::usage,
        "--views: only real land has views to choose from, and this ground is made from noise");
  }
  std::vector<Tile> tiles;
  for (const staging::Staged& staged : staging::stage_views(source, reliefs, options.views)) {
    const std::string number = std::to_string(tiles.size() + 1);
    tiles.push_back({staged.source.scene(), "view " + number, number});
  }
  return tiles;
}

std::vector<Tile> tiles_of(const ContactSheetOptions& options, world::ReliefCache& reliefs) {
  auto tiles =
      options.views > 0 ? tiles_of_views(options, reliefs) : tiles_of_seeds(options, reliefs);
  for (Tile& tile : tiles) settle_size(options, tile.scene.image);
  return tiles;
}

image::SheetLayout layout_of(const ContactSheetOptions& options, const scene::Image& tile,
                             std::size_t count) {
  const image::SheetLayout layout =
      image::layout_sheet(static_cast<int>(count), tile.width, tile.height, options.columns);
  if (image::png_can_hold(layout.width(), layout.height())) return layout;
  throw Error(ErrorKind::usage,
              fmt::format("a sheet of {} x {} pixels is too large for a PNG; take fewer tiles or a "
                          "smaller --tile-width",
                          layout.width(), layout.height()));
}

/// Renders one tile after another with one session. Progress counts all tiles.
class SheetRender {
 public:
  /// The options must name a cache.
  SheetRender(const render::Options& options, ProgressBar& bar)
      : cache_(options.cache), session_(options), bar_(bar) {
    session_.begin_kernels(scene::Integrator::local);
  }

  image::Sheet render(const SceneOptions& input, const std::vector<Tile>& tiles,
                      const image::SheetLayout& layout, const std::stop_token& stop) {
    image::Sheet sheet(layout);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      const scene::Scene& tile = tiles[i].scene;
      const auto label = fmt::format("{}, {} of {}", tiles[i].label, i + 1, tiles.size());
      bar_.set_label(label);
      show(i, tiles.size(), 0.0);
      const scene::ResolvedScene resolved = resolve_scene(tile, input, cache_->reliefs);
      const image::Film film =
          session_.render(resolved, stop, [&](const render::Progress& progress) {
            const bool is_compiling = progress.stage == render::Stage::kernels;
            bar_.set_label(is_compiling ? "" : label);
            if (is_compiling) return show_compiling(progress);
            const bool is_traced = progress.stage >= render::Stage::rays;
            show(i, tiles.size(), is_traced ? progress.fraction : 0.0);
          });
      warn_of_nan(film);
      sheet.place(static_cast<int>(i), develop(film, tile.image), tiles[i].number);
    }
    return sheet;
  }

 private:
  void show(std::size_t tile, std::size_t count, double fraction) {
    const double done = (static_cast<double>(tile) + fraction) / static_cast<double>(count);
    bar_.update({render::Stage::rays, done, 0, watch_.seconds(), 0});
  }

  void show_compiling(render::Progress progress) {
    progress.seconds = watch_.seconds();
    bar_.update(progress);
  }

  std::shared_ptr<render::SceneCache> cache_;
  render::Session session_;
  ProgressBar& bar_;
  Stopwatch watch_;
};

}  // namespace

int contact_sheet(const ContactSheetOptions& options) {
  const Stopwatch watch;
  const fs::path output = output_file(output_of(options), options.input, true);
  const Interrupt interrupt;
  ProgressBar bar(stderr_style(options.quiet), print_stderr);
  const WarningsAbove warnings(bar, options.quiet);

  const auto cache = std::make_shared<render::SceneCache>();
  const std::vector<Tile> tiles = tiles_of(options, cache->reliefs);
  const scene::Scene& first = tiles[0].scene;
  const scene::Image& image = first.image;
  const image::SheetLayout layout = layout_of(options, image, tiles.size());
  render::Options session_options =
      session_options_of(options.device, self_test_of(first.light, interrupt.token(), bar));
  session_options.cache = cache;
  SheetRender sheet_render(session_options, bar);
  const image::Sheet sheet = sheet_render.render(options.input, tiles, layout, interrupt.token());
  bar.clear();
  const auto bytes = image::encode_png(sheet.pixels());
  stop_if_asked(interrupt.token());
  write_file(output, bytes);
  if (!options.quiet) {
    bar.message(fmt::format("wrote {} ({} tiles of {} x {}, {} spp) in {:.1f} s on {}",
                            name_of_output(output), tiles.size(), layout.tile_width,
                            layout.tile_height, image.spp, watch.seconds(),
                            names_of(session_options.devices)));
  }
  return 0;
}

}  // namespace aerostat::cli
