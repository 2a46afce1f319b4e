#include "emit/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/frame_name.h"
#include "core/parallel.h"
#include "draw/draw_list.h"
#include "draw/eyes.h"
#include "draw/focus.h"
#include "draw/food.h"
#include "emit/branch_materials.h"
#include "emit/camera.h"
#include "emit/copies.h"
#include "emit/plant.h"
#include "emit/setting.h"
#include "emit/twigs.h"
#include "emit/weather.h"
#include "emit/worn.h"
#include "world/world.h"

namespace frond {

namespace {

constexpr std::int32_t kPartNodes = 20'000;    // of one organism, written by one thread at a time
constexpr std::size_t kPartsAtOnce = 16;       // such parts, whose text is held
constexpr std::size_t kLinesAtOnce = 200'000;  // of organisms, whose text is held
constexpr double kOffPixels = 0.15;   // by how much the outline of a branch may be away from where it is
constexpr double kDotPixels = 4;      // length along which no change of colour shows
constexpr double kPlainPixels = 0.6;  // radius of branches that show no pattern
constexpr double kLimbPixels = 2;     // as coarse are limbs whose twigs are small

/// A swarm, and an object of it for each place that an organism is drawn to.
std::string food_text(const PovSpace& space, const Scene& scene, double time) {
  std::string objects;
  for (const auto& [at, left] : food_places(scene.specimens, time)) {
    std::string scale = number_text(std::cbrt(static_cast<double>(left)), 4);
    if (scale == "0") continue;  // which POV-Ray takes for 1
    objects += "object{Food ";
    if (left < 1) objects += "scale " + scale + ' ';
    objects += "translate";
    append_point(objects, space, at);
    objects += "}\n";
  }
  if (objects.empty()) return objects;
  std::string text = "#declare Food = union{\n";
  for (const FoodGrain& grain : food_swarm(time, scene.film.length())) {
    text += "sphere{";
    append_point(text, space, grain.at);
    text += ',' + number_text(grain.radius * space.unit, kDecimals) + "}\n";
  }
  return text + "texture{Food_Grain()} no_shadow}\n" + objects;
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

  /// Gives how many groups there are: none or one.
  std::size_t close(std::string_view texture) {
    if (!open_ && held_.empty()) return 0;
    if (!open_) out_(group_opening(held_)), out_(held_);
    out_(texture);
    return 1;
  }

 private:
  const Out& out_;
  std::string held_;
  bool open_ = false;
};

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

/// How finely an organism is written.
struct Fineness {
  double pixel = 0;  ///< metres, where the camera comes nearest
  int decimals = kDecimals;

