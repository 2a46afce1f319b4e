#include "emit/copies.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/parallel.h"
#include "core/text.h"
#include "emit/eyes.h"
#include "emit/plant.h"
#include "emit/solid.h"
#include "motion/motion.h"

namespace frond {

namespace {

constexpr const char* kCopyMacros[] = {"Copy_Leaf",  "Copy_Petal", "Copy_Fruit",
                                       "Copy_Fruit", "Copy_Fruit", "Copy_Leaf"};  // of each Tissue

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
  if (look.skin) {
    const Pores& pores = look.skin->pores;
    const Tint& tint = look.skin->tint;
    text = fmt::format("Copy_Coral({},", static_cast<int>(look.skin->kind));
    append_color(text, tint.base);
    text += ',';
    append_color(text, tint.secondary);
    text += ',';
    append_list(text, 5, pores.cell, pores.warp, pores.depth, degrees(tint.hue), tint.saturation, tint.value,
                tint.young);
    return text + ",T)";
  }
  Bark plain;
  plain.kind = BarkKind::stem;
  const Bark& b = look.bark ? *look.bark : plain;
  text = fmt::format("Copy_Wood({},", static_cast<int>(b.kind));
  append_color(text, b.colors[0]);
  text += ',';
  append_color(text, b.second);
  text += ',';
  append_list(text, 5, b.scale, b.depth);
  return text + ",T)";
}

std::string leaf_look(const std::vector<Color>& colors, const Color& second, Tissue tissue, bool plain,
                      const std::optional<Luster>& luster) {
  std::string text = "#local C = ";
  append_colors(text, colors);
  std::string look = fmt::format("{}(C,", plain ? "Copy_Far" : kCopyMacros[static_cast<std::size_t>(tissue)]);
  append_color(look, second);
  return text + "; " + lustrous(look + ",T)", luster, plain ? "" : relief_macro(tissue), {});
}

/// What the macro of a part holds: a texture for the tint T.
std::string look_of(const CopyPart& part, const Look& look, const Model& model, bool plain) {
  switch (part.kind) {
    case CopyPart::Kind::wood:
      return "texture{" + wood_look(look) + "}";
    case CopyPart::Kind::blade:
      return leaf_look(look.blades.colors, look.blades.second, look.blades.tissue, false, {});
    case CopyPart::Kind::organ: {
      const Prototype& prototype = model.prototypes[part.which];
      const OrganPart& organ = prototype.parts[part.part];
      if (organ.pictures.empty())
        return leaf_look(prototype.colors, prototype.second, organ.tissue, plain, prototype.luster);
      std::string text = fmt::format("#local F = array[{}]{{", organ.pictures.size());
      for (std::size_t i = 0; i < organ.pictures.size(); ++i)
        text += fmt::format("{}\"{}\"", i > 0 ? "," : "", organ.pictures[i]);
      Luster luster = prototype.luster.value_or(Luster{.gloss = 0.13});
      return text +
             fmt::format("}}; texture{{Copy_Picture(F,T,{:.4g},{:.4g})}}", luster.through, luster.gloss);
    }
    case CopyPart::Kind::solid:
      return material_text(model.solids.shapes[part.which].material);
  }
  return {};
}

/// No more of a part's mesh than shows at a level: a fortieth of a pixel, from afar an eighth; of leaves of
/// some pixels facets, and places to a hundredth. Wood and plain leaves without pictures need no places.
MeshText mesh_text(const CopyPart& part, const Look& look, const Model& model, int level) {
  double finest = kLevels[level].grain / (kLevels[level].plain ? 8 : 40) * kModelUnit;
  MeshText how;
  how.decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(finest))), 1, 4);
  how.flat = level >= 1 ? 0.7f : 0.9999f;
  bool pictured =
      part.kind == CopyPart::Kind::wood ? look.coat || look.skin
      : part.kind == CopyPart::Kind::organ
          ? !kLevels[level].plain || !model.prototypes[part.which].parts[part.part].pictures.empty()
          : true;
  how.uv_decimals = !pictured ? -1 : level >= 2 ? 2 : 3;
  return how;
}

/// What is written of a part.
Surface skin_for(const CopyPart& part, const Model& model, const Surface& surface) {
  return part.kind == CopyPart::Kind::solid ? told(surface, model.solids.shapes[part.which]) : surface;
}

