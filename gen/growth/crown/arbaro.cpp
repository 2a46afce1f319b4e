#include "crown/arbaro.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <pugixml.hpp>

#include "core/read_as.h"
#include "core/text.h"

namespace frond {

namespace {

struct Target {
  WeberPenn& tree;
  StemLevel* level = nullptr;  // of a parameter whose name begins with a digit
};

/// A parameter: its name, behind the digit of its level where it has one; what numbers it may have; what it
/// does. Angles come in degrees.
struct Parameter {
  std::string_view name;
  bool of_level, whole;
  double min, max;
  void (*set)(Target, double);
};

constexpr double kAny = 1e9, kSome = 1e-6;

CrownShape shape_of(double v) { return static_cast<CrownShape>(static_cast<int>(v)); }

constexpr Parameter kParameters[] = {
    {"Shape", false, true, 0, 8, [](Target t, double v) { t.tree.shape = shape_of(v); }},
    {"Levels", false, true, 1, 9, [](Target t, double v) { t.tree.levels = static_cast<int>(v); }},
    {"Scale", false, false, kSome, 1000, [](Target t, double v) { t.tree.scale = v; }},
    {"ScaleV", false, false, 0, 1000, [](Target t, double v) { t.tree.scale_v = v; }},
    {"ZScale", false, false, kSome, 100, [](Target t, double v) { t.tree.z_scale = v; }},
    {"ZScaleV", false, false, 0, 100, [](Target t, double v) { t.tree.z_scale_v = v; }},
    {"BaseSize", false, false, 0, 1, [](Target t, double v) { t.tree.base_size = v; }},
    {"Ratio", false, false, kSome, 10, [](Target t, double v) { t.tree.ratio = v; }},
    {"RatioPower", false, false, -10, 10, [](Target t, double v) { t.tree.ratio_power = v; }},
    {"Flare", false, false, -1, 100, [](Target t, double v) { t.tree.flare = v; }},
    {"Lobes", false, true, 0, 1000, [](Target t, double v) { t.tree.lobes = static_cast<int>(v); }},
    {"LobeDepth", false, false, 0, 1, [](Target t, double v) { t.tree.lobe_depth = v; }},
    {"Leaves", false, true, -100000, 100000, [](Target t, double v) { t.tree.leaves = v; }},
    {"LeafScale", false, false, kSome, 100, [](Target t, double v) { t.tree.leaf_scale = v; }},
    {"LeafScaleX", false, false, kSome, 100, [](Target t, double v) { t.tree.leaf_scale_x = v; }},
    {"LeafBend", false, false, 0, 1, [](Target t, double v) { t.tree.leaf_bend = v; }},
    {"LeafStemLen", false, false, -100, 100, [](Target t, double v) { t.tree.leaf_stem_length = v; }},
    {"LeafDistrib", false, true, 0, 8, [](Target t, double v) { t.tree.leaf_distribution = shape_of(v); }},
    {"LeafQuality", false, false, kSome, 1, [](Target t, double v) { t.tree.leaf_quality = v; }},
    {"Smooth", false, false, 0, 1, [](Target, double) {}},
    {"AttractionUp", false, false, -100, 100, [](Target t, double v) { t.tree.attraction_up = v; }},
    {"PruneRatio", false, false, 0, 1, [](Target t, double v) { t.tree.pruning.ratio = v; }},
    {"PruneWidth", false, false, 0, 10, [](Target t, double v) { t.tree.pruning.width = v; }},
    {"PruneWidthPeak", false, false, 0, 1, [](Target t, double v) { t.tree.pruning.width_peak = v; }},
    {"PrunePowerLow", false, false, 0, 100, [](Target t, double v) { t.tree.pruning.power_low = v; }},
    {"PrunePowerHigh", false, false, 0, 100, [](Target t, double v) { t.tree.pruning.power_high = v; }},
    {"0Scale", false, false, kSome, 100, [](Target t, double v) { t.tree.trunk_scale = v; }},
    {"0ScaleV", false, false, 0, 100, [](Target t, double v) { t.tree.trunk_scale_v = v; }},
    {"0Branches", false, true, 1, 1000, [](Target t, double v) { t.tree.trunks = static_cast<int>(v); }},
    {"0BranchDist", false, false, 0, 1000, [](Target t, double v) { t.tree.trunk_spread = v; }},
    {"0BaseSplits", false, true, 0, 100,
     [](Target t, double v) { t.tree.base_splits = static_cast<int>(v); }},
    {"DownAngle", true, false, -kAny, kAny, [](Target t, double v) { t.level->down_angle = radians(v); }},
    {"DownAngleV", true, false, -kAny, kAny, [](Target t, double v) { t.level->down_angle_v = radians(v); }},
    {"Rotate", true, false, -kAny, kAny, [](Target t, double v) { t.level->rotate = radians(v); }},
    {"RotateV", true, false, -kAny, kAny, [](Target t, double v) { t.level->rotate_v = radians(v); }},
    {"Branches", true, false, 0, 100000, [](Target t, double v) { t.level->branches = v; }},
    {"BranchDist", true, false, 0, 1000, [](Target t, double v) { t.level->branch_dist = v; }},
    {"Length", true, false, kSome, 1000, [](Target t, double v) { t.level->length = v; }},
    {"LengthV", true, false, 0, 1000, [](Target t, double v) { t.level->length_v = v; }},
    {"Taper", true, false, 0, 3, [](Target t, double v) { t.level->taper = v; }},
    {"SegSplits", true, false, 0, 10, [](Target t, double v) { t.level->seg_splits = v; }},
    {"SplitAngle", true, false, 0, 180, [](Target t, double v) { t.level->split_angle = radians(v); }},
    {"SplitAngleV", true, false, 0, 180, [](Target t, double v) { t.level->split_angle_v = radians(v); }},
    {"CurveRes", true, true, 1, 1000, [](Target t, double v) { t.level->curve_res = static_cast<int>(v); }},
    {"Curve", true, false, -kAny, kAny, [](Target t, double v) { t.level->curve = radians(v); }},
    {"CurveBack", true, false, -kAny, kAny, [](Target t, double v) { t.level->curve_back = radians(v); }},
    {"CurveV", true, false, -kAny, kAny, [](Target t, double v) { t.level->curve_v = radians(v); }},
};

std::optional<double> number_in(std::string_view text) {
  std::optional<double> value = read_as<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

const Parameter* find(std::string_view name, int& level) {
  for (const Parameter& p : kParameters) {
    level = -1;
    if (!p.of_level && p.name == name) return &p;
    if (!p.of_level || name.size() != p.name.size() + 1 || !name.ends_with(p.name)) continue;
    level = name[0] - '0';
    if (level >= 0 && level < kStemLevels) return &p;
  }
  return nullptr;
}

std::string place_of(std::string_view xml, std::ptrdiff_t offset, const std::string& file) {
  auto end = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), xml.size());
  auto line = 1 + std::count(xml.begin(), xml.begin() + static_cast<std::ptrdiff_t>(end), '\n');
  return fmt::format("{}:{}", file, line);
}

/// Puts one parameter in its place; what is wrong with it, or empty.
std::string set_parameter(ArbaroSpecies& species, std::string_view name, std::string_view value) {
  if (name == "LeafShape") return species.leaf_shape = value, "";
  if (name == "Species") return species.name = value, "";
  int level = -1;
  const Parameter* parameter = find(name, level);
  if (!parameter) {
    std::vector<std::string> names = arbaro_names();
    std::string_view near = nearest_name(name, names);
    return fmt::format("unknown parameter \"{}\"{}", name,
                       near.empty() ? std::string() : fmt::format("; did you mean \"{}\"?", near));
  }
  std::optional<double> number = number_in(value);
  bool fits = number && *number >= parameter->min && *number <= parameter->max &&
              (!parameter->whole || *number == std::floor(*number));
  if (!fits)
    return fmt::format("{} is \"{}\"; expected a {} from {} to {}", name, value,
                       parameter->whole ? "whole number" : "number", parameter->min, parameter->max);
  parameter->set({species.tree, level >= 0 ? &species.tree.level[level] : nullptr}, *number);
  return "";
}

/// What Arbaro takes where a file says nothing.
WeberPenn arbaro_defaults() {
  WeberPenn tree;
  tree.cone_top = 0;  // its cones end in a point
  tree.leaf_stem_length = 0.5;
  tree.level[0] = {0, 0, 0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 3, 0, 0, 0};
  StemLevel branch{radians(30.0), 0, radians(120.0), 0, 5, 1, 0.5, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  tree.level[1] = tree.level[2] = tree.level[3] = branch;
  tree.level[1].branches = 10;
  tree.level[1].curve_res = 3;
  return tree;
}

/// Puts into our words what Arbaro says otherwise.
void translate(WeberPenn& tree) {
  int bearing = std::min(tree.levels, kStemLevels - 1);  // whose angles are those of the leaves
  for (int n = 0; n < kStemLevels; ++n) {
    double& rotate = tree.level[n].rotate;
    // Its sides stand so much less than half a turn to either side, ours half of it. A fan takes it as it is.
    bool fan = tree.leaves < 0 && n == bearing;
    if (rotate < 0 && !fan) rotate = -2 * std::abs(kPi + rotate);
  }
  if (tree.levels == 1) tree.leaves = 0;  // its trunks bear none
}

}  // namespace

Result<ArbaroSpecies> read_arbaro(std::string_view xml, const std::string& file_name) {
  pugi::xml_document document;
  pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
  if (!parsed)
    return Error{place_of(xml, parsed.offset, file_name), std::string("no XML: ") + parsed.description()};
  pugi::xml_node root = document.child("arbaro").child("species");
  if (!root) return Error{file_name, "holds no <arbaro><species>"};
  ArbaroSpecies species;
  species.name = root.attribute("name").value();
  species.tree = arbaro_defaults();
  Errors errors;
  for (pugi::xml_node node : root.children()) {
    if (node.type() != pugi::node_element) continue;
    std::string wrong =
        std::string_view(node.name()) == "param"
            ? set_parameter(species, node.attribute("name").value(), node.attribute("value").value())
            : fmt::format("unknown element <{}>; expected <param>", node.name());
    if (!wrong.empty()) errors.push_back({place_of(xml, node.offset_debug(), file_name), wrong});
  }
  if (!errors.empty()) return errors;
  translate(species.tree);
  return species;
}

std::vector<std::string> arbaro_names() {
  std::vector<std::string> names{"Species", "LeafShape"};
  for (const Parameter& p : kParameters) {
    if (!p.of_level) names.emplace_back(p.name);
    for (int level = 0; p.of_level && level < kStemLevels; ++level) {
      std::string name = static_cast<char>('0' + level) + std::string(p.name);
      int found = -1;
      if (find(name, found) == &p) names.push_back(std::move(name));
    }
  }
  return names;
}

}  // namespace frond
