#include "asset/gltf_unread.hpp"

#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace aerostat::asset {
namespace {

constexpr std::uint64_t kUnsignedInt = 5125;

void check_not_empty(const JsonValue& list) {
  if (list.exists() && list.size() == 0) list.fail("at least one element");
}

void check_required(const JsonValue& value, const char* what) {
  if (!value.exists()) value.fail(what);
}

/// Returns the element of a list of the file that a value names.
JsonValue named(const JsonValue& root, const JsonValue& value, const char* list) {
  check_required(value, "an index");
  return root[list].at(value.index(root[list].size(), list));
}

void check_lists(const JsonValue& root) {
  for (const char* list : {"accessors", "animations", "bufferViews", "buffers", "cameras",
                           "extensionsRequired", "extensionsUsed", "images", "materials", "meshes",
                           "nodes", "samplers", "scenes", "skins", "textures"}) {
    check_not_empty(root[list]);
  }
  std::set<std::string> used;
  const JsonValue extensions = root["extensionsUsed"];
  for (std::size_t i = 0; i < extensions.size(); ++i) {
    if (!used.insert(extensions.at(i).text()).second) extensions.at(i).fail("each name once");
  }
}

void check_nodes(const JsonValue& root) {
  const JsonValue nodes = root["nodes"], scenes = root["scenes"];
  for (std::size_t i = 0; i < scenes.size(); ++i) check_not_empty(scenes.at(i)["nodes"]);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const JsonValue node = nodes.at(i);
    check_not_empty(node["children"]);
    if (node["camera"].exists()) named(root, node["camera"], "cameras");
    if (node["weights"].exists() && !node["mesh"].exists()) {
      node["mesh"].fail("a mesh for the weights");
    }
    const auto r = node["rotation"].numbers<4>({0.0, 0.0, 0.0, 1.0});
    const double length = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
    if (std::abs(length - 1.0) > 1e-3) node["rotation"].fail("a quaternion of length 1");
  }
}

void check_sampler(const JsonValue& root, const JsonValue& sampler) {
  const JsonValue input = named(root, sampler["input"], "accessors");
  named(root, sampler["output"], "accessors");
  if (input["type"].text() != "SCALAR" || input["componentType"].whole() != 5126) {
    sampler["input"].fail("an accessor of SCALAR floats");
  }
  for (const char* bound : {"min", "max"}) check_required(input[bound], "a bound of the times");
}

void check_animation(const JsonValue& root, const JsonValue& animation) {
  const JsonValue channels = animation["channels"], samplers = animation["samplers"];
  for (const JsonValue& list : {channels, samplers}) {
    check_required(list, "a list");
    check_not_empty(list);
  }
  for (std::size_t i = 0; i < samplers.size(); ++i) check_sampler(root, samplers.at(i));
  std::set<std::pair<std::uint64_t, std::string>> targets;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const JsonValue channel = channels.at(i), target = channel["target"];
    check_required(channel["sampler"], "an index");
    channel["sampler"].index(samplers.size(), "samplers");
    check_required(target["path"], "translation, rotation, scale or weights");
    if (!target["node"].exists()) continue;
    const JsonValue node = named(root, target["node"], "nodes");
    const std::string path = target["path"].text();
    if (node["matrix"].exists() && path != "weights") {
      target["node"].fail("a node without a matrix");
    }
    if (!targets.insert({target["node"].whole(), path}).second) {
      target.fail("another node or path than channels before");
    }
  }
}

void check_camera(const JsonValue& camera) {
  const std::string type = camera["type"].text();
  if (type != "perspective" && type != "orthographic") {
    camera["type"].fail("perspective or orthographic");
  }
  const JsonValue lens = camera[type];
  check_required(lens, "the camera's numbers");
  check_required(lens["znear"], "a distance");
  const double near = lens["znear"].number(0.0);
  if (lens["zfar"].exists() && lens["zfar"].number(0.0) <= near) {
    lens["zfar"].fail("more than znear");
  }
  if (type == "perspective") {
    check_required(lens["yfov"], "an angle");
    return;
  }
  for (const char* side : {"xmag", "ymag"}) {
    if (lens[side].number(0.0) == 0.0) lens[side].fail("a size that is not 0");
  }
}

void check_attributes(const JsonValue& root, const JsonValue& attributes) {
  int texcoords = 0;
  for (const std::string& key : attributes.keys()) {
    const JsonValue accessor = named(root, attributes[key], "accessors");
    if (accessor["componentType"].whole() == kUnsignedInt) {
      attributes[key].fail("an accessor of another type than unsigned int");
    }
    texcoords += key.starts_with("TEXCOORD_") ? 1 : 0;
  }
  for (int i = 0; i < texcoords; ++i) {
    const JsonValue coordinates = attributes["TEXCOORD_" + std::to_string(i)];
    check_required(coordinates, "texture coordinates with numbers that begin at 0");
  }
  if (!attributes["POSITION"].exists()) return;
  const JsonValue positions = named(root, attributes["POSITION"], "accessors");
  for (const char* bound : {"min", "max"}) check_required(positions[bound], "3 numbers");
}

void check_mesh(const JsonValue& root, const JsonValue& mesh) {
  const JsonValue primitives = mesh["primitives"];
  std::size_t targets = 0;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const JsonValue primitive = primitives.at(i), moved = primitive["targets"];
    check_attributes(root, primitive["attributes"]);
    if (i > 0 && moved.size() != targets) moved.fail("as many targets as in the first primitive");
    targets = moved.size();
  }
  if (mesh["weights"].exists() && mesh["weights"].size() != targets) {
    mesh["weights"].fail("a weight for each target");
  }
}

}  // namespace

void check_unread(const JsonValue& root) {
  check_lists(root);
  check_nodes(root);
  const auto check_all = [&root](const char* list, const auto& check) {
    for (std::size_t i = 0; i < root[list].size(); ++i) check(root[list].at(i));
  };
  check_all("animations", [&](const JsonValue& one) { check_animation(root, one); });
  check_all("cameras", check_camera);
  check_all("meshes", [&](const JsonValue& one) { check_mesh(root, one); });
  check_all("skins", [&](const JsonValue& one) {
    if (one["skeleton"].exists()) named(root, one["skeleton"], "nodes");
  });
}

}  // namespace aerostat::asset
