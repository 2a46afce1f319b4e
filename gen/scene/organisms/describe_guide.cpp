#include "organisms/describe_grammar.h"

#include "geometry/obj.h"
#include "grammar/import.h"
#include "grammar/kind.h"
#include "preset/reader.h"

namespace frond {

namespace {

/// What hangs from a point.
struct Children {
  const Value* list = nullptr;
};
void describe_rest(KeyWriter&, Children&) {}

/// An object of a point, its children kept apart.
struct PointObject {
  GuidePoint point;
  Children children;
};

void describe(Properties& v, PointObject& object) {
  describe(v, object.point);
  v.custom(
      "children", object.children,
      [](Reader& reader, const Value& value, Children& children) {
        if (!value.is(Value::Type::list)) return reader.fault(value, "a list of points"), false;
        children.list = &value;
        return true;
      },
      "", "");
}

bool is_list_of_lists(const Value& value) {
  return value.is(Value::Type::list) && !value.items.empty() && !value.items[0].is(Value::Type::number);
}

bool read_line(Reader& reader, const Value& value, std::int32_t parent, std::vector<GuidePoint>& points);

/// One point and what hangs from it. Its number in `index`.
bool read_point(Reader& reader, const Value& value, std::int32_t parent, std::vector<GuidePoint>& points,
                std::int32_t& index) {
  PointObject read;
  bool good = true;
  if (value.is(Value::Type::object)) {
    good = reader.object_at(value, read);
  } else {
    std::optional<DVec3> at = reader.vector_at<DVec3>(value, {});
    good = at.has_value();
    if (at) read.point.at = *at;
  }
  read.point.parent = parent;
  index = static_cast<std::int32_t>(points.size());
  points.push_back(read.point);
  if (!read.children.list) return good;
  reader.inside("children", [&] {
    for (std::size_t i = 0; i < read.children.list->items.size(); ++i) {
      const Value& item = read.children.list->items[i];
      std::int32_t ignored = 0;
      good &= reader.inside(std::to_string(i), [&] {
        return is_list_of_lists(item) ? read_line(reader, item, index, points)
                                      : read_point(reader, item, index, points, ignored);
      });
    }
  });
  return good;
}

bool read_line(Reader& reader, const Value& value, std::int32_t parent, std::vector<GuidePoint>& points) {
  if (!value.is(Value::Type::list)) return reader.fault(value, "a list of points"), false;
  bool good = true;
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    good &= reader.inside(std::to_string(i),
                          [&] { return read_point(reader, value.items[i], parent, points, parent); });
  }
  return good;
}

}  // namespace

bool read_guide_line(Reader& reader, const Value& value, std::vector<GuidePoint>& points) {
  return read_line(reader, value, GuidePoint::kRoot, points);
}

Result<GuideLines> read_guide_file(const NamedFile& file) {
  std::string name = file.path.string();
  if (grammar_kind(name, file.text) == GrammarKind::skeleton) {
    Result<GuideLines> lines = skeleton_lines(file.text);
    // What stands in a file that a preset names is not shown.
    if (!lines) return Error{name, "is a skeleton that cannot be read; `frond derive` of it says why"};
    return lines;
  }
  Result<LineSet> lines = read_obj_lines(file.text, name);
  if (!lines) return lines.errors();
  return GuideLines{std::move(lines->place), std::move(lines->line)};
}

Errors load_guide(const NamedFile& file, GuideText& guide) {
  Result<GuideLines> lines = read_guide_file(file);
  if (!lines) return lines.errors();
  guide.lines = std::move(*lines);
  return {};
}

}  // namespace frond
