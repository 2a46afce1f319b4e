#include "core/assets.h"
#include "core/content.h"
#include "preset/merge.h"
#include "preset/reader.h"
#include "preset/schema.h"

// The properties that Reader reads, see describe.h.

namespace frond {

namespace {

/// The range without what the type cannot hold.
Range within(Range range, const SlotType& type) {
  if (range.min < type.lowest) range.min = type.lowest;
  if (range.max > type.highest) range.max = type.highest;
  return range;
}

Range in_degrees(Range range) {
  if (range.unit.empty()) range.unit = "degrees";
  return range;
}

void set_real(Slot out, double x) {
  if (out.type->is_float) {
    out.as<float>() = static_cast<float>(x);
  } else {
    out.as<double>() = x;
  }
}

double real(Slot x) { return x.type->is_float ? static_cast<double>(x.as<float>()) : x.as<double>(); }

template <class T>
bool keep(Slot out, std::optional<T> read) {
  if (read) out.hold().as<T>() = std::move(*read);
  return read.has_value();
}

}  // namespace

void Reader::member(std::string_view name, FunctionRef<void(const Value&)> read) {
  const Value* value = consume(name);
  if (!value) return;
  if (value == frames_.back().value) {
    read(*value);
  } else {
    inside(name, [&] { read(*value); });
  }
}

bool Reader::with_object(const Value& value, FunctionRef<void()> read) {
  std::size_t before = faults_.list().size();
  enter(value);
  read();
  leave();
  return faults_.list().size() == before;
}

bool Reader::real_at(const Value& value, const Range& range, Slot out) {
  std::optional<double> x = number_at(value, within(range, out.held_type()));
  if (x) set_real(out.hold(), *x);
  return x.has_value();
}

bool Reader::integer_at(const Value& value, const Range& range, Slot out) {
  std::optional<double> x = whole_at(value, within(range, out.held_type()));
  if (x) out.held_type().set(out.hold().at, *x);
  return x.has_value();
}

bool Reader::vector_at(const Value& value, const Range& range, Slot out) {
  const SlotType& type = out.held_type();
  std::array<double, 3> numbers{};
  std::span<double> used(numbers.data(), static_cast<std::size_t>(type.length));
  if (!numbers_at(value, within(range, type), used)) return false;
  Slot held = out.hold();
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (type.is_float) {
      (&held.as<float>())[i] = static_cast<float>(numbers[i]);
    } else {
      (&held.as<double>())[i] = numbers[i];
    }
  }
  return true;
}

bool Reader::object_at(const Value& value, ObjectSlot out) { return struct_at(value, out.hold()); }

bool Reader::struct_at(const Value& value, Slot out) {
  return with_object(value, [&] { out.type->describe(*this, out.at); });
}

bool Reader::value_at(const Value& value, const Range& range, Slot out) {
  switch (out.held_type().kind) {
    case SlotType::Kind::boolean:
      return keep(out, boolean_at(value));
    case SlotType::Kind::real:
      return real_at(value, range, out);
    case SlotType::Kind::integer:
      return integer_at(value, range, out);
    case SlotType::Kind::text:
      return keep(out, text_at(value));
    case SlotType::Kind::vector:
      return vector_at(value, range, out);
    case SlotType::Kind::size:
      return keep(out, size_at(value, range));
    case SlotType::Kind::color:
      return keep(out, color_at(value));
    case SlotType::Kind::curve:
      return keep(out, curve_at(value));
    case SlotType::Kind::animated:
      return out.held_type().length == 1 ? keep(out, animated_at(value, range, Animated<double>{}))
                                         : keep(out, animated_at(value, range, Animated<Vec3>{}));
    case SlotType::Kind::pairs:
      return keep(out, pairs_at(value));
    default:
      return struct_at(value, out.hold());
  }
}

void Reader::visit_value(std::string_view name, Slot out, const Range& range, std::string_view) {
  member(name, [&](const Value& v) { value_at(v, range, out); });
}

void Reader::angle(std::string_view name, RealSlot out, const Range& range, std::string_view) {
  member(name, [&](const Value& v) {
    std::optional<double> found = number_at(v, in_degrees(within(range, out.held_type())));
    if (!found) return;
    if (out.type->kind == SlotType::Kind::real) warn_of_radians(v, *found, degrees(real(out)));
    set_real(out.hold(), radians(*found));
  });
}

void Reader::file(std::string_view name, FileName& out, LoadFile load, std::string_view, bool needed) {
  member(name, [&](const Value& v) {
    out.content.clear();
    if (!keep(slot_of(out.name), text_at(v)) || !assets_ || !needed) return;
    std::optional<NamedFile> found = file_at(v);
    if (!found) return;
    out.content = content_id(found->text);
    note_faults(v, *found, load(*found));
  });
}

