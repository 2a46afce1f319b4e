#include "emit/copies.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "core/parallel.h"
#include "core/text.h"
#include "emit/eyes.h"
#include "emit/solid.h"

namespace frond {

namespace {

/// From the nearest on; each is used from where a pixel covers its grain.
constexpr CopyDetail kLevels[] = {{0.002, 6e5}, {0.008, 3e5}, {0.025, 1.4e5}, {0.08, 5e4}, {0.25, 1.5e4}};
constexpr int kLevelCount = static_cast<int>(std::size(kLevels));
constexpr double kModelUnit = 10;     // units a metre in which models are written
constexpr double kLeastPixels = 1.2;  // of a crown; what is smaller is left out
constexpr const char* kCopyMacros[] = {"Copy_Leaf",  "Copy_Petal", "Copy_Fruit",
                                       "Copy_Fruit", "Copy_Fruit", "Copy_Leaf"};  // of each Tissue

/// About how tall an organism may be, metres; rather too much.
double tallest(const Organism& organism) {
  double height = organism.grower->tallest();
  return height > 0 ? height : 8 * organism.sown->where.radius;
}

std::uint8_t level_of(const std::vector<Eye>& eyes, Vec3 foot, double crown, double tall, double coarse) {
  double grain = 1e9;
  bool seen = false;
  auto half = static_cast<float>(tall / 2);
  for (const Eye& eye : eyes) {
    Vec3 nearest(foot.x, std::clamp(eye.at.y, foot.y, foot.y + 2 * half), foot.z);
    // Crowns reach toward the eye.
    double near = std::max<double>(glm::distance(eye.at, nearest) - 1.5 * crown, 0.3);
    grain = std::min(grain, near * eye.pixel);
    seen = seen || in_view(eye, foot + Vec3(0, half, 0), half + 8 * crown + 3);
  }
  if (!seen || 2 * crown < kLeastPixels * grain) return CopyPlan::kUnseen;
  int level = 0;
  while (level + 1 < kLevelCount && kLevels[level + 1].grain <= grain * coarse) ++level;
  return static_cast<std::uint8_t>(level);
}

/// `Model_0123456789abcdef_2`, of the model and the level.
std::string model_name(const Organism& organism, int model, int level) {
  return fmt::format("Model_{}_{}", copy_id(organism, model), level);
}

void append_part_name(std::string& text, std::string_view model, std::size_t part) {
  text += model;
  text += '_';
  append_integer(text, static_cast<long long>(part));
}

void append_colors(std::string& text, const std::vector<Color>& colors) {
  text += fmt::format("array[{}]{{", colors.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (i > 0) text += ',';
    append_color(text, colors[i]);
  }
  text += '}';
}

std::string wood_look(const Look& look) {
  std::string text;
  if (look.coat) {
    text = fmt::format("Copy_Bark(\"{}\",\"{}\",", bark_color_name(*look.coat), bark_height_name(*look.coat));
    append(text, look.coat->relief, 4);
    return text + ",T)";
  }
  Bark plain;
  plain.kind = BarkKind::stem;
  if (look.skin) {
    plain.colors = {look.skin->tint.base};
    plain.second = look.skin->tint.secondary;
  }
  const Bark& b = look.bark ? *look.bark : plain;
  text = fmt::format("Copy_Wood({},", static_cast<int>(b.kind));
  append_color(text, b.colors[0]);
  text += ',';
  append_color(text, b.second);
  text += ',';
  append_list(text, 5, b.scale, b.depth);
  return text + ",T)";
}

std::string leaf_look(const std::vector<Color>& colors, const Color& second, Tissue tissue) {
  std::string text = "#local C = ";
  append_colors(text, colors);
  text += fmt::format("; texture{{{}(C,", kCopyMacros[static_cast<std::size_t>(tissue)]);
  append_color(text, second);
  return text + ",T)}";
}

/// What the macro of a part holds: a texture for the tint T.
std::string look_of(const CopyPart& part, const Look& look, const Model& model) {
  switch (part.kind) {
    case CopyPart::Kind::wood:
      return "texture{" + wood_look(look) + "}";
    case CopyPart::Kind::blade:
      return leaf_look(look.blades.colors, look.blades.second, look.blades.tissue);
    case CopyPart::Kind::organ: {
      const Prototype& prototype = model.prototypes[part.which];
      const OrganPart& organ = prototype.parts[part.part];
      if (organ.pictures.empty()) return leaf_look(prototype.colors, prototype.second, organ.tissue);
      std::string text = fmt::format("#local F = array[{}]{{", organ.pictures.size());
      for (std::size_t i = 0; i < organ.pictures.size(); ++i)
        text += fmt::format("{}\"{}\"", i > 0 ? "," : "", organ.pictures[i]);
      return text + "}; texture{Copy_Picture(F,T)}";
    }
    case CopyPart::Kind::solid:
      return material_text(model.solids.shapes[part.which].material);
  }
  return {};
}

/// No more of a part's mesh than shows at a level: a fortieth of a pixel, of far leaves facets and places to
/// a hundredth. Wood without pictures needs no places.
MeshText mesh_text(const CopyPart& part, const Look& look, int level) {
  double finest = kLevels[level].grain / 40 * kModelUnit;
  MeshText how;
  how.decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(finest))), 1, 4);
  how.flat = level >= 2 ? 0.7f : 0.9999f;
  how.uv_decimals = part.kind == CopyPart::Kind::wood && !look.coat ? -1 : level >= 2 ? 2 : 3;
  return how;
}

