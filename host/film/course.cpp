#include "film/course.hpp"

#include <algorithm>
#include <cmath>

#include "core/smooth_step.hpp"

namespace aerostat::film {
namespace {

/// The time within which a balloon reaches half of its speed after take-off, the time for which the
/// burner heats before it, and that from one burst to the next. Chosen by eye.
constexpr double kSoft_s = 2.0, kHeating_s = 8.0, kBurst_s = 7.0;

std::uint64_t seed_of(std::uint32_t seed, std::size_t number) {
  return (std::uint64_t{seed} << 32) + number;
}

}  // namespace

double Launch::climbed(double at_s) const {
  const double since = std::max(at_s - time_s, 0.0);
  const double soft = since * since / (since + kSoft_s);
  return height_m > 0.0 ? height_m * -std::expm1(-climb_m_s * soft / height_m) : 0.0;
}

double Launch::burner(double at_s) const {
  const double since = at_s - time_s + kHeating_s;
  if (since < 0.0) return 0.0;
  const double need = 1.0 - 0.7 * climbed(at_s) / std::max(height_m, 1e-9);
  const double phase = since / kBurst_s - std::floor(since / kBurst_s);
  // A flame flares up and goes out within a tenth of the time between two.
  return smooth_unit_step(std::clamp(10.0 * phase, 0.0, 1.0)) *
         smooth_unit_step(std::clamp(10.0 * (0.75 * need - phase), 0.0, 1.0));
}

double launch_time(std::uint32_t seed, std::size_t number, double within_s) {
  return within_s * Random(seed_of(seed, number)).unit();
}

double Course::risen(double time_s, double climb_m_s) const {
  // A smooth step is fastest in its middle, by half more than in the mean.
  const double all_s = 1.5 * std::abs(rise_m) / climb_m_s;
  return all_s > 0.0 ? rise_m * smooth_unit_step(std::clamp(time_s / all_s, 0.0, 1.0)) : 0.0;
}

Courses::Courses(const scene::Festival& festival, const scene::Film& film, std::size_t number,
                 double height_m)
    : festival_(festival),
      film_(film),
      height_m_(height_m),
      first_s_(launch_time(festival.seed, number, film.launch_s)),
      random_(seed_of(festival.seed, number)) {}

Course Courses::next() {
  const bool is_first = tried_++ == 0, has_launch = film_.launch_s > 0.0;
  // Other times of take-off are tried before other heights.
  const bool is_given = is_first || (has_launch && tried_ <= kMost / 4);
  const double height_m =
      is_given ? height_m_ : random_.range(festival_.lowest_m, festival_.highest_m);
  if (!has_launch) return {std::nullopt, height_m - height_m_};
  const double time_s = is_first ? first_s_ : film_.launch_s * random_.unit();
  return {Launch{time_s, height_m, film_.climb_m_s}, 0.0};
}

}  // namespace aerostat::film
