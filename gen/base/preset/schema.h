#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "preset/describe.h"

namespace frond {

/// The visitor that makes the JSON Schema (draft-07) of described structs (describe.h). It expresses all
/// checks of Reader except the order of keyframes. Use file_schema() below.
class SchemaWriter : public Properties {
 public:
  /// The schema of a described struct with its initial values.
  static Value of(ObjectSlot object) { return schema_of(object); }
  template <class T>
  static Value of() {
    T sample{};
    return of(sample);
  }

  /// The schema of the defaults behind a list of these kinds: properties of any kind, none required.
  static Value defaults_of(const SlotType& one, const KindTable& kinds);

  // The properties, see describe.h.

  Purpose purpose() const override { return Purpose::schema; }
  void angle(std::string_view name, RealSlot x, const Range& range, std::string_view doc) override;
  void file(std::string_view name, FileName& file, LoadFile, std::string_view doc, bool needed) override;
  void direction(std::string_view name, VectorSlot v, Across across, std::string_view doc) override;
  void list(std::string_view name, ListSlot l, const Count& count, std::string_view doc) override;
  void inheriting_list(const Inheritance& names, ListSlot l, const KindTable& kinds,
                       std::string_view doc) override;
  void required(std::string_view name) override { required_.push_back(name); }
  void shorthand(std::string_view name) override { bare_ = name; }
  void leading(std::span<const std::string_view> paths) override {
    leading_.assign(paths.begin(), paths.end());
  }

  /// The description so far.
  Value object_schema() const;

 protected:
  void visit_value(std::string_view name, Slot x, const Range& range, std::string_view doc) override;
  void visit_tagged(std::string_view name, Slot x, const KindTable& kinds, std::string_view doc) override;
  void choose(std::string_view name, Slot e, const ChoiceTable& table, std::string_view doc) override;
  void read_custom(std::string_view name, Slot x, ReadCustom, std::string_view schema,
                   std::string_view doc) override;

 private:
  /// `common` (of all kinds) with the properties of each kind added where "kind" has its name.
  struct KindSchema {
    std::string_view name;
    std::string_view doc;
    Value schema;
    std::vector<std::string_view> leading;
  };
  static Value schema_of(Slot object);
  static Value sample_schema(const SlotType& object);
  static Value value_schema(const SlotType& type, const Range& range);
  static std::vector<KindSchema> kind_schemas(const SlotType& one, const KindTable& kinds);
  static Value tagged_schema(const SlotType& one, const KindTable& kinds);
  static Value joined_kinds(const Value& common, const std::vector<KindSchema>& kinds);

  void add(std::string_view name, Value schema, std::string_view doc, std::string_view unit = {},
           Value initial = {});

  Value properties_ = make_object();
  std::vector<std::string_view> required_;
  std::string_view bare_;
  std::vector<std::string_view> leading_;
};

/// The JSON Schema of files that hold an object of that schema, with a title and a description.
Value file_schema(Value schema, std::string_view title, std::string_view doc);
template <class T>
Value file_schema(std::string_view title, std::string_view doc) {
  return file_schema(SchemaWriter::of<T>(), title, doc);
}

}  // namespace frond
