#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "organisms/kinds.h"
#include "preset/json.h"
#include "preset/schema.h"
#include "scene/copies.h"
#include "scene/scene.h"

namespace frond {
namespace {

/// A small one of each kind, quick to grow, and what it grows on.
const std::map<std::string_view, std::string_view> kSmall = {
    {"coral", R"({"steps": 3})"},
    {"massive", R"({"across": 0.2, "height": 0.1, "edge": 0.012, "valley": 0.06})"},
    {"columnar", R"({"accretion": {"layers": 8, "edge": 0.03}})"},
    {"foliose", R"({"sheets": 2, "across": 0.1, "height": 0.05, "edge": 0.01})"},
    {"table", R"({"across": 0.1, "height": 0.05, "edge": 0.01, "spacing": 0.02})"},
    {"encrusting", R"({"across": 0.1, "height": 0.02, "edge": 0.01})"},
    {"tube", R"({"across": 0.1, "height": 0.05, "tubes": 2, "radius": 0.01, "edge": 0.01})"},
    {"mushroom", R"({"across": 0.05, "height": 0.02, "septa": 8})"},
    {"fan", R"({"across": 0.1, "height": 0.1, "mesh": 0.02})"},
    {"shell", R"({"form": "bivalve", "whorls": 0.3, "expansion": 1000, "detail": 2000, "mantle": {}})"},
    {"plant", R"({"grammar": {"axiom": "A", "steps": 3, "angle_jitter": 6,
                  "rules": ["A -> F(0.1)[+~L][-~P]A"]}, "season": {},
                  "organs": [{"symbol": "L", "shape": "picture", "picture": {"pixels": 16}},
                             {"symbol": "P", "shape": "flower"}]})"},
    {"rock", R"({"depth": 4})"},
    {"pebbles", R"({"depth": 3, "shapes": 2, "number": 5, "radius": 0.5})"},
    {"wall", R"({"width": 1, "height": 0.6})"},
    {"column", R"({"height": 1})"},
    {"mesh", R"({"file": "presets/models/arch.obj"})"},
    {"bridge", R"({"length": 3, "posts": 2})"},
    {"trellis", R"({})"},
    {"vase", R"({"bands": [{}], "sides": 12, "rings": 24, "soil": 0.5})"},
    {"weber_penn", R"({"tree": {"levels": 2, "scale": 2, "branches": {"branches": 6}, "leaves": 3},
                       "coat": {"pixels": 16}, "leaves": {"pixels": 16}, "season": {"blossom": {}}})"},
    {"colonized", R"({"colonize": {"attractors": 40, "most_nodes": 200}, "coat": {"pixels": 16},
                      "leaves": {"pixels": 16}, "season": {"blossom": {}}})"},
    {"tree", R"({"years": 6, "leaves": {"picture": {"pixels": 16}}, "coat": {"pixels": 16}, "season": {}})"},
    {"ivy", R"({"crawl": {"max_age": 30}, "place": {"at": [[-0.3, 0.12]]}})"},
    {"school", R"({"fish": {"look": {"pixels": 32}}})"},
};

Value parsed(std::string_view json) { return parse_json(json, "test")->root; }

Value small(std::string_view kind) {
  Value organism = make_object().set("kind", make_text(kind));
  organism.set("place", parsed(R"({"at": [[0, 0]], "rock": 0})"));
  for (const Member& member : parsed(kSmall.at(kind)).members) organism.set(member.name, member.value);
  return organism;
}

std::optional<Preset> preset_of(const Value& organism) {
  std::string others = organism.find("kind")->text == "ivy"
                           ? R"(, {"kind": "wall", "width": 1, "height": 0.6, "place": {"at": [[0, 0]]}})"
                           : "";
  // In a film all is fully grown, whenever it grows.
  std::string text = R"({"film": {"frames": 2}, "scene": {"setting": "studio"}, "organisms": [)" +
                     serialize(organism) + others + "]}";
  Result<Preset> preset = read_preset(text, "test.json", {});
  return preset ? std::optional(std::move(*preset)) : std::nullopt;
}

/// What grows: the branches, where the organs are, and the surfaces of bodies.
struct Shape {
  std::vector<Vec3> position, organs, bodies;
  std::vector<float> radius;
  bool operator==(const Shape&) const = default;

  void add(const Model& model) {
    auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(position, model.skeleton.position), append(radius, model.skeleton.radius);
    append(organs, model.organs.position);
    append(bodies, model.blades.surface.position), append(bodies, model.solids.position);
    for (const Solid& solid : model.solids.shapes) append(bodies, solid.surface.position);
  }
};

Shape grown(const Preset& preset) {
  Shape shape;
  Result<Scene> scene = build_scene(preset);
  if (!scene) return ADD_FAILURE() << scene.errors().front().text(), shape;
  for (const Specimen& s : scene->specimens)
    if (s.entry == 0) shape.add(s.model);
  return shape;
}

