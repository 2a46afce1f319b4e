#include "preset/palettes.h"

#include <fmt/format.h>

#include <string_view>

#include "core/read_as.h"
#include "preset/fault.h"
#include "preset/reader.h"

namespace frond {
namespace {

constexpr std::string_view kPrefix = "palette:";

bool names_palette(const Value& value) {
  return value.is(Value::Type::text) && value.text.starts_with(kPrefix);
}

/// Walks through a document and puts colours in place.
class PaletteWalk {
 public:
  explicit PaletteWalk(const Value& palettes) : palettes_(palettes) {
    for (const Member& member : palettes_.members) names_.push_back(member.name);
  }

  Errors errors() const { return faults_.errors(); }

  void visit(Value& value, const std::string& pointer) {
    if (names_palette(value)) {
      std::vector<Value> colors = colors_of(value, pointer);
      if (colors.size() == 1) {
        value = std::move(colors[0]);
      } else if (!colors.empty()) {
        note(value, pointer,
             fmt::format("found a palette of {} colors; expected one of them, as \"{}/0\"", colors.size(),
                         value.text));
      }
    }
    for (Member& member : value.members) visit(member.value, pointer_step(pointer, member.name));
    std::vector<Value> items;
    for (std::size_t i = 0; i < value.items.size(); ++i) {
      Value& item = value.items[i];
      std::string at = pointer_step(pointer, std::to_string(i));
      if (!names_palette(item)) {
        visit(item, at);
        items.push_back(std::move(item));
        continue;
      }
      for (Value& color : colors_of(item, at)) items.push_back(std::move(color));
    }
    value.items = std::move(items);
  }

 private:
  /// What a text names; nothing where that is not there, which is noted.
  std::vector<Value> colors_of(const Value& value, const std::string& pointer) {
    std::string_view name = std::string_view(value.text).substr(kPrefix.size());
    std::size_t slash = name.rfind('/');
    std::string_view place = slash == name.npos ? std::string_view() : name.substr(slash + 1);
    name = name.substr(0, slash);
    const Value* palette = palettes_.find(name);
    if (!palette) {
      note(value, pointer, fmt::format("no palette \"{}\"{}", name, expected_names(name, names_)));
      return {};
    }
    std::vector<Value> colors;
    for (Value color : palette->items) {
      color.origin = value.origin;
      colors.push_back(std::move(color));
    }
    if (slash == value.text.npos) return colors;
    auto index = read_as<std::size_t>(place);
    if (index && *index < colors.size()) return {colors[*index]};
    note(value, pointer,
         fmt::format("found the color \"{}\" of a palette; expected a number from 0 to {}", place,
                     colors.size() - 1));
    return {};
  }

  void note(const Value& value, const std::string& pointer, std::string what) {
    faults_.add({value.origin, pointer, std::move(what)});
  }

  const Value& palettes_;
  std::vector<std::string_view> names_;
  Faults faults_;
};

}  // namespace

bool read_palettes(Reader& reader, const Value& value, Palettes& palettes) {
  if (!value.is(Value::Type::object)) {
    reader.fault(value, "an object of lists of colors");
    return false;
  }
  for (const Member& member : value.members) {
    reader.inside(member.name, [&] {
      const Value& list = member.value;
      if (!list.is(Value::Type::list) || list.items.empty())
        reader.fault(list, "a list of one color or more");
      for (std::size_t i = 0; i < list.items.size(); ++i)
        reader.inside(std::to_string(i), [&] { return reader.color_at(list.items[i]); });
    });
    palettes.names.push_back(member.name);
  }
  return true;
}

Errors use_palettes(Value& root) {
  const Value* named = root.find("palettes");
  Value palettes = named ? *named : make_object();
  PaletteWalk walk(palettes);
  for (std::string_view part : {"scene", "defaults", "organisms"})
    if (Value* value = root.find(part)) walk.visit(*value, pointer_step("", part));
  return walk.errors();
}

}  // namespace frond
