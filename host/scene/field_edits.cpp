#include <array>
#include <string_view>
#include <type_traits>
#include <utility>

#include "scene/fields.hpp"

namespace aerostat::scene {

namespace {

using detail::Field;

/// Returns the sign of the unit that ends a key, or "" for a number without a unit.
const char* unit_of(std::string_view key) {
  constexpr std::pair<std::string_view, const char*> kUnits[] = {
      {"_per_m", ""}, {"_m", "m"}, {"_deg", "°"}, {"_ev", "EV"}, {"_k", "K"}, {"_du", "DU"},
  };
  for (const auto& [ending, sign] : kUnits) {
    if (key.ends_with(ending)) return sign;
  }
  return "";
}

/// Collects the edits of all fields with their pointers.
class Collector {
 public:
  template <class S>
  void add_object(const std::string& pointer) {
    detail::for_each_member<S>([&](const auto& field) { add(field, pointer + "/" + field.key); });
  }

  std::vector<FieldEdit> take() { return std::move(edits_); }

 private:
  template <class S, class T>
  void add(const Field<S, T>& field, const std::string& pointer) {
    if constexpr (requires { detail::kTable<T>.fields; }) {
      add_object<T>(pointer);
    } else {
      add_parts(pointer, std::type_identity<T>());
    }
    for (std::size_t i = 0; i < field.about.edit_count; ++i) {
      FieldEdit edit{field.about.edits[i], pointer};
      if (edit.editor == Editor::number && std::is_integral_v<T>) edit.editor = Editor::integer;
      if (field.about.edit_count > 1) edit.pointer.append("/").append(std::to_string(i));
      edit.unit = field.about.own_unit != nullptr ? field.about.own_unit : unit_of(field.key);
      edits_.push_back(edit);
    }
  }

  void add_parts(const std::string& pointer, std::type_identity<std::vector<PointLight>>) {
    add_object<PointLight>(pointer + "/0");
  }

  void add_parts(const std::string& pointer, std::type_identity<std::vector<PlacedModel>>) {
    add_object<PlacedModel>(pointer + "/0");
  }

  void add_parts(const std::string& pointer,
                 std::type_identity<std::array<Material, kMaterialCount>>) {
    add_object<Material>(pointer + "/" + material_name(MaterialId::envelope));
  }

  template <class T>
  void add_parts(const std::string&, std::type_identity<T>) {}

  std::vector<FieldEdit> edits_;
};

}  // namespace

const std::vector<FieldEdit>& field_edits() {
  static const std::vector<FieldEdit> edits = [] {
    Collector collector;
    collector.add_object<Scene>("");
    return collector.take();
  }();
  return edits;
}

}  // namespace aerostat::scene