using Path = std::vector<std::string>;

std::string text_of(const Path& path) {
  std::string text;
  for (const std::string& step : path) text += "/" + step;
  return text;
}

Value* child(Value& value, const std::string& step) {
  if (value.is(Value::Type::list)) return value.items.empty() ? nullptr : value.items.data();
  return value.find(step);
}

/// The value with another at the path.
Value with(Value root, const Path& path, const Value& leaf) {
  Value* here = &root;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (!child(*here, path[i])) here->set(path[i], make_object());
    here = child(*here, path[i]);
  }
  if (here->is(Value::Type::list)) return here->items[0] = leaf, root;
  here->set(path.back(), leaf);
  return root;
}

const Value* at(const Value& root, const Path& path) {
  Value* here = const_cast<Value*>(&root);
  for (const std::string& step : path)
    if (here) here = child(*here, step);
  return here;
}

/// The description of an object, which may allow a bare value in its place; or of a value without keyframes.
const Value& plain(const Value& schema) {
  const Value* any = schema.find("anyOf");
  if (!any) return schema;
  for (const Value& inner : any->items)
    if (inner.find("properties")) return inner;
  return plain(any->items.front());
}

/// Calls `visit(path, schema, default)` for every property of an object, and of the first element of lists of
/// objects that are given.
template <class Visit>
void each_property(const Value& schema, const Value& given, Path path, const Visit& visit) {
  const Value* properties = schema.find("properties");
  for (const Member& member : properties->members) {
    path.push_back(member.name);
    const Value& own = plain(member.value);
    const Value *items = own.find("items"), *there = at(given, path);
    if (own.find("properties")) {
      visit(path, own, nullptr);
      each_property(own, given, path, visit);
    } else if (items && plain(*items).find("properties") && there && !there->items.empty()) {
      path.push_back("0");
      each_property(plain(*items), given, path, visit);
      path.pop_back();
    } else {
      visit(path, own, member.value.find("default"));
    }
    path.pop_back();
  }
}

double number_or(const Value& schema, std::string_view name, double otherwise) {
  const Value* found = schema.find(name);
  return found ? found->number : otherwise;
}

/// Another valid value of a property; none of texts without a list of them.
std::optional<Value> another(const Value& schema, const Value* now) {
  if (const Value* names = schema.find("enum")) {
    for (const Value& name : names->items)
      if (!now || name.text != now->text) return name;
    return std::nullopt;
  }
  if (schema.find("pattern")) return make_text(now && now->text == "#123456" ? "#654321" : "#123456");
  const Value* type = schema.find("type");
  std::string kind = type && type->is(Value::Type::text) ? type->text : "";
  if (kind == "boolean") return make_boolean(!now || !now->boolean);
  if (kind == "number" || kind == "integer") {
    double low = number_or(schema, "minimum", number_or(schema, "exclusiveMinimum", -1e3));
    double high = number_or(schema, "maximum", 1e3), x = now ? now->number : std::clamp(0.0, low, high);
    double step = kind == "integer" ? 1 : x != 0 ? 0.2 * std::abs(x) : std::min(0.1, 0.2 * (high - low));
    double next = x + step <= high ? x + step : x - step;
    return next >= low && next <= high ? std::optional(make_number(next)) : std::nullopt;
  }
  const Value* items = schema.find("items");
  if (kind != "array" || !items || items->is(Value::Type::list)) return std::nullopt;
  Value list = now && now->is(Value::Type::list) ? *now : make_list();
  if (list.items.empty()) {
    for (double i = 0; i < std::max(1.0, number_or(schema, "minItems", 1)); ++i)
      if (std::optional<Value> one = another(plain(*items), nullptr)) list.items.push_back(*one);
    return list.items.empty() ? std::nullopt : std::optional(list);
  }
  std::optional<Value> last = another(plain(*items), &list.items.back());
  if (!last) return std::nullopt;
  list.items.back() = *last;
  return list;
}

Value schema_of(const Kind<Organism>& kind) {
  SchemaWriter writer;
  Organism sample;
  kind.describe(writer, sample);
  return writer.object_schema();
}

Keys keys_of_first(const Preset& preset) { return preset.organisms[0].grower->keys(); }

