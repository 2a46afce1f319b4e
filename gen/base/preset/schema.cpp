#include "preset/schema.h"

#include <fmt/format.h>

#include <cassert>

#include "preset/schema_parts.h"

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
  Value schema = typed("object");
  schema.set("properties", properties_);
  if (!required_.empty()) schema.set("required", make_texts(required_));
  schema.set("additionalProperties", make_boolean(false));
  const Value* bare = properties_.find(bare_);
  return bare ? make_object().set("anyOf", make_list({*bare, schema})) : schema;
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
  Value schema = typed("object");
  schema.set("properties", std::move(properties)).set("required", std::move(required));
  return schema.set("allOf", std::move(cases));
}

Value SchemaWriter::schema_of(Slot object) {
  SchemaWriter writer;
  object.type->describe(writer, object.at);
  return writer.object_schema();
}

Value SchemaWriter::sample_schema(const SlotType& object) {
  Value schema;
  object.with_sample([&](Slot sample) { schema = schema_of(sample); });
  return schema;
}

std::vector<SchemaWriter::KindSchema> SchemaWriter::kind_schemas(const SlotType& one,
                                                                 const KindTable& kinds) {
  std::vector<KindSchema> schemas;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    SchemaWriter writer;
    one.with_sample([&](Slot sample) { kinds.describe(i, writer, sample); });
    schemas.push_back({kinds.name(i), kinds.doc(i), writer.object_schema(), writer.leading_});
  }
  return schemas;
}

Value SchemaWriter::tagged_schema(const SlotType& one, const KindTable& kinds) {
  return joined_kinds(sample_schema(one), kind_schemas(one, kinds));
}

Value SchemaWriter::defaults_of(const SlotType& one, const KindTable& kinds) {
  Value all = sample_schema(one);
  for (const KindSchema& kind : kind_schemas(one, kinds)) all = either(all, kind.schema);
  return without_required(std::move(all));
}

std::string schema_json(ObjectSlot object) { return serialize(SchemaWriter::of(object)); }

Value file_schema(Value schema, std::string_view title, std::string_view doc) {
  Value top = make_object();
  top.set("$schema", make_text("http://json-schema.org/draft-07/schema#"));
  top.set("title", make_text(title)).set("description", make_text(doc));
  for (Member& member : schema.members) top.set(member.name, std::move(member.value));
  Value& properties = *top.find("properties");
  properties.members.insert(properties.members.begin(), Member{"$schema", {}, make_object()});
  properties.members.front().value.set("type", make_text("string"));
  return top;
}

}  // namespace frond
