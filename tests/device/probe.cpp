#include "probe.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

namespace aerostat::test {
namespace {

constexpr std::size_t kWidest = 16;

opencl::SourceTree sources_with_probes() {
  opencl::SourceTree tree = opencl::kernel_sources();
  const auto folder = std::filesystem::path(AEROSTAT_SOURCE_DIR) / "tests/device/probes";
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    std::ifstream stream(file.path(), std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (text.empty()) throw std::runtime_error("cannot read " + file.path().string());
    tree.emplace("probes/" + file.path().filename().string(), std::move(text));
  }
  return tree;
}

const opencl::Program& program_of(const std::string& name, int lanes) {
  static const opencl::SourceTree sources = sources_with_probes();
  // The programs are never destroyed, as the context is not, because drivers may be gone after
  // main.
  static auto& programs =
      *new std::map<std::pair<std::string, int>, std::unique_ptr<opencl::Program>>;
  auto& program = programs[{name, lanes}];
  if (program == nullptr) {
    program = std::make_unique<opencl::Program>(context(), sources, "probes/" + name, lanes);
  }
  return *program;
}

}  // namespace

const opencl::Context& context() {
  static const auto& instance =
      *new opencl::Context(opencl::select_device(opencl::effective_selector("")));
  return instance;
}

std::size_t whole_packets(std::size_t count) {
  return (count + kWidest - 1) / kWidest * kWidest;
}

std::vector<float> planes(const std::vector<vec3>& vectors) {
  const std::size_t count = whole_packets(vectors.size());
  std::vector<float> values(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const vec3& v = vectors[std::min(i, vectors.size() - 1)];
    for (int axis = 0; axis < 3; ++axis)
      values[static_cast<std::size_t>(axis) * count + i] = v[axis];
  }
  return values;
}

std::vector<float> padded(std::vector<float> values) {
  const float last = values.back();
  values.resize(whole_packets(values.size()), last);
  return values;
}

vec3 from_planes(const std::vector<float>& values, std::size_t i) {
  const std::size_t count = values.size() / 3;
  return {values[i], values[count + i], values[2 * count + i]};
}

Probe::Probe(const std::string& name, int lanes) : program_(&program_of(name, lanes)) {}

}  // namespace aerostat::test