/// The tints of a stand, spread evenly over their range so that all of it occurs.
std::string tints_text(std::size_t stand, const Organism& organism) {
  const CopyTint& tint = organism.sown->tint;
  std::string text = fmt::format("#declare Tint{} = array[{}]{{", stand, kTints);
  for (int i = 0; i < kTints; ++i) {
    // Steps that are no multiples of each other, so that the three do not go together.
    auto spread = [&](int step) { return 2.0 * ((i * step) % kTints + 0.5) / kTints - 1; };
    text += i > 0 ? ",<" : "<";
    append_list(text, 4, degrees(tint.hue) * spread(5), 1 + tint.saturation * spread(7),
                1 + tint.value * spread(1));
    text += '>';
  }
  return text + "}\n";
}

bool sways(const SownStand& stand, const Film& film) {
  return stand.dress.motion.wave.amplitude > 0 && film.frames > 1;
}

/// How far the wind bends something at a place over, as a shear: metres a metre of height.
Vec2 bent(const Wave& wave, double film_length, Vec3 at, double time) {
  Vec2 wind(wave.direction.x, wave.direction.z);
  wind = glm::length(wind) > 1e-6f ? glm::normalize(wind) : Vec2(1, 0);
  double speed = wave.speed;
  if (wave.loop && film_length > 0) speed = std::max(1.0, std::round(speed * film_length)) / film_length;
  double along = glm::dot(Vec2(at.x, at.z), wind) / wave.length;
  double own =
      Seed{static_cast<std::uint64_t>(std::llround(at.x * 100) * 65537 + std::llround(at.z * 100))}.unit();
  double swing = std::sin(2 * kPi * (speed * time - along + 0.15 * own) + wave.phase);
  double side = std::sin(2 * kPi * (speed * time - along + own) + wave.phase);
  auto reach = static_cast<float>(0.25 * wave.amplitude);
  return wind * (reach * static_cast<float>(swing)) +
         Vec2(-wind.y, wind.x) * (0.4f * reach * static_cast<float>(side));
}

/// All copies of a stand: one union for each part of each model, level and tint.
std::string stand_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, std::size_t which,
                       double time) {
  const SownStand& stand = scene.stands[which];
  const Organism& organism = stand.organism;
  const Copies& copies = stand.copies;
  const Wave* wave = sways(stand, scene.film) ? &stand.dress.motion.wave : nullptr;
  std::map<std::array<int, 3>, std::string> groups;  // model, level, tint: lines without what they place
  for (std::size_t i = 0; i < copies.size(); ++i) {
    if (plan.level[which][i] == CopyPlan::kUnseen) continue;
    glm::mat3 frame = glm::mat3_cast(copies.turn[i]);
    if (wave) {
      Vec2 lean = bent(*wave, scene.film.length(), copies.foot[i], time);
      for (int axis = 0; axis < 3; ++axis) frame[axis] += Vec3(lean.x, 0, lean.y) * frame[axis].y;
    }
    frame *= copies.scale[i] * static_cast<float>(space.unit / kModelUnit);
    std::string& lines = groups[{copies.model[i], plan.level[which][i], copies.tint[i]}];
    append_matrix(lines, space, frame, copies.foot[i]);
    lines += "}\n";
  }
  std::string text;
  append_comment(text, organism.name);
  for (const auto& [key, lines] : groups) {
    int model = key[0], level = key[1], tint = key[2];  // clang 14 lets no lambda see parts of a binding
    std::string name = model_name(organism, model, level);
    auto file = std::find_if(plan.files.begin(), plan.files.end(), [&](const ModelFile& f) {
      return f.stand == which && f.model == model && f.level == level;
    });
    for (int part = 0; part < file->parts; ++part) {
      text += group_opening(lines);
      for (std::size_t from = 0; from < lines.size();) {
        std::size_t to = lines.find('\n', from) + 1;
        text += "object{";
        append_part_name(text, name, static_cast<std::size_t>(part));
        text += ' ';
        text.append(lines, from, to - from);
        from = to;
      }
      append_part_name(text, name, static_cast<std::size_t>(part));
      text += fmt::format("_Look(Tint{}[{}])}}\n", which, tint);
    }
  }
  return text;
}

