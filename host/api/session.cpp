#include "aerostat/session.hpp"

#include "aerostat/aerostat.hpp"
#include "api/state.hpp"
#include "core/log.hpp"
#include "opencl/device.hpp"
#include "render/scene_cache.hpp"
#include "render/self_test.hpp"
#include "render/session.hpp"
#include "scene/scene.hpp"
#include "world/resolve.hpp"

namespace aerostat {
namespace {

DeviceInfo info_of(const opencl::Device& device) {
  DeviceInfo info;
  info.selector = device.selector();
  info.name = device.name;
  info.platform = device.platform;
  info.driver = device.driver;
  info.type = opencl::type_name(device.type);
  info.memory_bytes = device.memory_bytes;
  info.compute_units = device.compute_units;
  info.lanes = device.lanes;
  return info;
}

std::vector<DeviceInfo> infos_of(const std::vector<opencl::Device>& devices) {
  std::vector<DeviceInfo> infos;
  for (const opencl::Device& device : devices) infos.push_back(info_of(device));
  return infos;
}

Stage stage_of(render::Stage stage) {
  switch (stage) {
    case render::Stage::world:
      return Stage::world;
    case render::Stage::tree:
      return Stage::trees;
    case render::Stage::kernels:
      return Stage::kernels;
    case render::Stage::upload:
      return Stage::upload;
    case render::Stage::rays:
      return Stage::rays;
    case render::Stage::done:
      return Stage::done;
  }
  return Stage::done;
}

render::Options render_options(const SessionOptions& options) {
  if (options.lanes != 0 && options.lanes != 1 && options.lanes != 4 && options.lanes != 8 &&
      options.lanes != 16) {
    throw Error(ErrorKind::usage, "SessionOptions::lanes is " + std::to_string(options.lanes) +
                                      "; expected 0, 1, 4, 8 or 16");
  }
  render::Options result;
  const std::string selector = opencl::effective_selector(options.device);
  render::SelfTest test;
  test.lanes = options.lanes;
  result.devices =
      options.self_test ? render::select_tested(selector, test) : opencl::select_devices(selector);
  result.lanes = options.lanes;
  result.memory_limit_bytes = options.memory_limit_bytes;
  result.use = options.interactive ? render::Use::interactive : render::Use::single_picture;
  result.guides = options.guides;
  result.cache = std::make_shared<render::SceneCache>();
  return result;
}

}  // namespace

std::vector<DeviceInfo> list_devices() {
  const opencl::DeviceList list = opencl::list_devices();
  for (const std::string& problem : list.problems) warn(problem);
  return infos_of(list.devices);
}

struct Session::State {
  explicit State(const SessionOptions& given) : options(render_options(given)), session(options) {}

  render::Options options;
  render::Session session;
};

Session::Session(const SessionOptions& options) : state_(std::make_unique<State>(options)) {
  state_->session.begin_kernels(scene::Integrator::local);
}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Film Session::render(const Scene& scene, const std::function<void(const Progress&)>& progress,
                     std::stop_token stop) {
  const scene::ResolvedScene resolved =
      world::resolve(scene.state().source.scene(), state_->options.cache->reliefs);
  render::ProgressCallback report;
  if (progress) {
    report = [&progress](const render::Progress& now) {
      progress({stage_of(now.stage), now.fraction, now.seconds});
    };
  }
  image::Film film = state_->session.render(resolved, std::move(stop), report);
  return Film(std::make_shared<Film::State>(Film::State{std::move(film), resolved->image}));
}

std::vector<DeviceInfo> Session::devices() const {
  return infos_of(state_->options.devices);
}

const char* version() {
  return AEROSTAT_VERSION;
}

std::function<void(const std::string&)> set_warning_handler(
    std::function<void(const std::string&)> handler) {
  return set_log_sink(std::move(handler));
}

}  // namespace aerostat