/// A part put together from its blocks, as their files declare them.
void append_joined(std::string& text, const CopyPart& part, std::string_view name, std::size_t which) {
  std::set<int> blocks(part.block.begin(), part.block.end());
  text += blocks.size() > 1 ? "union{" : "object{";
  for (int block : blocks) {
    if (blocks.size() > 1) text += "object{";
    append_part_name(text, fmt::format("{}_{}", name, block), which);
    if (blocks.size() > 1) text += '}';
  }
  text += '}';
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

/// Whether its copies are others in each frame.
bool moves(const SownStand& stand, const Film& film) {
  return sways(stand, film) || copy_growth(stand.organism, film, 0).has_value();
}

/// Whether each copy carries its pattern with it, as the skin of corals must; else what is drawn on copies
/// lies in the world, or on their `uv`, which costs less.
bool carries_pattern(const SownStand& stand, const Film& film) {
  return moves(stand, film) && stand.organism.grower->stage() == GrowthStage::in_space;
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

/// A part's mesh, which `mesh` appends, and the macro of its look.
template <class Mesh>
void append_part(std::string& text, std::string_view name, std::size_t number, const std::string& look,
                 const Mesh& mesh) {
  text += "#declare ";
  append_part_name(text, name, number);
  text += " = ";
  mesh(text);
  text += "\n#macro ";
  append_part_name(text, name, number);
  text += "_Look(T) " + look + " #end\n";
}

/// What there is of a growing model's parts at a level, or of one block of it, under a name of this frame;
/// `parts` is told which.
std::string growing_text(const std::string& name, const SownStand& stand, const Model& now, const Drawn& one,
                         const ModelBlocks& blocks, std::vector<int>& parts) {
  const Look& look = stand.dress.look;
  std::string text;
  std::vector<CopyPart> all = copy_parts(look, now, kLevels[one.level], &blocks);
  for (std::size_t p = 0; p < all.size(); ++p) {
    bool whole = one.block == ModelFile::kWhole;
    Surface some = whole ? Surface{} : in_block(all[p], one.block);
    if (!whole && some.triangle.empty()) continue;
    parts.push_back(static_cast<int>(p));
    append_part(text, name, p, look_of(all[p], look, now, kLevels[one.level].plain), [&](std::string& out) {
      append_mesh(out, PovSpace{kModelUnit}, skin_for(all[p], now, whole ? all[p].surface : some),
                  mesh_text(all[p], look, now, one.level));
    });
  }
  return text;
}

/// All copies of a stand: one union for each part of each model, level, block and tint.
std::string stand_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, std::size_t which,
                       std::size_t stretch, double time) {
  const SownStand& stand = scene.stands[which];
  const Organism& organism = stand.organism;
  const Copies& copies = stand.copies;
  const Wave* wave = sways(stand, scene.film) ? &stand.dress.motion.wave : nullptr;
  bool carries = carries_pattern(stand, scene.film);
  auto unit = static_cast<float>(space.unit / kModelUnit);
  std::map<std::array<int, 4>, std::string>
      groups;  // model, level, block, tint: lines without what they place
  for (const Drawn& one : plan.drawn[stretch][which]) {
    std::size_t i = one.copy;
    glm::mat3 frame = glm::mat3_cast(copies.turn[i]);
    if (wave) {
      Vec2 lean = bent(*wave, scene.film.length(), copies.foot[i], time);
      for (int axis = 0; axis < 3; ++axis) frame[axis] += Vec3(lean.x, 0, lean.y) * frame[axis].y;
    }
    frame *= copies.scale[i] * (carries ? 1 : unit);
    std::string& lines = groups[{copies.model[i], one.level, one.block, copies.tint[i]}];
    append_matrix(lines, space, frame, copies.foot[i]);
    lines += "}\n";
  }
  std::string text;
  append_comment(text, organism.name);
  std::optional<Model> now;
  int grown = -1;  // whose `now` is
  std::string of;
  std::vector<int> parts;
  for (const auto& [key, lines] : groups) {
    auto [model, level, block, tint] = key;
    Drawn one{0, static_cast<std::int16_t>(block), static_cast<std::int16_t>(level)};
    const ModelFile& file = plan.file(which, model, one);
    std::string name = declared_name(file);
    auto growing = plan.growing.find({which, model});
    Motion motion = stand.dress.motion;
    if (growing != plan.growing.end()) motion.growth = *copy_growth(organism, scene.film, model);
    double front = growing == plan.growing.end() ? 2 : growth_front(motion.growth, time);
    bool whole = front >= 1 + motion.growth.ripen;
    if (carries) text += fmt::format("#declare Reef_Front = {:.4g};\n", std::min(front, 1.0));
    if (whole) {
      parts = file.parts;
    } else {
      if (std::exchange(grown, model) != model) now = grown_by(*growing->second, motion, time), of.clear();
      if (!now) continue;
      name = fmt::format("Growing{}_{}_{}_{}", which, model, level, block + 1);
      if (std::exchange(of, name) != name) {
        parts.clear();
        ModelBlocks blocks = blocks_of(plan.crumbs[which][static_cast<std::size_t>(model)]);
        text += growing_text(name, stand, *now, one, blocks, parts);
      }
    }
    for (int part : parts) {
      std::string look = fmt::format("_Look(Tint{}[{}])", which, tint);
      text += group_opening(lines);
      for (std::size_t from = 0; from < lines.size();) {
        std::size_t to = lines.find('\n', from) + 1;
        text += "object{";
        append_part_name(text, name, static_cast<std::size_t>(part));
        text += ' ';
        if (carries) {
          text += "scale ";
          append(text, unit, 6);
          text += ' ';
          append_part_name(text, name, static_cast<std::size_t>(part));
          text += look + ' ';
        }
        text.append(lines, from, to - from);
        from = to;
      }
      if (!carries) {
        append_part_name(text, name, static_cast<std::size_t>(part));
        text += look;
      }
      text += "}\n";
    }
  }
  return text;
}

std::string stands_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, std::size_t stretch,
                        double time, bool swaying) {
  if (plan.drawn.empty()) return {};
  std::vector<std::string> texts(scene.stands.size());
  parallel_for(texts.size(), [&](std::size_t s) {
    if (moves(scene.stands[s], scene.film) == swaying)
      texts[s] = stand_text(space, scene, plan, s, stretch, time);
  });
  std::string text;
  for (const std::string& part : texts) text += part;
  return text;
}

}  // namespace

