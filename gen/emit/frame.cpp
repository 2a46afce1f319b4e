#include "emit/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/parallel.h"
#include "core/text.h"
#include "emit/body.h"
#include "emit/coat.h"
#include "emit/plant.h"
#include "emit/setting.h"
#include "emit/skin.h"
#include "emit/solid.h"

namespace frond {

namespace {

constexpr std::size_t kPartNodes = 50'000;  // of one organism, written by one thread at a time

std::string number(double value, int decimals = 5) {
  std::string text;
  append(text, value, decimals);
  return text;
}

/// The skin of each organism, at all its ages.
void append_skins(std::string& text, const Scene& scene, std::span<const std::size_t> first) {
  for (std::size_t i = 0; i < scene.branches.size(); ++i) {
    const Branches& b = scene.branches[i];
    if (b.bark) {
      append_bark(text, b, first[i]);
      continue;
    }
    if (!b.skin) continue;
    const Pores& pores = b.skin->pores;
    const Tint& tint = b.skin->tint;
    text += "Coral_Skin(";
    append_integer(text, static_cast<long long>(first[i]));
    text += ',';
    append_integer(text, static_cast<int>(b.skin->kind));
    text += ',';
    append_color(text, tint.base);
    text += ',';
    append_color(text, tint.secondary);
    text += ',';
    append_list(text, 5, pores.cell, pores.warp, pores.depth, degrees(tint.hue), tint.saturation, tint.value,
                b.brightness, tint.young);
    text += ") ";
    append_comment(text, b.name);
  }
}

std::string camera_text(const PovSpace& space, const Camera& camera, double time) {
  Vec3 location = camera.location.at(time), view = camera.look_at.at(time) - location;
  bool upright = std::abs(view.y) > 0.999f * glm::length(view);
  std::string text = "camera{location";
  append_point(text, space, location);
  if (upright) text += " sky z";
  text += " right x*image_width/image_height angle ";
  append(text, camera.angle.at(time), 4);
  text += " look_at";
  append_point(text, space, camera.look_at.at(time));
  text += '}';
  return text;
}

/// One food object for each place that an organism is drawn to.
std::string food_text(const PovSpace& space, const Scene& scene, double time) {
  std::vector<Vec3> places;
  std::string text;
  for (const Branches& b : scene.branches) {
    if (b.motion.food.strength == 0 || !b.skin) continue;
    Vec3 at = b.motion.food.position.at(time);
    if (std::find(places.begin(), places.end(), at) != places.end()) continue;
    places.push_back(at);
    text += "object{Food_Swarm() translate";
    append_point(text, space, at);
    text += "}\n";
  }
  return text;
}

/// The sweeps of chunks first..last of one organism.
void append_part(std::string& text, const PovSpace& space, const Branches& b, const Pose& pose,
                 std::size_t index, std::span<const Chunk> chunks) {
  bool whole = one_texture(b);
  for (const Chunk& chunk : chunks) {
    if (!append_sweep(text, space, b.rest, pose, chunk)) continue;
    if (whole && !slanted(b, chunk)) {
      text += "}\n";
      continue;
    }
    text += ' ';
    append_chunk_texture(text, space, b, pose, chunk, index);
    text += "}\n";
  }
}

/// Takes twigs out of the chunks: one union with one texture.
template <class IsTwig>
std::string take_twigs(std::vector<Chunk>& chunks, const PovSpace& space, const Branches& b, const Pose& pose,
                       std::size_t index, const IsTwig& is_twig) {
  std::string lines;
  std::erase_if(chunks, [&](const Chunk& chunk) {
    if (!is_twig(chunk.first)) return false;
    if (append_sweep(lines, space, b.rest, pose, chunk)) lines += "}\n";
    return true;
  });
  if (lines.empty()) return lines;
  std::string text(group_opening(lines));
  text += lines + "texture{Skin[";
  append_integer(text, static_cast<long long>(index));
  return text + "]}}\n";
}

ChunkOptions chunk_options(const Branches& b) {
  ChunkOptions options;
  if (b.skin) {
    options.tolerance = static_cast<float>(0.15 * b.skin->pores.cell);
    options.young_length = static_cast<float>(b.skin->tint.young_length);
  }
  if (b.bark) {
    options.tolerance = patterned(*b.bark) ? static_cast<float>(0.15 * b.bark->scale)
                                           : std::numeric_limits<float>::infinity();
    options.young_length = static_cast<float>(b.bark->young_length);
    options.color = b.color;
    if (ringed(*b.bark)) options.nodes = 5;  // so that rings lie across also where it bends
    // Of a swaying tree only what is thick has a bark that one could see slide.
    if (b.motion.limbs && !one_texture(b)) options.thin = static_cast<float>(0.6 * b.bark->scale);
  }
  return options;
}

/// The sweeps of all chunks.
std::string sweeps_text(const PovSpace& space, const Branches& b, const Pose& pose,
                        const std::vector<Chunk>& chunks, std::size_t index) {
  std::size_t parts = b.rest.size() / kPartNodes + 1;
  std::vector<std::string> texts(parts);
  parallel_for(parts, [&](std::size_t p) {
    std::span<const Chunk> all(chunks);
    std::size_t from = chunks.size() * p / parts, to = chunks.size() * (p + 1) / parts;
    append_part(texts[p], space, b, pose, index, all.subspan(from, to - from));
  });
  std::string body;
  for (const std::string& text : texts) body += text;
  if (body.empty()) return body;
  std::string text(group_opening(body));
  if (one_texture(b)) {
    body += "texture{Skin[";
    append_integer(body, static_cast<long long>(index));
    body += "]}";
  }
  return text + body + "}\n";
}

Result<std::string> branches_text(const PovSpace& space, const Branches& b, std::size_t index, double time) {
  if (!b.skin && !b.bark) return std::string();
  Pose pose;
  pose_branches(b, time, pose);
  Result<std::string> body = std::string();
  bool coated = b.coat && b.style.build == Build::sweeps;
  if (coated) body = coat_text(space, b, pose);
  if (!coated || b.coat->twigs > 0) {
    ChunkOptions options = chunk_options(b);
    if (coated) options.tolerance = std::numeric_limits<float>::infinity();
    std::vector<Chunk> chunks = cut_chunks(b.rest, pose, options);
    if (coated) {
      std::vector<bool> bare = coatless(b);
      *body += take_twigs(chunks, space, b, pose, index, [&](std::int32_t i) {
        return static_cast<bool>(bare[static_cast<std::size_t>(i)]);
      });
    } else if (b.style.build == Build::sweeps) {
      std::string twigs = take_twigs(chunks, space, b, pose, index,
                                     [&](std::int32_t i) { return b.rest.radius[i] < options.thin; });
      body = twigs + sweeps_text(space, b, pose, chunks, index);
    } else {
      body = body_text(space, b, pose, chunks, index);
    }
  }
  if (!body) return body;
  std::string foliage = foliage_text(space, b, pose, time), text;
  if (body->empty() && foliage.empty()) return text;
  append_comment(text, b.name);
  return text + *body + foliage;
}

std::string all_branches_text(const FrameParts& parts, const Scene& scene, double time, Errors& errors) {
  std::vector<std::string> texts(scene.branches.size());
  std::vector<Errors> faults(texts.size());
  parallel_for(texts.size(), [&](std::size_t i) {
    const Branches& b = scene.branches[i];
    auto text_of = [&](const Branches& now) {
      return branches_text(parts.space, now, parts.first_skin[i], time);
    };
    auto text_of_stage = [&]() -> Result<std::string> {
      Result<Branches> now = developed(b, time);
      return now ? text_of(*now) : now.errors();
    };
    Result<std::string> text = b.develops() ? text_of_stage() : text_of(b);
    if (text)
      texts[i] = std::move(*text);
    else
      faults[i] = text.errors();
  });
  for (const Errors& fault : faults) errors.insert(errors.end(), fault.begin(), fault.end());
  std::string text;
  text.reserve(std::accumulate(texts.begin(), texts.end(), std::size_t{0},
                               [](std::size_t sum, const std::string& t) { return sum + t.size(); }));
  for (std::string& part : texts) {
    text += part;
    part = {};
  }
  return text;
}

constexpr std::size_t kAside = 4'000'000;  // bytes that are not worth a file

/// Puts what is the same in all frames of a film into a file that they include, named by what is in it.
void put_aside(std::string& text, std::vector<Picture>& files) {
  if (text.size() < kAside) return;
  std::string name = fmt::format("part_{:016x}.inc", Seed{}.child(text).key);
  files.push_back({name, std::move(text)});
  text = "#include \"" + name + "\"";
}

}  // namespace

FrameParts prepare_frames(const Scene& scene, CopyPlan plan) {
  float thinnest = std::numeric_limits<float>::infinity();
  for (const Branches& b : scene.branches)
    for (float radius : b.rest.radius) thinnest = std::min(thinnest, radius);
  FrameParts parts;
  parts.space = space_for(thinnest);
  std::size_t skins = 0;
  for (const Branches& b : scene.branches) {
    parts.first_skin.push_back(skins);
    skins += b.bark ? b.bark->colors.size() : b.skin ? 1 : 0;
  }
  std::string count = number(static_cast<double>(std::max<std::size_t>(1, skins)));
  parts.materials =
      "#declare Skin = array[" + count + "];\n#declare Skin_Pigment = array[" + count + "][2];\n";
  append_skins(parts.materials, scene, parts.first_skin);
  parts.materials += prototypes_text(parts.space, scene);
  parts.ground = ground_text(parts.space, scene) + solids_text(parts.space, scene) +
                 still_copies_text(parts.space, scene, plan);
  parts.plan = std::move(plan);
  if (scene.film.frames > 1) {
    put_aside(parts.materials, parts.files);
    put_aside(parts.ground, parts.files);
  }
  return parts;
}

Result<std::string> frame_text(const Scene& scene, const FrameParts& parts, std::string_view layout,
                               int frame) {
  const Film& film = scene.film;
  double time = film.time(frame);
  std::string padded = number(frame);
  padded.insert(0, padded.size() < 4 ? 4 - padded.size() : 0, '0');
  Errors errors;
  std::string text = fill(layout, [&](std::string_view hole) -> std::string {
    if (hole == "frame") return number(frame);
    if (hole == "frames") return number(film.frames);
    if (hole == "number") return padded;
    if (hole == "width") return number(film.size[0]);
    if (hole == "height") return number(film.size[1]);
    if (hole == "unit") return number(parts.space.unit);
    if (hole == "quality") return number(static_cast<int>(film.quality));
    if (hole == "time") return number(time);
    if (hole == "loop") return number(film.length());
    if (hole == "includes") return includes_text(scene);
    if (hole == "setting") return setting_text(scene, time);
    if (hole == "camera") return camera_text(parts.space, scene.stage.camera, time);
    if (hole == "materials") return parts.materials;
    if (hole == "ground") return parts.ground;
    if (hole == "organisms")
      return all_branches_text(parts, scene, time, errors) +
             swaying_copies_text(parts.space, scene, parts.plan, time);
    if (hole == "food") return food_text(parts.space, scene, time);
    errors.push_back({"templates/frame.pov", "no such hole: {{" + std::string(hole) + "}}"});
    return {};
  });
  if (!errors.empty()) return errors;
  return text;
}

}  // namespace frond
