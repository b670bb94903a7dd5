#include "scene/schema.hpp"

#include <iterator>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "core/error.hpp"
#include "scene/expected.hpp"

namespace aerostat::scene::detail {

namespace {

using Adapter = valijson::adapters::NlohmannJsonAdapter;

/// The schema as a document, which messages use, and as the constraints of valijson.
struct SceneSchema {
  SceneSchema() : document(make_schema()) {
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(Adapter(document), constraints);
  }

  Json document;
  valijson::Schema constraints;
};

const SceneSchema& scene_schema() {
  static const SceneSchema schema;
  return schema;
}

/// Returns the JSON pointer of a path of valijson, which is "<root>" and then each token in
/// brackets.
Pointer pointer_of(const std::vector<std::string>& context) {
  Pointer pointer;
  for (std::size_t i = 1; i < context.size(); ++i) {
    pointer.push_back(context[i].substr(1, context[i].size() - 2));
  }
  return pointer;
}

/// Returns the pointers of all complaints. A fault of a value is also reported at each of its
/// parents.
std::set<Pointer> pointers_of(const valijson::ValidationResults& results) {
  std::set<Pointer> pointers;
  for (const auto& error : results) pointers.insert(pointer_of(error.context));
  return pointers;
}

const Json& child(const Json& value, const std::string& token) {
  return value.is_array() ? value.at(std::stoul(token)) : value.at(token);
}

}  // namespace

const Json& schema_document() {
  return scene_schema().document;
}

std::vector<Pointer> check_schema(const Json& document, Faults& faults) {
  const SceneSchema& schema = scene_schema();
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema.constraints, Adapter(document), &results)) return {};

  std::vector<Pointer> faulty;
  const std::set<Pointer> complaints = pointers_of(results);
  for (auto at = complaints.begin(); at != complaints.end(); ++at) {
    // The pointers are sorted, so that those of parts of a value come right after that of the
    // value.
    const auto next = std::next(at);
    const bool is_parent = next != complaints.end() && is_within(*next, *at);
    const Json* value = &document;
    const Json* rule = &resolve_rule(schema.document, schema.document, value->type_name());
    for (const std::string& token : *at) {
      value = &child(*value, token);
      rule = &resolve_rule(child_rule(*rule, token), schema.document, value->type_name());
    }
    if (is_parent && !value->is_object()) continue;
    const std::size_t before = faults.count();
    if (tell_by_rule(*at, *value, *rule, faults)) {
      for (std::size_t i = before; i < faults.count(); ++i) faulty.push_back(faults.pointer(i));
    } else if (!is_parent) {
      throw Error(ErrorKind::internal,
                  fmt::format("{}: {}: the schema refuses this value for an unknown reason",
                              faults.name(), to_string(*at)));
    }
  }
  return faulty;
}

}  // namespace aerostat::scene::detail
