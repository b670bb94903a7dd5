#include <algorithm>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <utility>

#include "core/stopwatch.hpp"
#include "image/write.hpp"
#include "pack/pack_scene.hpp"
#include "render/metering.hpp"
#include "render/session_state.hpp"
#include "render/settings.hpp"
#include "scene/scene.hpp"

namespace aerostat::render {

/// Renders the rows of a pass that wait. Returns false if the render ends at a pause.
bool Session::State::trace_pass(const Pass& pass, RowQueue& queue, const PassPlan& plan,
                                const FilmArea& area, const Course& course) {
  const auto rays_in_all = static_cast<double>(plan.rays());
  std::vector<RowRange> waiting;
  do {
    bool is_paused = false;
    const std::uint64_t rays_at_first = team.rays_done();
    const auto look = [&] {
      stats.rays[KernelStage::primary] = rays_before + team.rays_done();
      fraction_done =
          std::min(1.0, static_cast<double>(stats.rays[KernelStage::primary]) / rays_in_all);
      report(Stage::rays, fraction_done);
      // Something is done between two pauses, so that a render that always pauses comes to its end.
      if (is_paused || !course.wants_pause || team.rays_done() == rays_at_first) return;
      is_paused = course.wants_pause(progress_of(Stage::rays, fraction_done));
      if (is_paused) waiting = queue.pause();
    };
    team.trace(pass, queue, stop, [&] {
      watch_device();
      look();
    });
    stop_if_asked();
    // A pass of one short launch is over before anyone looked at it.
    look();
    if (!is_paused) break;
    if (!pause(pass, queue, waiting, area, course)) return false;
    queue.begin_pass(waiting);
  } while (!waiting.empty());
  return true;
}

/// Finds out whether the device still answers. It counts calls and not seconds, so that a process
/// that was stopped for a while is not taken for one whose device is lost.
void Session::State::watch_device() {
  const std::uint64_t rays = team.rays_done();
  times_idle = rays == rays_watched ? times_idle + 1 : 0;
  rays_watched = rays;
  const double idle_s = times_idle * std::chrono::duration<double>(kWaitingEvery).count();
  if (options.on_device_timeout && idle_s >= options.device_timeout_s) options.on_device_timeout();
}

/// Tells the caller that nothing is being launched, and returns whether the render goes on.
bool Session::State::pause(const Pass& pass, const RowQueue& queue,
                           const std::vector<RowRange>& waiting, const FilmArea& area,
                           const Course& course) {
  const bool is_pass_whole = waiting.empty();
  const bool is_last = pass.first_sample + pass.samples >= static_cast<int>(pass.frame.samples);
  if (is_pass_whole && is_last) return true;
  return course.at_pause({pass.first_sample, is_pass_whole || pass.first_sample > 0, fraction_done,
                          [&] { return read_sums_of(pass.first_sample, waiting, area, queue); }});
}

FilmSums Session::State::read_sums_of(int samples_done, std::vector<RowRange> waiting,
                                      const FilmArea& area, const RowQueue& queue) {
  FilmSums read = read_sums(team.film_rows(queue), area.window, layers_of(options) == Layers::all);
  read.samples_done = samples_done;
  read.waiting = std::move(waiting);
  read.metered_ev = metered_ev;
  return read;
}

/// Finds the exposure of all that the frame `metering` shows.
void Session::State::meter(const AeroFrame& metering) {
  const Stopwatch metering_watch;
  const auto width = static_cast<int>(metering.width), height = static_cast<int>(metering.height);
  const Crop all{0, 0, width, height};
  team.begin_film(all, Layers::light_alone);
  RowQueue queue(0, height, static_cast<int>(options.devices.size()));
  queue.begin_pass();
  const Pass pass{metering,
                  all,
                  0,
                  static_cast<int>(metering.samples),
                  options.tile_pixels,
                  launch_seconds_of(options.use)};
  team.trace(pass, queue, stop, [this] {
    watch_device();
    report(Stage::rays, 0.0);
  });
  stop_if_asked();
  const FilmArea area{width, height, all, all};
  metered_ev = image::automatic_exposure_ev(
      read_film(team.film_rows(queue), area, Layers::light_alone).film);
  stats.metering_seconds = metering_watch.seconds();
}

/// Fills an empty film with the sums of a former render.
void Session::State::take_sums(const FilmSums& sums, const PassPlan& plan, RowQueue& queue) {
  int rows_left = 0;
  for (const RowRange& rows : sums.waiting) rows_left += rows.y1 - rows.y0;
  rays_before = plan.rays_until(sums.samples_done, rows_left);
  metered_ev = sums.metered_ev;
  team.set_sums(sums);
  queue.hold_all(0);
}

/// Traces all passes that are left, or those before the pause at which the render ends.
void Session::State::trace_passes(const scene::Scene& scene, const AeroFrame& whole,
                                  const FilmArea& area, const PassPlan& plan, const Course& course,
                                  RowQueue& queue) {
  Pass pass{whole, {}, 0, 0, options.tile_pixels, launch_seconds_of(options.use)};
  const AeroConvergence convergence =
      convergence_of(scene.image, dvec3(daylight), window_of(area.window));
  const FilmSums* from = course.from.get();
  const int end = course.until > 0 ? std::min(course.until, scene.image.spp) : scene.image.spp;
  for (passes_done = from != nullptr ? from->samples_done : 0; passes_done < end;
       passes_done += pass.samples) {
    if (passes_done > 0) publish(read_passes(scene, area, queue));
    pass.area = plan.area_from(passes_done);
    pass.first_sample = passes_done;
    pass.samples = plan.samples_from(passes_done, end);
    if (from != nullptr) {
      queue.begin_pass(std::exchange(from, nullptr)->waiting);
    } else {
      if (plan.decides_before(passes_done)) team.mark_converged(convergence, queue);
      queue.begin_pass(pass.area.y0, pass.area.y1);
    }
    if (!trace_pass(pass, queue, plan, area, course)) return;
  }
  if (end == scene.image.spp || !course.at_pause) return;
  if (plan.decides_before(end)) team.mark_converged(convergence, queue);
  const Crop next = plan.area_from(end);
  course.at_pause({end, true, fraction_done, [&] {
                     return read_sums_of(end, {{next.y0, next.y1}}, area, queue);
                   }});
}

image::Film Session::State::trace(const scene::ResolvedScene& resolved, const Crop& crop,
                                  const Course& course) {
  const AeroFrame whole = pack::pack_frame(resolved, bounds);
  const scene::Scene& scene = *resolved;
  const AeroFrame metering = metering_frame(whole);
  const PassPlan plan = plan_of(scene.image, crop);
  const FilmArea area{scene.image.width, scene.image.height, plan.area_from(0), crop,
                      options.filtered ? side_weight_of(scene.image.filter) : 0.0f};
  const bool is_metered = options.contents != Contents::layers && !scene.image.exposure_ev;
  const bool meters_itself = takes_all_rays_of(metering, whole, crop, plan);
  if (is_metered && !meters_itself && !course.from) meter(metering);
  const Stopwatch rays_watch;
  team.begin_film(area.window, layers_of(options));
  RowQueue queue(area.window.y0, area.window.y1, static_cast<int>(options.devices.size()));
  if (course.from) {
    require_fitting(*course.from, area.window, scene.image.spp, layers_of(options) == Layers::all);
    take_sums(*course.from, plan, queue);
  }
  trace_passes(scene, whole, area, plan, course, queue);
  image::Film read = read_passes(scene, area, queue);
  if (is_metered && meters_itself) {
    // Metering sees pixels without their filter.
    FilmArea plain = area;
    plain.side_weight = 0.0f;
    metered_ev = read.metered_ev = image::automatic_exposure_ev(
        read_film(team.film_rows(queue), plain, Layers::light_alone).film);
  }
  finish(area, queue);
  stats.rays_seconds = rays_watch.seconds();
  return read;
}

image::Film Session::State::read_passes(const scene::Scene& scene, const FilmArea& area,
                                        const RowQueue& queue) {
  ReadFilm read = read_film(team.film_rows(queue), area, layers_of(options));
  read.film.daylight = daylight;
  read.film.metered_ev = metered_ev;
  stats.rays[KernelStage::primary] = read.samples;
  stats.rays[KernelStage::shadow] = shadow_rays_of(read.hits, scene);
  stats.rays[KernelStage::ambient] = scene.sky.ambient_occlusion ? read.hits : 0;
  return std::move(read.film);
}

void Session::State::publish(image::Film read) {
  const std::lock_guard lock(snapshot_mutex);
  latest = std::move(read);
}

/// Keeps a way to read the film again for snapshots. It stays on the devices until the next
/// render.
void Session::State::finish(const FilmArea& area, const RowQueue& queue) {
  const std::lock_guard lock(snapshot_mutex);
  latest = {};
  finished = [parts = team.film_rows(queue), area, light = daylight, ev = metered_ev,
              layers = layers_of(options)] {
    image::Film film = read_film(parts, area, layers).film;
    film.daylight = light;
    film.metered_ev = ev;
    return film;
  };
}

}  // namespace aerostat::render
