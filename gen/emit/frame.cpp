#include "emit/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/content.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "core/text.h"
#include "emit/body.h"
#include "emit/camera.h"
#include "emit/eyes.h"
#include "emit/focus.h"
#include "emit/plant.h"
#include "emit/polyps.h"
#include "emit/setting.h"
#include "emit/skin.h"
#include "emit/solid.h"
#include "world/world.h"

namespace frond {

namespace {

constexpr std::int32_t kPartNodes = 20'000;    // of one organism, written by one thread at a time
constexpr std::size_t kPartsAtOnce = 16;       // such parts, whose text is held
constexpr std::size_t kLinesAtOnce = 200'000;  // of organisms, whose text is held

/// The skin of each organism, at all its ages.
void append_skins(std::string& text, const Scene& scene, std::span<const std::size_t> first) {
  for (std::size_t i = 0; i < scene.specimens.size(); ++i) {
    const Specimen& b = scene.specimens[i];
    if (b.look.bark) {
      append_bark(text, b, first[i]);
      continue;
    }
    if (!b.look.skin) continue;
    const Pores& pores = b.look.skin->pores;
    const Tint& tint = b.look.skin->tint;
    std::string of = "(";
    append_integer(of, static_cast<long long>(first[i]));
    of += ',';
    append_integer(of, static_cast<int>(b.look.skin->kind));
    of += ',';
    append_color(of, tint.base);
    of += ',';
    append_color(of, tint.secondary);
    of += ',';
    append_list(of, 5, pores.cell, pores.warp, pores.depth, degrees(tint.hue), tint.saturation, tint.value,
                b.brightness, tint.young);
    of += ") ";
    text += "Coral_Skin" + of;
    if (!b.model.light.empty()) text += "Coral_Starving" + of;
    if (double glow = b.look.skin->polyps.glow; glow > 0) {
      std::string skin = "Skin[" + number_text(static_cast<double>(first[i])) + "]";
      text += "#declare " + skin + " = texture{" + skin + " Reef_Glow(" + number_text(glow) + ")} ";
    }
    append_comment(text, b.name);
  }
}

/// One food object for each place that an organism is drawn to.
std::string food_text(const PovSpace& space, const Scene& scene, double time) {
  std::string text;
  for (const auto& [at, left] : food_places(scene.specimens, time)) {
    std::string scale = number_text(std::cbrt(static_cast<double>(left)), 4);
    if (scale == "0") continue;  // which POV-Ray takes for 1
    text += "object{Food_Swarm() ";
    if (left < 1) text += "scale " + scale + ' ';
    text += "translate";
    append_point(text, space, at);
    text += "}\n";
  }
  return text;
}

/// Objects, one a line, in one group; none where there is none.
class Group {
 public:
  explicit Group(const Out& out) : out_(out) {}

  void add(std::string_view lines) {
    if (open_) return out_(lines);
    held_ += lines;
    if (std::count(held_.begin(), held_.end(), '\n') < 2) return;  // which opening it takes is not known yet
    open_ = true;
    out_(group_opening(held_));
    out_(std::exchange(held_, {}));
  }

  void close(std::string_view texture) {
    if (!open_ && held_.empty()) return;
    if (!open_) out_(group_opening(held_)), out_(held_);
    out_(texture);
  }