std::string declared_name(const ModelFile& file) {
  return "M" + file.name.substr(1, file.name.find('.') - 1);
}

std::vector<std::string> model_texts(const std::vector<ModelFile>& files, const SownStand& stand,
                                     const Model& model, const ModelBlocks& blocks) {
  const Look& look = stand.dress.look;
  int level = files[0].level;
  std::vector<CopyPart> all = copy_parts(look, model, kLevels[level], &blocks);
  std::vector<std::string> texts(files.size());
  parallel_for(files.size(), [&](std::size_t i) {
    const ModelFile& file = files[i];
    bool whole = file.block == ModelFile::kWhole;
    std::string name = declared_name(file), list, body;
    std::set<std::string_view> includes{"copy"};
    if (look.skin) includes.insert("coral");
    for (std::size_t p = 0; p < all.size(); ++p) {
      const CopyPart& part = all[p];
      Surface some = whole ? Surface{} : in_block(part, file.block);
      if (!whole && some.triangle.empty()) continue;
      if (part.kind == CopyPart::Kind::solid)
        includes.insert(material_include(model.solids.shapes[part.which].material));
      list += fmt::format(" {}", p);
      append_part(body, name, p, look_of(part, look, model, kLevels[level].plain), [&](std::string& out) {
        if (file.blocks > 0)
          append_joined(out, part, name, p);
        else
          append_mesh(out, PovSpace{kModelUnit}, skin_for(part, model, whole ? part.surface : some),
                      mesh_text(part, look, model, level));
      });
    }
    std::string& text = texts[i];
    append_comment(text,
                   fmt::format("parts{}; {} segments, {} organs", list,
                               std::max<std::size_t>(1, model.skeleton.size()) - 1, model.organs.size()));
    for (std::string_view include : includes) text += fmt::format("#include \"frond_{}.inc\"\n", include);
    text += body;
  });
  return texts;
}

std::optional<std::vector<int>> model_parts(std::string_view text) {
  constexpr std::string_view kStart = "// parts";
  if (!text.starts_with(kStart)) return std::nullopt;
  std::vector<int> parts;
  const char* at = text.data() + kStart.size();
  const char* end = text.data() + text.size();
  for (int part = 0; at < end && *at == ' '; parts.push_back(part)) {
    auto [next, error] = std::from_chars(at + 1, end, part);
    if (error != std::errc{}) return std::nullopt;
    at = next;
  }
  return at < end && *at == ';' ? std::optional(parts) : std::nullopt;
}

std::string still_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan,
                              std::size_t stretch) {
  std::string text;
  std::set<std::pair<bool, std::string>>
      names;  // two stands may share a model; what is put together comes last
  for (std::size_t s = 0; s < scene.stands.size() && !plan.drawn.empty(); ++s)
    for (Drawn one : plan.drawn[stretch][s]) {
      int model = scene.stands[s].copies.model[one.copy];
      const ModelFile& file = plan.file(s, model, one);
      if (!names.insert({file.blocks > 0, file.name}).second) continue;
      for (one.block = 0; one.block < file.blocks; ++one.block)
        names.insert({false, plan.file(s, model, one).name});
    }
  for (const auto& [joined, name] : names) text += "#include \"" + name + "\"\n";
  for (std::size_t s = 0; s < scene.stands.size(); ++s) text += tints_text(s, scene.stands[s].organism);
  return text + stands_text(space, scene, plan, stretch, 0, false);
}

std::string swaying_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, int frame,
                                double time) {
  return stands_text(space, scene, plan, plan.stretch_of(frame), time, true);
}

}  // namespace frond