std::string stands_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, double time,
                        bool swaying) {
  std::vector<std::string> texts(plan.level.size());  // no plan: no copies
  parallel_for(texts.size(), [&](std::size_t s) {
    if (sways(scene.stands[s], scene.film) == swaying) texts[s] = stand_text(space, scene, plan, s, time);
  });
  std::string text;
  for (const std::string& part : texts) text += part;
  return text;
}

}  // namespace

CopyPlan plan_copies(const Scene& scene) {
  CopyPlan plan;
  std::vector<Eye> all = eyes(scene);
  double coarse = scene.film.quality == Quality::draft ? 1.5 : 1;
  for (std::size_t s = 0; s < scene.stands.size(); ++s) {
    const SownStand& stand = scene.stands[s];
    const Organism& organism = stand.organism;
    const Copies& copies = stand.copies;
    double crown = organism.sown->where.radius, tall = tallest(organism);
    std::vector<std::uint8_t> level(copies.size());
    parallel_for(copies.size(), [&](std::size_t i) {
      level[i] = level_of(all, copies.foot[i], crown * copies.scale[i], tall * copies.scale[i], coarse);
    });
    std::set<std::pair<int, int>> used;
    for (std::size_t i = 0; i < copies.size(); ++i)
      if (level[i] != CopyPlan::kUnseen) used.insert({copies.model[i], level[i]});
    for (auto [model, which] : used) {
      std::string name = fmt::format("model_{}_{}.inc", copy_id(organism, model), which);
      plan.files.push_back({s, model, which, std::move(name), 0});
    }
    plan.level.push_back(std::move(level));
  }
  return plan;
}

std::string model_text(const ModelFile& file, const SownStand& stand, const Model& model) {
  const Organism& organism = stand.organism;
  const Look& look = stand.dress.look;
  std::vector<CopyPart> parts = copy_parts(look, model, kLevels[file.level]);
  std::string name = model_name(organism, file.model, file.level);
  std::string text;
  append_comment(text, fmt::format("{} parts: {} segments, {} organs", parts.size(),
                                   std::max<std::size_t>(1, model.skeleton.size()) - 1, model.organs.size()));
  std::set<std::string_view> includes{"copy"};
  for (const CopyPart& part : parts)
    if (part.kind == CopyPart::Kind::solid)
      includes.insert(material_include(model.solids.shapes[part.which].material));
  for (std::string_view include : includes) text += fmt::format("#include \"frond_{}.inc\"\n", include);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += "#declare ";
    append_part_name(text, name, i);
    text += " = ";
    append_mesh(text, PovSpace{kModelUnit}, parts[i].surface, mesh_text(parts[i], look, file.level));
    text += "\n#macro ";
    append_part_name(text, name, i);
    text += "_Look(T) " + look_of(parts[i], look, model) + " #end\n";
  }
  return text;
}

std::optional<int> model_parts(std::string_view text) {
  constexpr std::string_view kStart = "// ";
  if (!text.starts_with(kStart)) return std::nullopt;
  text.remove_prefix(kStart.size());
  int parts = 0;
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parts);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc{} && text.starts_with(" parts: ") ? std::optional(parts) : std::nullopt;
}

std::string still_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan) {
  std::string text;
  std::set<std::string_view> names;  // two stands may share a model
  for (const ModelFile& file : plan.files)
    if (names.insert(file.name).second) text += "#include \"" + file.name + "\"\n";
  for (std::size_t s = 0; s < scene.stands.size(); ++s) text += tints_text(s, scene.stands[s].organism);
  return text + stands_text(space, scene, plan, 0, false);
}

std::string swaying_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan,
                                double time) {
  return stands_text(space, scene, plan, time, true);
}

}  // namespace frond