 private:
  const Out& out_;
  std::string held_;
  bool open_ = false;
};

std::string skin_texture(std::size_t index) {
  std::string text = "texture{Skin[";
  append_integer(text, static_cast<long long>(index));
  return text + "]}";
}

/// The first nodes of parts of about kPartNodes nodes that are whole chains, and one behind the last.
std::vector<std::int32_t> parts_of(const Skeleton& s) {
  std::vector<std::int32_t> first{0};
  auto n = static_cast<std::int32_t>(s.size());
  for (std::int32_t i = kPartNodes; i < n;) {
    if (s.parent[i] == i - 1) {
      ++i;
      continue;
    }
    first.push_back(i);
    i += kPartNodes;
  }
  first.push_back(n);
  return first;
}

/// Writes a line for each chunk in turn, `append(text, chunk)`; parts of them at a time by several threads,
/// so that neither all chunks nor all lines are held at once.
template <class Append>
void write_chunks(const Specimen& b, const Pose& pose, const ChunkOptions& options, Group& group,
                  const Append& append) {
  std::vector<std::int32_t> first = parts_of(b.model.skeleton);
  float longest = b.model.skeleton.longest();
  std::vector<std::string> texts(std::min<std::size_t>(first.size() - 1, kPartsAtOnce));
  for (std::size_t done = 0; done + 1 < first.size(); done += texts.size()) {
    std::size_t count = std::min(texts.size(), first.size() - 1 - done);
    parallel_for(count, [&](std::size_t i) {
      texts[i].clear();
      for (const Chunk& chunk :
           cut_chunks(b.model.skeleton, pose, options, longest, first[done + i], first[done + i + 1]))
        append(texts[i], chunk);
    });
    for (std::size_t i = 0; i < count; ++i) group.add(texts[i]);
  }
}

/// The sweeps of twigs: one union with one texture.
template <class IsTwig>
void write_twigs(const PovSpace& space, const Specimen& b, const Pose& pose, const ChunkOptions& options,
                 std::size_t index, const IsTwig& is_twig, const Out& out) {
  Group group(out);
  write_chunks(b, pose, options, group, [&](std::string& text, const Chunk& chunk) {
    if (is_twig(chunk.first) && append_sweep(text, space, b.model.skeleton, pose, chunk)) text += "}\n";
  });
  group.close(skin_texture(index) + "}\n");
}

/// The sweeps of all other chunks.
template <class IsTwig>
void write_sweeps(const PovSpace& space, const Specimen& b, const Pose& pose, const ChunkOptions& options,
                  std::size_t index, const IsTwig& is_twig, const Out& out) {
  Group group(out);
  bool whole = one_texture(b);
  write_chunks(b, pose, options, group, [&](std::string& text, const Chunk& chunk) {
    if (is_twig(chunk.first) || !append_sweep(text, space, b.model.skeleton, pose, chunk)) return;
    if (!whole || slanted(b, chunk)) {
      text += ' ';
      append_chunk_texture(text, space, b, pose, chunk, index);
    }
    text += "}\n";
  });
  group.close(whole ? skin_texture(index) + "}\n" : "}\n");
}

ChunkOptions chunk_options(const Specimen& b) {
  ChunkOptions options;
  if (b.look.skin) {
    options.tolerance = static_cast<float>(0.15 * b.look.skin->pores.cell);
    options.young_length = static_cast<float>(b.look.skin->tint.young_length);
  }
  if (b.look.bark) {
    options.tolerance = patterned(*b.look.bark) ? static_cast<float>(0.15 * b.look.bark->scale)
                                                : std::numeric_limits<float>::infinity();
    options.young_length = static_cast<float>(b.look.bark->young_length);
    options.color = b.model.color;
    if (ringed(*b.look.bark)) options.nodes = 5;  // so that rings lie across also where it bends
    // Of a swaying tree only what is thick has a bark that one could see slide.
    if (b.motion.limbs && !one_texture(b)) options.thin = static_cast<float>(0.6 * b.look.bark->scale);
  }
  return options;
}

Errors write_wood(const PovSpace& space, const Specimen& b, const Pose& pose, std::size_t index, Vec3 eye,
                  const Out& out) {
  ChunkOptions options = chunk_options(b);
  if (b.look.coat && b.style.build == Build::sweeps) {
    out(coat_text(space, b, pose, eye));
    if (b.look.coat->twigs <= 0) return {};
    options.tolerance = std::numeric_limits<float>::infinity();
    std::vector<bool> bare = coatless(b);
    auto is_twig = [&](std::int32_t i) { return static_cast<bool>(bare[static_cast<std::size_t>(i)]); };
    write_twigs(space, b, pose, options, index, is_twig, out);
    return {};
  }
  if (b.style.build == Build::sweeps) {
    auto is_twig = [&](std::int32_t i) { return b.model.skeleton.radius[i] < options.thin; };
    if (options.thin > 0) write_twigs(space, b, pose, options, index, is_twig, out);
    write_sweeps(space, b, pose, options, index, is_twig, out);
    return {};
  }
  Result<std::string> body = body_text(space, b, pose, cut_chunks(b.model.skeleton, pose, options), index);
  if (!body) return body.errors();
  out(*body);
  return {};
}

/// Gives how many nodes there are by then.
Result<std::size_t> write_branches(const PovSpace& space, const Specimen& b, std::size_t index,
                                   const Eye& eye, double time, const Out& out) {
  if (!b.look.skin && !b.look.bark) return 0;
  Pose pose;
  pose_specimen(b, time, pose);
  bool named = false;
  Out under_name = [&](std::string_view piece) {
    if (piece.empty()) return;
    std::string name;
    if (!std::exchange(named, true)) append_comment(name, b.name);
    out(name);
    out(piece);
  };
  if (Errors errors = write_wood(space, b, pose, index, eye.at, under_name); !errors.empty()) return errors;
  write_foliage(space, b, pose, time, under_name);
  if (b.look.skin && b.look.skin->polyps.width > 0) under_name(branch_polyps_text(space, b, pose, time, eye));
  const std::vector<float>& birth = b.model.skeleton.birth;
  return static_cast<std::size_t>(
      std::ranges::count_if(birth, [&](float born) { return born <= pose.front; }));
}

/// Writes organism i as it is at a time.
Result<std::size_t> write_organism(const FrameParts& parts, const Scene& scene, std::size_t i, double time,
                                   const Out& out) {
  const Specimen& b = scene.specimens[i];
  Eye eye = eye_at(scene, time);
  const Solids& solids = solids_of(parts.solids, scene, i);
  if (std::string text = growing_solids_text(parts.space, solids, b.motion.growth, time); !text.empty())
    out(text);
  if (std::string text = polyps_text(parts.space, solids, parts.polyps[i], b.motion.growth, time, eye);
      !text.empty())
    out(text);
  if (!b.life.changes()) return write_branches(parts.space, b, parts.first_skin[i], eye, time, out);
  Result<Specimen> now = developed(b, time);
  if (now && b.life.develop) out(developed_solids_text(parts.space, now->model.solids, i));
  return now ? write_branches(parts.space, *now, parts.first_skin[i], eye, time, out) : now.errors();
}

/// About how many lines an organism takes.
std::size_t lines_of(const Specimen& b) {
  return b.model.skeleton.size() + b.model.organs.size() + b.model.blades.size();
}

/// Small ones are written side by side and put together, large ones one by one with nothing held.
std::size_t write_organisms(const FrameParts& parts, const Scene& scene, double time, Errors& errors,
                            const Out& out) {
  std::size_t nodes = 0;
  auto take = [&](const Result<std::size_t>& written) {
    if (written)
      nodes += *written;
    else
      errors.insert(errors.end(), written.errors().begin(), written.errors().end());
  };
  for (std::size_t from = 0, to = 0; from < scene.specimens.size() && errors.empty(); from = to) {
    for (std::size_t lines = 0; to < scene.specimens.size(); ++to) {
      lines += lines_of(scene.specimens[to]);
      if (lines > kLinesAtOnce && to > from) break;
    }
    if (to == from + 1) {
      take(write_organism(parts, scene, from, time, out));
      continue;
    }
    std::vector<std::string> texts(to - from);
    std::vector<Result<std::size_t>> written(texts.size(), 0);
    parallel_for(texts.size(), [&](std::size_t i) {
      written[i] =
          write_organism(parts, scene, from + i, time, [&](std::string_view piece) { texts[i] += piece; });
    });
    for (const Result<std::size_t>& one : written) take(one);
    for (const std::string& text : texts) out(text);
  }
  return nodes;
}

constexpr std::size_t kAside = 4'000'000;  // bytes that are not worth a file

/// Puts what is the same in all frames of a film into a file that they include, named by what is in it.
void put_aside(std::string& text, std::vector<Picture>& files) {
  if (text.size() < kAside) return;
  std::string name = fmt::format("part_{}.inc", content_id(text));
  files.push_back({name, std::move(text)});
  text = "#include \"" + name + "\"";
}

}  // namespace

FrameParts prepare_frames(const Scene& scene, CopyPlan plan) {
  float thinnest = std::numeric_limits<float>::infinity();
  for (const Specimen& b : scene.specimens)
    for (float radius : b.model.skeleton.radius) thinnest = std::min(thinnest, radius);
  FrameParts parts;
  parts.space = space_for(thinnest);
  std::size_t skins = 0;
  for (const Specimen& b : scene.specimens) {
    parts.first_skin.push_back(skins);
    skins += b.look.bark ? b.look.bark->colors.size() : b.look.skin ? 1 : 0;
  }
  std::string count = number_text(static_cast<double>(std::max<std::size_t>(1, skins)));
  parts.materials =
      "#declare Skin = array[" + count + "];\n#declare Skin_Pigment = array[" + count + "][2];\n";
  if (std::ranges::any_of(scene.specimens, [](const Specimen& b) { return !b.model.light.empty(); }))
    parts.materials +=
        "#declare Skin_Bleached = array[" + count + "];\n#declare Skin_Dead = array[" + count + "];\n";
  append_skins(parts.materials, scene, parts.first_skin);
  parts.materials += prototypes_text(parts.space, scene);
  parts.solids = drawn_solids(scene);
  parts.polyps.resize(scene.specimens.size());
  parallel_for(parts.polyps.size(),
               [&](std::size_t i) { parts.polyps[i] = polyp_places(solids_of(parts.solids, scene, i)); });
  parts.ground = ground_text(parts.space, scene) + solids_text(parts.space, scene, parts.solids);
  parts.copies.resize(plan.drawn.size());
  parallel_for(parts.copies.size(),
               [&](std::size_t k) { parts.copies[k] = still_copies_text(parts.space, scene, plan, k); });
  parts.plan = std::move(plan);
  if (scene.film.frames > 1) {
    put_aside(parts.materials, parts.files);
    put_aside(parts.ground, parts.files);
    for (std::string& some : parts.copies) put_aside(some, parts.files);
  }
  return parts;
}

std::string light_name(int frame) { return frame_name(frame) + ".rca"; }

Result<std::size_t> write_frame(const Scene& scene, const FrameParts& parts, std::string_view layout,
                                int frame, const Out& out, int exposure) {
  const Film& film = scene.film;
  const Camera& camera = scene.stage.camera;
  int all = exposure > 0 ? exposures(film, camera) : 1;
  double time = exposure > 0 ? exposure_time(film, camera, frame, exposure) : film.time(frame);
  Errors errors;
  std::size_t nodes = 0;
  fill(layout, out, [&](std::string_view hole) {
    if (hole == "frame") return out(number_text(frame));
    if (hole == "frames") return out(number_text(film.frames));
    if (hole == "file") return out(exposure_name(frame, exposure) + ".pov");
    if (hole == "width") return out(number_text(film.size[0]));
    if (hole == "height") return out(number_text(film.size[1]));
    if (hole == "unit") return out(number_text(parts.space.unit));
    if (hole == "quality") return out(number_text(static_cast<int>(film.quality)));
    if (hole == "light") {
      if (parts.light.empty()) return;
      return out("+RFI +RF" + (parts.light == kOwnLight ? light_name(frame) : parts.light) + " ");
    }
    if (hole == "tone") return out(tone_text(camera, std::max(exposure, 1), all));
    if (hole == "time") return out(number_text(time));
    if (hole == "loop") return out(number_text(film.length()));
    if (hole == "includes") return out(includes_text(scene));
    if (hole == "setting") return out(setting_text(scene, time));
    if (hole == "camera")
      return out(camera_text(parts.space, camera, film.quality, time, named_focus(scene, time)));
    if (hole == "materials") return out(parts.materials);
    if (hole == "ground") {
      out(parts.ground);
      if (!parts.copies.empty()) out(parts.copies[parts.plan.stretch_of(frame)]);
      return;
    }
    if (hole == "organisms") {
      nodes = write_organisms(parts, scene, time, errors, out);
      return out(swaying_copies_text(parts.space, scene, parts.plan, frame, time));
    }
    if (hole == "food") return out(food_text(parts.space, scene, time));
    errors.push_back({"templates/frame.pov", "no such hole: {{" + std::string(hole) + "}}"});
  });
  if (!errors.empty()) return errors;
  return nodes;
}

Result<std::string> frame_text(const Scene& scene, const FrameParts& parts, std::string_view layout,
                               int frame) {
  std::string text;
  Result<std::size_t> written =
      write_frame(scene, parts, layout, frame, [&](std::string_view piece) { text += piece; });
  if (!written) return written.errors();
  return text;
}

}  // namespace frond