  double within() const { return kOffPixels * pixel; }
  /// Along what is shorter no change of colour shows.
  float dot() const { return static_cast<float>(kDotPixels * pixel); }
  /// Branches of a smaller radius show no pattern.
  float plain() const { return static_cast<float>(kPlainPixels * pixel); }
};

/// Writes a line for each chunk in turn, `append(texts, chunk)`, to one of several texts: the first becomes a
/// group with a texture, each of `others` one with a texture of its own, `texture_of(k)`. Parts of them are
/// written at a time by several threads, so that neither all chunks nor all lines of the first are held at
/// once. Gives how many groups there are.
template <class Append, class Texture>
std::size_t write_chunks(const DrawnBranches& b, const ChunkOptions& options, std::size_t others,
                         const Append& append, const std::string& texture, const Texture& texture_of,
                         const Out& out) {
  std::vector<std::int32_t> first = parts_of(b.rest());
  float longest = b.rest().longest();
  std::size_t at_once = std::min<std::size_t>(first.size() - 1, kPartsAtOnce);
  std::vector<std::vector<std::string>> texts(at_once, std::vector<std::string>(1 + others));
  std::vector<std::string> held(others);
  Group group(out);
  for (std::size_t done = 0; done + 1 < first.size(); done += at_once) {
    std::size_t count = std::min(at_once, first.size() - 1 - done);
    parallel_for(count, [&](std::size_t i) {
      for (std::string& text : texts[i]) text.clear();
      for (const Chunk& chunk :
           cut_chunks(b.rest(), b.pose, options, longest, first[done + i], first[done + i + 1]))
        append(texts[i], chunk);
    });
    for (std::size_t i = 0; i < count; ++i) {
      group.add(texts[i][0]);
      for (std::size_t k = 0; k < others; ++k) held[k] += texts[i][1 + k];
    }
  }
  std::size_t groups = group.close(texture + "}\n");
  for (std::size_t k = 0; k < others; ++k) {
    if (held[k].empty()) continue;
    Group other(out);
    other.add(held[k]);
    groups += other.close(texture_of(k) + "}\n");
  }
  return groups;
}

/// The sweeps of twigs: one union with one texture, and one for each other bark. Gives how many unions there
/// are.
template <class IsTwig>
std::size_t write_twigs(const PovSpace& space, const DrawnBranches& b, const ChunkOptions& options,
                        std::size_t index, const Fineness& fine, const IsTwig& is_twig, const Out& out) {
  const BranchLook& look = b.look();
  auto append = [&](std::vector<std::string>& texts, const Chunk& chunk) {
    if (!is_twig(chunk.first)) return;
    std::string& text = texts[look.others.empty() ? 0 : look.other(look.color_at(b.model, chunk.first))];
    if (append_sweep(text, space, b.rest(), b.pose, chunk, fine.within(), fine.decimals)) text += "}\n";
  };
  std::string weather = weather_over(b.traits.snowy, b.traits.wet, Wetting::wood);
  auto texture_of = [&](std::size_t k) { return skin_texture(index + look.color_of(k + 1)) + weather; };
  return write_chunks(b, options, look.others.size(), append, skin_texture(index) + weather, texture_of, out);
}

/// The sweeps of all chunks that are no twigs; those that show no pattern share textures. Gives how many
/// unions there are.
template <class IsTwig>
std::size_t write_sweeps(const PovSpace& space, const DrawnBranches& b, const ChunkOptions& options,
                         std::size_t index, const Fineness& fine, const IsTwig& is_twig, const Out& out) {
  bool whole = b.one_texture();
  SharedTextures shared{b, fine.dot()};
  std::string weather = weather_over(b.traits.snowy, b.traits.wet, Wetting::wood);
  auto append = [&](std::vector<std::string>& texts, const Chunk& chunk) {
    if (is_twig(chunk.first)) return;
    bool is_plain = !whole && b.rest().radius[static_cast<std::size_t>(chunk.first)] < fine.plain();
    std::optional<std::size_t> own = is_plain ? shared.of(chunk) : std::nullopt;
    std::string& text = texts[own ? 1 + *own : 0];
    if (!append_sweep(text, space, b.rest(), b.pose, chunk, fine.within(), fine.decimals)) return;
    if (!own && (!whole || b.slanted(chunk))) {
      text += ' ';
      append_chunk_texture(text, space, b, chunk, index);
      if (!whole) text += weather;
    }
    text += "}\n";
  };
  auto texture_of = [&](std::size_t k) { return shared.text(k, index) + weather; };
  return write_chunks(b, options, whole ? 0 : shared.count(), append,
                      whole ? skin_texture(index) + weather : "", texture_of, out);
}

/// Gives how many objects it is.
Result<std::size_t> write_wood(const PovSpace& space, const DrawnBranches& b, std::size_t index, Vec3 eye,
                               const Fineness& fine, const Out& out) {
  ChunkOptions options = b.chunk_options();
  BranchForm form = b.form();
  if (form == BranchForm::coat) {
    ObjectText coat = coat_text(space, b, eye, fine.pixel);
    out(coat.text);
    if (b.look().tube_shape().least <= 0 && b.look().others.empty()) return coat.objects;
    options.tolerance = std::numeric_limits<float>::infinity();
    std::vector<bool> bare = b.coatless(fine.pixel);
    auto is_twig = [&](std::int32_t i) { return static_cast<bool>(bare[static_cast<std::size_t>(i)]); };
    return coat.objects + write_twigs(space, b, options, index, fine, is_twig, out);
  }
  if (form == BranchForm::sweeps) {
    float twig = options.thin;
    if (!b.one_texture()) options.thin = std::max(options.thin, fine.plain());
    auto is_twig = [&](std::int32_t i) { return b.rest().radius[i] < twig; };
    std::size_t twigs = twig > 0 ? write_twigs(space, b, options, index, fine, is_twig, out) : 0;
    return twigs + write_sweeps(space, b, options, index, fine, is_twig, out);
  }
  Result<ObjectText> body = body_text(space, b, index);
  if (!body) return body.errors();
  out(body->text);
  return body->objects;
}

/// Writes the branches of an organism with their foliage and polyps. Gives what there is of them by then.
Result<FrameCount> write_branches(const PovSpace& space, const DrawList& drawn, std::size_t index,
                                  const Eye& eye, const Fineness& fine, double time, const Out& out) {
  if (!drawn.branches) return FrameCount{};
  const DrawnBranches& branches = *drawn.branches;
  bool named = false;
  Out under_name = [&](std::string_view piece) {
    if (piece.empty()) return;
    std::string name;
    if (!std::exchange(named, true)) append_comment(name, drawn.traits.name);
    out(name);
    out(piece);
  };
  Fineness limbs = fine;
  if (drawn.twigs) limbs.pixel *= kLimbPixels;
  Result<std::size_t> wood = write_wood(space, branches, index, eye.at, limbs, under_name);
  if (!wood) return wood.errors();
  ObjectText snow = bough_snow_text(space, drawn, time, fine.pixel);
  under_name(snow.text);
  FrameCount count{0, *wood + write_foliage(space, drawn, fine.pixel, under_name) + snow.objects};
  count.objects += write_palette(space, drawn, index, under_name);
  if (const Polyps* own = branches.look().polyps(); own && own->width > 0) {
    ObjectText polyps = polyps_text(space, drawn_polyps(branches, eye), time);
    under_name(polyps.text);
    count.objects += polyps.objects;
  }
  const std::vector<float>& birth = drawn.model.skeleton.birth;
  count.nodes = static_cast<std::size_t>(
      std::ranges::count_if(birth, [&](float born) { return born <= drawn.pose.front; }));
  return count;
}

/// Writes organism i as it is at a time.
Result<FrameCount> write_organism(const FrameParts& parts, const Scene& scene, std::size_t i, double time,
                                  const Out& out) {
  const Specimen& b = scene.specimens[i];
  Eye eye = eye_at(scene, time);
  auto now = developed(b, time);
  if (!now) return now.errors();
  const Solids& solids = parts.solids.of(scene, i);
  std::optional<Solids> developed;
  if (b.life.develop)
    developed = parts.solids.of(i, (*now)->model.solids);
  else if (b.life.condition && solids.size() > 0)
    developed = worn_at(solids, b, time);
  const Solids& drawn_solids = developed && !b.life.develop ? *developed : solids;
  DrawList drawn(**now, time, developed ? *developed : solids, parts.twigs[i].get());
  ObjectText bodies;
  for (const DrawnBody& body : drawn.bodies)
    if (body.now || b.life.develop) bodies += solid_text(parts.space, body, i, b.wet);
  for (const DrawnPolyps& polyps : drawn_polyps(drawn_solids, parts.polyps[i], b.motion.growth, time, eye))
    bodies += polyps_text(parts.space, polyps, time);
  for (const DrawnSepta& septa : drawn_septa(drawn_solids, parts.septa[i], b.motion.growth, time, eye))
    bodies += septa_text(parts.space, septa);
  out(bodies.text);
  Fineness fine{parts.pixel[i], decimals_for(parts.space, parts.pixel[i])};
  Result<FrameCount> count = write_branches(parts.space, drawn, parts.first_skin[i], eye, fine, time, out);
  if (count) count->objects += bodies.objects;
  return count;
}

/// About how many lines an organism takes.
std::size_t lines_of(const Specimen& b) {
  return b.model.skeleton.size() + b.model.organs.size() + b.model.blades.size();
}

/// Small ones are written side by side and put together, large ones one by one with nothing held.
FrameCount write_organisms(const FrameParts& parts, const Scene& scene, double time, Errors& errors,
                           const Out& out) {
  FrameCount count;
  auto count_in = [&](const Result<FrameCount>& written) {
    if (written)
      count += *written;
    else
      errors.insert(errors.end(), written.errors().begin(), written.errors().end());
  };
  for (std::size_t from = 0, to = 0; from < scene.specimens.size() && errors.empty(); from = to) {
    for (std::size_t lines = 0; to < scene.specimens.size(); ++to) {
      lines += lines_of(scene.specimens[to]);
      if (lines > kLinesAtOnce && to > from) break;
    }
    if (to == from + 1) {
      count_in(write_organism(parts, scene, from, time, out));
      continue;
    }
    std::vector<std::string> texts(to - from);
    std::vector<Result<FrameCount>> written(texts.size(), FrameCount{});
    parallel_for(texts.size(), [&](std::size_t i) {
      written[i] =
          write_organism(parts, scene, from + i, time, [&](std::string_view piece) { texts[i] += piece; });
    });
    for (const Result<FrameCount>& one : written) count_in(one);
    for (const std::string& text : texts) out(text);
  }
  return count;
}

}  // namespace

std::string light_name(int frame) { return frame_name(frame) + ".rca"; }

Result<FrameCount> write_frame(const Scene& scene, const FrameParts& parts, std::string_view layout,
                               int frame, const Out& out, int exposure) {
  const Film& film = scene.film;
  const Camera& camera = scene.setup.camera;
  int all = exposure > 0 ? exposures(film, camera) : 1;
  double time = exposure > 0 ? exposure_time(film, camera, frame, exposure) : film.time(frame);
  Errors errors;
  FrameCount count;
  fill(layout, out, [&](std::string_view hole) {
    if (hole == "frame") return out(number_text(frame));
    if (hole == "frames") return out(number_text(film.frames));
    if (hole == "file") return out(exposure_name(frame, exposure) + ".pov");
    if (hole == "width") return out(number_text(film.drawn_size()[0]));
    if (hole == "height") return out(number_text(film.drawn_size()[1]));
    if (hole == "unit") return out(number_text(parts.space.unit));
    if (hole == "quality") return out(number_text(static_cast<int>(film.quality)));
    if (hole == "light")
      return out(parts.light.empty()        ? ""
                 : parts.light == kOwnLight ? "+RFI +RF" + light_name(frame) + " "
                                            : "+RFI +RF" + parts.light + " ");
    if (hole == "tone")
      return out(tone_text(film, camera, std::max(exposure, 1), all) + mist_text(film, scene.setup, time));
    if (hole == "time") return out(number_text(time));
    if (hole == "loop") return out(number_text(film.length()));
    if (hole == "includes") return out(includes_text(scene));
    if (hole == "setting") return out(setting_text(scene, time));
    if (hole == "camera")
      return out(
          camera_text(parts.space, camera, film, time, named_focus(scene, time), sample_shift(film, frame)));
    if (hole == "materials") {
      out(parts.materials);
      return out(worn_text(scene, parts.first_skin, time));
    }
    if (hole == "ground") {
      out(parts.ground);
      if (!parts.plan.drawn.empty())
        out(worn_copies_text(scene, parts.plan, parts.plan.stretch_of(frame), time));
      if (!parts.copies.empty()) out(parts.copies[parts.plan.stretch_of(frame)]);
      return;
    }
    if (hole == "organisms") {
      count = write_organisms(parts, scene, time, errors, out);
      ObjectText swaying = swaying_copies_text(parts.space, scene, parts.plan, frame, time);
      count.objects += swaying.objects;
      return out(swaying.text);
    }
    if (hole == "food") {
      out(food_text(parts.space, scene, time));
      if (film.background == Background::transparent) return;
      out(adrift_text(parts.space, scene, time));
      if (film.transparent()) return;
      return out(falling_text(parts.space, scene, time));
    }
    errors.push_back({"templates/frame.pov", "no such hole: {{" + std::string(hole) + "}}"});
  });
  if (!errors.empty()) return errors;
  return count;
}

}  // namespace frond
