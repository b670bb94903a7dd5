#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scene/overrides.hpp"
#include "scene/read.hpp"

namespace aerostat::scene::detail {

namespace {

/// Calls `visit` with each name of a file in a document, and with its pointer.
void for_named_files(Json& document, const std::function<void(Json&, const Pointer&)>& visit) {
  if (!document.is_object()) return;
  const auto visit_at = [&visit](Json& in, Pointer pointer, const Pointer& rest) {
    Json* value = &in;
    for (const std::string& key : rest) {
      if (!value->is_object() || !value->contains(key)) return;
      value = &(*value)[key];
      pointer.push_back(key);
    }
    if (value->is_string() && *value != "") visit(*value, pointer);
  };
  const auto visit_list = [&](Json& owner, const Pointer& pointer, const char* list,
                              const auto& visit_one) {
    if (!owner.is_object() || !owner.contains(list) || !owner[list].is_array()) return;
    std::size_t i = 0;
    for (Json& one : owner[list]) {
      Pointer at = pointer;
      at.emplace_back(list);
      at.push_back(std::to_string(i++));
      visit_one(one, at);
    }
  };
  const auto visit_file = [&](Json& one, const Pointer& at) { visit_at(one, at, {"file"}); };
  const auto visit_balloon = [&](Json& balloon, const Pointer& at) {
    visit_at(balloon, at, {"track", "file"});
    visit_list(balloon, at, "artwork", visit_file);
    visit_at(balloon, at, {"envelope", "file"});
  };
  if (has_source(document)) {
    visit_list(document["terrain"], {"terrain"}, "source",
               [&](Json& name, const Pointer& at) { visit_at(name, at, {}); });
    visit_at(document, {}, {"terrain", "drape", "file"});
    visit_at(document, {}, {"terrain", "cover", "source"});
  }
  visit_list(document, {}, "objects", visit_file);
  if (document.contains("vegetation")) {
    visit_list(document["vegetation"], {"vegetation"}, "species", visit_file);
  }
  if (document.contains("balloon")) visit_balloon(document["balloon"], {"balloon"});
  visit_list(document, {}, "balloons", visit_balloon);
}

}  // namespace

void name_files_from(const std::filesystem::path& folder, Json& document) {
  if (folder.empty()) return;
  for_named_files(document, [&folder](Json& name, const Pointer&) {
    const std::filesystem::path path = folder / name.get<std::string>();
    name = std::filesystem::absolute(path).lexically_normal().string();
  });
}

void name_files_below(const std::filesystem::path& folder, Json& document) {
  for_named_files(document, [&folder](Json& name, const Pointer&) {
    const std::filesystem::path path = name.get<std::string>();
    if (!path.is_absolute()) return;
    const auto below =
        path.lexically_relative(std::filesystem::absolute(folder).lexically_normal());
    if (!below.empty() && *below.begin() != "..") name = below.generic_string();
  });
}

std::vector<std::string> absolute_files(Json& document) {
  std::vector<std::string> names;
  for_named_files(document, [&names](Json& name, const Pointer&) {
    if (std::filesystem::path(name.get<std::string>()).is_absolute()) {
      names.push_back(name.get<std::string>());
    }
  });
  return names;
}

void require_files_below(Json& document, Faults& faults) {
  for_named_files(document, [&faults](Json& name, const Pointer& pointer) {
    const auto path = std::filesystem::path(name.get<std::string>()).lexically_normal();
    if (!path.is_absolute() && *path.begin() != "..") return;
    faults.add(pointer, name.dump(),
               "a file in the folder of the scene or below it, or --allow-external-paths");
  });
}

}  // namespace aerostat::scene::detail
