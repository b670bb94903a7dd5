#include "scene/schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "scene/expected.hpp"

namespace aerostat::scene::detail {

namespace {

using Adapter = valijson::adapters::NlohmannJsonAdapter;

/// The schema as a document, for messages, and as valijson's constraints.
struct SceneSchema {
  SceneSchema() : document(parse_json(kSchemaText, "the schema of scenes")) {
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

/// valijson's path: "<root>", then each token in brackets.
Pointer pointer_of(const std::vector<std::string>& context) {
  Pointer pointer;
  for (std::size_t i = 1; i < context.size(); ++i) {
    pointer.push_back(context[i].substr(1, context[i].size() - 2));
  }
  return pointer;
}

/// The deepest of the complaints is the cause; those above it repeat it for the parents.
Pointer deepest(const valijson::ValidationResults& results) {
  const std::vector<std::string>* context = nullptr;
  for (const auto& error : results) {
    if (context == nullptr || error.context.size() > context->size()) context = &error.context;
  }
  return context == nullptr ? Pointer{} : pointer_of(*context);
}

const Json& child(const Json& value, const std::string& token) {
  return value.is_array() ? value.at(std::stoul(token)) : value.at(token);
}

}  // namespace

const Json& schema_document() {
  return scene_schema().document;
}

void check_schema(const Json& document, const std::string& name) {
  const SceneSchema& schema = scene_schema();
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema.constraints, Adapter(document), &results)) return;

  const Pointer pointer = deepest(results);
  const Json* value = &document;
  const Json* rule = &resolve_rule(schema.document, schema.document, value->type_name());
  for (const std::string& token : pointer) {
    value = &child(*value, token);
    rule = &resolve_rule(child_rule(*rule, token), schema.document, value->type_name());
  }
  fail_by_rule(name, pointer, *value, *rule);
}

}  // namespace aerostat::scene::detail
