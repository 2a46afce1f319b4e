#include "preset/schema.h"

#include <fmt/format.h>

#include <cassert>

namespace frond {

void SchemaWriter::add(std::string_view name, Value schema, std::string_view doc, std::string_view unit,
                       Value initial) {
  assert(!properties_.find(name) && "a property is described twice");
  if (!doc.empty() || !unit.empty()) {
    std::string text = unit.empty() ? std::string(doc) : fmt::format("{} ({})", doc, unit);
    schema.set("description", make_text(text));
  }
  if (!initial.is(Value::Type::null)) schema.set("default", std::move(initial));
  properties_.set(name, std::move(schema));
}

Value SchemaWriter::object_schema() const {
  Value schema = type("object");
  schema.set("properties", properties_);
  if (!required_.empty()) schema.set("required", make_texts(required_));
  schema.set("additionalProperties", make_boolean(false));
  const Value* bare = properties_.find(bare_);
  return bare ? make_object().set("anyOf", make_list({*bare, schema})) : schema;
}

std::string SchemaWriter::with_choices(std::string_view doc, const std::vector<std::string_view>& names,
                                       const std::vector<std::string_view>& docs) {
  std::string text(doc);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!docs[i].empty()) text += fmt::format("{}{}: {}", i == 0 ? ". " : "; ", names[i], docs[i]);
  }
  return text;
}

Value SchemaWriter::forced_schema(const Value& defaults) {
  return list_schema(make_object().set("enum", make_texts(paths_of(defaults))), {});
}

Value SchemaWriter::written_schema(std::string_view json) {
  Result<Document> schema = parse_json(json, "schema");
  assert(schema.ok() && "the schema of a custom property is no JSON");
  return schema ? schema->root : make_object();
}

Value SchemaWriter::joined_kinds(const Value& common, const std::vector<KindSchema>& kinds) {
  std::vector<std::string_view> names;
  std::vector<std::string_view> docs;
  Value cases = make_list();
  for (const KindSchema& kind : kinds) {
    names.push_back(kind.name);
    docs.push_back(kind.doc);

    // What all kinds have is allowed here and said outside.
    Value properties = make_object();
    properties.set("kind", make_boolean(true));
    for (const Member& member : common.find("properties")->members)
      properties.set(member.name, make_boolean(true));
    for (const Member& member : kind.schema.find("properties")->members) {
      assert(!properties.find(member.name) && "a kind describes what all kinds have");
      properties.set(member.name, member.value);
    }
    Value then = make_object().set("properties", std::move(properties));
    if (const Value* required = kind.schema.find("required")) then.set("required", *required);
    then.set("additionalProperties", make_boolean(false));
    if (!kind.leading.empty()) then.set("leading", make_texts(kind.leading));
    Value is_kind = make_object().set("kind", make_object().set("const", make_text(kind.name)));
    Value condition =
        make_object().set("properties", is_kind).set("required", make_list({make_text("kind")}));
    cases.items.push_back(make_object().set("if", condition).set("then", then));
  }

  Value properties = make_object();
  Value kind = choice_schema(names);
  properties.set("kind", kind.set("description", make_text(with_choices("What it is", names, docs))));
  for (const Member& member : common.find("properties")->members) properties.set(member.name, member.value);
  Value required = make_list({make_text("kind")});
  if (const Value* more = common.find("required")) {
    required.items.insert(required.items.end(), more->items.begin(), more->items.end());
  }
  Value schema = type("object");
  schema.set("properties", std::move(properties)).set("required", std::move(required));
  return schema.set("allOf", std::move(cases));
}

}  // namespace frond