TEST(Keys, WhatDoesNotShapeLeavesTheShapeOfEveryKind) {
  for (const Kind<Organism>& kind : organism_kinds()) {
    ASSERT_TRUE(kSmall.contains(kind.name)) << kind.name;
    Value given = small(kind.name);
    std::optional<Preset> preset = preset_of(given);
    ASSERT_TRUE(preset) << kind.name;
    Keys keys = keys_of_first(*preset);
    Shape shape = grown(*preset);
    int others = 0, same = 0, refused = 0;
    each_property(schema_of(kind), given, {},
                  [&](const Path& path, const Value& schema, const Value* initial) {
                    if (schema.find("properties")) return;
                    const Value* now = at(given, path);
                    std::optional<Value> next = another(schema, now ? now : initial);
                    if (!next) return;
                    std::optional<Preset> changed = preset_of(with(given, path, *next));
                    if (!changed) return void(++refused);
                    Keys now_keys = keys_of_first(*changed);
                    EXPECT_FALSE(now_keys == keys)
                        << kind.name << text_of(path) << " does not count: " << serialize(*next);
                    if (now_keys.shape != keys.shape) return void(++others);
                    ++same;
                    EXPECT_TRUE(grown(*changed) == shape) << kind.name << text_of(path) << " shapes";
                  });
    EXPECT_GE(others, 1) << kind.name;
    EXPECT_GE(same, 2) << kind.name;
    EXPECT_LE(refused, others + same) << kind.name;
  }
}

TEST(Keys, DefaultsMayBeWritten) {
  for (const Kind<Organism>& kind : organism_kinds()) {
    Value given = small(kind.name), all = given;
    Keys keys = keys_of_first(*preset_of(given));
    std::set<std::string> absent;  // objects that are not there unless they are given
    each_property(
        schema_of(kind), given, {}, [&](const Path& path, const Value& schema, const Value* initial) {
          bool inside = std::ranges::any_of(
              absent, [&](const std::string& object) { return text_of(path).starts_with(object + "/"); });
          if (inside || at(given, path)) return;
          if (schema.find("properties")) {
            std::optional<Preset> with_it = preset_of(with(given, path, make_object()));
            if (!with_it || keys_of_first(*with_it) != keys) absent.insert(text_of(path));
            return;
          }
          // Colours are told as the nearest of 256 levels.
          if (!initial || schema.find("pattern")) return;
          std::optional<Preset> written = preset_of(with(given, path, *initial));
          if (!written) return;
          EXPECT_TRUE(keys_of_first(*written) == keys)
              << kind.name << text_of(path) << ": " << serialize(*initial);
          all = with(all, path, *initial);
        });
    std::optional<Preset> written = preset_of(all);
    ASSERT_TRUE(written) << kind.name;
    EXPECT_TRUE(keys_of_first(*written) == keys) << kind.name;
    EXPECT_TRUE(grown(*written) == grown(*preset_of(given))) << kind.name;
  }
}

TEST(Keys, AreThoseOfWhatIsSaidNotOfHow) {
  Value bare = parsed(R"({"kind": "tree", "years": 9, "leaves": {"size": 0.3}, "wave": {"speed": 0.5}})");
  Keys keys = keys_of_first(*preset_of(bare));
  auto read = [](const std::string& text, const std::vector<std::string>& sets = {}) {
    return keys_of_first(*read_preset(text, "test.json", sets));
  };
  EXPECT_TRUE(read(R"({"organisms": [{"wave": {"speed": 5e-1}, /* slow */ "leaves": {"size": 0.30},
                      "kind": "tree", "name": "oak", "years": 9.0}]})") == keys);
  EXPECT_TRUE(read(R"({"defaults": {"years": 9, "leaves": {"size": 0.3}}, "organisms": [{"kind": "tree"}]})",
                   {"/organisms/0/wave/speed=0.5"}) == keys);
}

TEST(Keys, ASownTreeKeepsItsShapeInAnyColour) {
  Value tree = parsed(R"({"kind": "tree", "years": 9, "sown": {"models": 2}, "coat": {"pixels": 16}})");
  auto model = [](const Value& organism) {
    Shape shape;
    std::optional<Preset> preset = preset_of(organism);
    if (preset) shape.add(*grow_copy(preset->organisms[0], 1));
    return shape;
  };
  auto id = [](const Value& organism) { return copy_id(preset_of(organism)->organisms[0], 1); };
  Shape shape = model(tree);
  EXPECT_FALSE(shape.position.empty());
  Value red = with(tree, {"leaves", "colors"}, parsed(R"(["#aa2211"])"));
  EXPECT_TRUE(model(red) == shape);
  EXPECT_NE(id(red), id(tree));
  Value written = with(tree, {"flare"}, make_number(0.7));
  EXPECT_TRUE(model(written) == shape);
  EXPECT_EQ(id(written), id(tree));
  Value swaying = with(tree, {"wave", "amplitude"}, make_number(9));
  EXPECT_EQ(id(swaying), id(tree));
  Value older = with(tree, {"years"}, make_number(10));
  EXPECT_FALSE(model(older) == shape);
  EXPECT_NE(id(older), id(tree));
}

}  // namespace
}  // namespace frond