void Reader::choose(std::string_view name, Slot out, const ChoiceTable& table, std::string_view) {
  member(name, [&](const Value& v) {
    if (std::optional<std::size_t> which = name_at(v, table.names())) table.set(*which, out.hold());
  });
}

void Reader::direction(std::string_view name, VectorSlot out, Across across, std::string_view) {
  member(name, [&](const Value& v) {
    if (out.held_type().is_float) {
      std::optional<Vec3> read = vector_at<Vec3>(v, kDirections);
      if (read && has_length(v, DVec3(*read), across)) keep(out, read);
    } else {
      std::optional<DVec3> read = vector_at<DVec3>(v, kDirections);
      if (read && has_length(v, *read, across)) keep(out, read);
    }
  });
}

void Reader::list_at(const Value& value, Slot out, const Count& count,
                     FunctionRef<void(const Value&, Slot)> read) {
  if (!check_list(value, count)) return;
  const SlotType& type = *out.type;
  type.clear(out.at);
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    Slot element{type.add(out.at), type.element};
    inside(std::to_string(i), [&] { read(value.items[i], element); });
  }
}

void Reader::list(std::string_view name, ListSlot out, const Count& count, std::string_view) {
  member(name, [&](const Value& v) {
    list_at(v, out.hold(), count, [&](const Value& item, Slot element) { value_at(item, {}, element); });
  });
}

void Reader::read_custom(std::string_view name, Slot, ReadCustom read, std::string_view, std::string_view) {
  member(name, [&](const Value& v) { read(*this, v); });
}

bool Reader::tagged_at(const Value& value, Slot out, const KindTable& kinds) {
  if (!value.is(Value::Type::object)) return fault(value, "an object"), false;
  std::vector<std::string_view> names = kinds.names();
  const Value* name = value.find("kind");
  if (!name) {
    faults_.add({value.origin, pointer_, "no \"kind\"" + expected_names("", names)});
    return false;
  }
  std::optional<std::size_t> which = inside("kind", [&] { return name_at(*name, names); });
  if (!which) return false;
  return with_object(value, [&] {
    consume("kind");
    out.type->describe(*this, out.at);
    kinds.describe(*which, *this, out);
  });
}

void Reader::visit_tagged(std::string_view name, Slot out, const KindTable& kinds, std::string_view) {
  member(name, [&](const Value& v) {
    if (out.held_type().kind != SlotType::Kind::list) return void(tagged_at(v, out.hold(), kinds));
    list_at(v, out.hold(), {}, [&](const Value& item, Slot element) { tagged_at(item, element, kinds); });
  });
}

void Reader::inheriting_list(const Inheritance& names, ListSlot out, const KindTable& kinds,
                             std::string_view) {
  const SlotType& one = *out.type->element;
  // Defaults may have properties of any kind, so each kind reads them.
  Value nothing = make_object();
  const Value* defaults = &nothing;
  member(names.defaults, [&](const Value& value) {
    if (!value.is(Value::Type::object)) return void(fault(value, "an object"));
    defaults = &value;
    std::vector<std::vector<Fault>> readings;
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
      Reader reader(true);
      reader.pointer_ = pointer_;
      one.with_sample([&](Slot sample) {
        reader.with_object(value, [&] {
          one.describe(reader, sample.at);
          kinds.describe(kind, reader, sample);
        });
      });
      readings.push_back(reader.faults().list());
    }
    for (Fault& fault : common_faults(readings)) faults_.add(std::move(fault));
  });

  std::vector<std::string> force;
  member(names.force, [&](const Value& value) {
    list_at(value, slot_of(force), {}, [&](const Value& item, Slot path) {
      if (value_at(item, {}, path))
        check_path(item, path.as<std::string>(), SchemaWriter::defaults_of(one, kinds));
    });
  });

  member(names.list, [&](const Value& value) {
    list_at(value, out, {}, [&](const Value& item, Slot element) {
      if (force.empty()) return void(tagged_at(merge(*defaults, item), element, kinds));
      // What is forced out must be right too.
      one.with_sample([&](Slot unforced) { tagged_at(merge(*defaults, item), unforced, kinds); });
      tagged_at(merge(*defaults, item, force), element, kinds);
    });
  });
}

void Reader::read_root(const Value& root, ObjectSlot out) {
  pointer_.clear();
  with_object(root, [&] {
    std::string schema;
    text("$schema", schema, "");
    out.type->describe(*this, out.at);
  });
}

Errors read_document(const Document& document, ObjectSlot out, Faults* warnings, const Assets* assets) {
  Reader reader;
  if (assets) reader.read_files(*assets);
  reader.read_root(document.root, out);
  if (warnings) *warnings = reader.warnings();
  return reader.faults().errors();
}

bool read_object(Reader& reader, const Value& value, ObjectSlot object) {
  return reader.object_at(value, object);
}

}  // namespace frond
