#include "emit/copies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/parallel.h"
#include "draw/copy_axes.h"
#include "emit/solid.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr int kMossSteps = 24;  // that logs become green in

/// The tints of a copy set; `by` is what shifts all of them.
std::string tints_text(std::size_t copy_set, const Organism& organism, const ColorShift& by = {}) {
  std::string text = fmt::format("#declare Tint{} = array[{}]{{", copy_set, kTints);
  for (int i = 0; i < kTints; ++i) {
    ColorShift shift = tint_shift(organism.sown->tint, i);
    if (i > 0) text += ',';
    append_vector(text, 4, degrees(shift.hue + by.hue), shift.saturation * by.saturation,
                  shift.value * by.value);
  }
  return text + "}\n";
}

/// Whether the tints of a copy set change over the film.
bool tints_change(const CopySet& set) {
  const std::optional<ColorCourse>& tint = set.organism.courses.tint;
  return tint && !tint->plain();
}

/// What the names of a file's looks begin with, for a copy set whose look changes.
std::string worn_name(std::size_t copy_set, const ModelFile& file) {
  return fmt::format("Worn{}_{}", copy_set, declared_name(file));
}

/// A look at a time, and the prototypes and materials of its model. What all tints do is left to those, but
/// for bodies, which have none.
struct WornLook {
  Look look;
  Model model;

  WornLook(const Look& own, const Model& all, const Condition& condition, double time) : model(all) {
    Condition untinted = condition;
    untinted.courses.tint.reset();
    look = look_at(own, untinted, time);
    const std::vector<Solid> shapes = model.solids.shapes;
    put_in_together(model, untinted, time);
    for (std::size_t k = 0; k < shapes.size(); ++k)
      model.solids.shapes[k].material = material_at(shapes[k].material, k, condition, time);
  }
};

/// Whether its copies are others in each frame.
bool moves(const CopySet& set, const Film& film) {
  return !set.copies.span.empty() || sways(set, film) || copy_growth(set.organism, film, 0) ||
         copy_seasons(set.organism, film);
}

/// Whether each copy carries its pattern with it, as the skin of colonies must; else what is drawn on copies
/// lies in the world, or on their `uv`, which costs less.
bool carries_pattern(const CopySet& set, const Film& film) {
  return moves(set, film) && set.organism.grower->traits().colony;
}

/// Gives the prototypes of leaves the colours that these have now, as many of each as there are leaves of it:
/// what has a look by places alone takes one of all colours.
void set_leaf_colors(std::vector<Prototype>& prototypes, const Organs& now) {
  constexpr std::size_t kColors = 12;
  for (std::size_t p = 0; p < prototypes.size(); ++p) {
    std::vector<Color>& colors = prototypes[p].colors;
    std::vector<std::size_t> worn;
    for (std::size_t i = 0; prototypes[p].summer > 0 && i < now.size(); ++i)
      if (now.prototype[i] == p) worn.push_back(color_index(now.color[i], colors.size()));
    if (worn.empty()) continue;
    std::ranges::sort(worn);
    std::vector<Color> some;
    for (std::size_t k = 0; k < kColors; ++k)
      some.push_back(colors[worn[(2 * k + 1) * worn.size() / (2 * kColors)]]);
    colors = std::move(some);
  }
}

/// What the copies of a set are made of at a time: the parts of its models' files, or, of a model that the
/// film sees grow, what there is of them, declared in the frame itself.
class CopySetParts {
 public:
  CopySetParts(const Scene& scene, const CopyPlan& plan, std::size_t which, double time)
      : film_(scene.film),
        set_(scene.copy_sets[which]),
        plan_(plan),
        which_(which),
        time_(time),
        seasons_(copy_seasons(set_.organism, film_)) {}

  struct Part {
    std::string name, look;  ///< what the name of its macro begins with
  };
  std::vector<Part> parts;

  /// Selects those of a model, of one level and block; `text` gets what has to be declared for them.
  void select(std::string& text, int model, const Drawn& one) {
    const ModelFile& file = plan_.file(which_, model, one);
    if (model_ != model) grow(model);
    std::string own = fmt::format("Growing{}_{}_{}_{}", which_, model, one.level, one.block + 1);
    if (!whole_ && own == name_) return;  // in another tint
    name_ = own, parts.clear();
    const bool worn_at_all = plan_.worn.contains({which_, model, one.level});
    if (whole_ || seasons_)
      add(declared_name(file), worn_at_all ? worn_name(which_, file) : declared_name(file), file.parts);
    if (whole_ || !now_) return;
    ModelBlocks blocks = blocks_of(plan_.surfels[which_][static_cast<std::size_t>(model)]);
    ModelFile here;
    here.level = one.level, here.block = one.block;
    const CopyDetail& detail = kLevels[one.level];
    std::optional<WornLook> worn_now;
    if (worn_at_all) {
      const WornModel& known = *plan_.worn.at({which_, model, one.level});
      Model ailing = *now_;
      add_ailing(ailing, set_.appearance.look, known.condition.courses);
      worn_now.emplace(set_.appearance.look, ailing, known.condition, time_);
    }
    const Look& look = worn_now ? worn_now->look : set_.appearance.look;
    const Model& here_now = worn_now ? worn_now->model : *now_;
    std::vector<CopyPart> all = copy_parts(look, here_now, detail, &blocks, seasons_ ? &leaves_ : nullptr);
    Model worn;
    if (seasons_ && detail.plain) worn = here_now, set_leaf_colors(worn.prototypes, leaves_);
    add(own, own, append_parts(text, own, look, seasons_ && detail.plain ? worn : here_now, all, here));
  }

  /// How far the model has grown, 0..1.
  double front() const { return front_; }

 private:
  void add(const std::string& name, const std::string& look, const std::vector<int>& numbers) {
    for (int part : numbers) {
      const auto p = static_cast<std::size_t>(part);
      parts.push_back({part_name(name, p), part_name(look, p)});
    }
  }

  void grow(int model) {
    model_ = model, whole_ = true, front_ = 1;
    auto growing = plan_.growing.find({which_, model});
    if (growing == plan_.growing.end()) return;
    if (seasons_) {
      whole_ = false, now_ = growing->second;
      leaves_ = copy_organs(set_.organism, model, *now_, *seasons_, time_);
      return;
    }
    Motion motion = set_.appearance.motion;
    motion.growth = paced(*copy_growth(set_.organism, film_, model), length_of(*growing->second));
    double front = growth_front(motion.growth, time_);
    front_ = std::min(front, 1.0);
    whole_ = front >= 1 + motion.growth.ripen;
    std::optional<Model> grown = whole_ ? std::nullopt : grown_by(*growing->second, motion, time_);
    now_ = grown ? std::make_shared<const Model>(std::move(*grown)) : nullptr;
  }

  const Film& film_;
  const CopySet& set_;
  const CopyPlan& plan_;
  std::size_t which_;
  double time_;
  std::optional<Seasons> seasons_;  // where its leaves change
  std::string name_;
  int model_ = -1;  // the last one that was taken
  bool whole_ = true;
  double front_ = 1;
  std::shared_ptr<const Model> now_;  // what there is of it, if not all
  Organs leaves_;                     // of that, at this time of the year
};

/// All copies of a set: one union for each part of each model, level, block and tint.
ObjectText copy_set_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, std::size_t which,
                         std::size_t stretch, double time) {
  const CopySet& set = scene.copy_sets[which];
  const Copies& copies = set.copies;
  bool carries = carries_pattern(set, scene.film);
  auto unit = static_cast<float>(space.unit / kModelUnit);
  std::map<std::array<int, 5>, std::string>
      groups;  // model, level, block, tint, moss: lines without what they place
  for (const Drawn& one : plan.drawn[stretch][which]) {
    std::size_t i = one.copy;
    if (!copies.there(i, time)) continue;
    glm::mat3 frame = copy_axes(set, scene.film, i, time);
    Vec3 scale = copies.scale_at(i, time) * (carries ? 1 : unit);
    for (int axis = 0; axis < 3; ++axis) frame[axis] *= scale[axis];
    std::string& lines = groups[{copies.model[i], one.level, one.block, copies.tint[i],
                                 static_cast<int>(std::lround(kMossSteps * copies.moss_at(i, time)))}];
    if (append_matrix(lines, space, frame, copies.foot[i])) lines += "}\n";
  }
  ObjectText all;
  std::string& text = all.text;
  append_comment(text, set.organism.name);
  CopySetParts made(scene, plan, which, time);
  for (const auto& [key, lines] : groups) {
    if (lines.empty()) continue;
    auto [model, level, block, tint, moss] = key;
    made.select(text, model, {0, static_cast<std::int16_t>(block), static_cast<std::int16_t>(level)});
    if (carries && !made.parts.empty()) append_front(text, made.front());
    for (const auto& [name, worn] : made.parts) {
      std::string object = name, look = worn + fmt::format("_Look(Tint{}[{}])", which, tint);
      if (moss > 0)
        look += fmt::format(" texture{{Copy_Moss({})}}", number_text(moss / double{kMossSteps}, 3));
      look += weather_over(is_snowy(scene.setup), is_rainy(scene.setup), Wetting::leaf);
      if (carries) object += " scale " + number_text(unit, 6) + ' ' + look;
      text += group_opening(lines);
      for (std::size_t from = 0; from < lines.size();) {
        std::size_t to = lines.find('\n', from) + 1;
        text += "object{" + object + ' ';
        text.append(lines, from, to - from);
        from = to;
      }
      text += carries ? "}\n" : look + "}\n";
      ++all.objects;
    }
  }
  return all;
}

ObjectText copy_sets_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan,
                          std::size_t stretch, double time, bool swaying) {
  if (plan.drawn.empty()) return {};
  std::vector<ObjectText> texts(scene.copy_sets.size());
  parallel_for(texts.size(), [&](std::size_t s) {
    if (moves(scene.copy_sets[s], scene.film) == swaying)
      texts[s] = copy_set_text(space, scene, plan, s, stretch, time);
  });
  ObjectText all;
  for (const ObjectText& part : texts) all += part;
  return all;
}

}  // namespace

std::string model_includes_text(const Scene& scene, const CopyPlan& plan, std::size_t stretch,
                                std::optional<double> time) {
  std::string text;
  std::set<std::pair<bool, std::string>>
      names;  // two copy sets may share a model; what is put together comes last
  for (std::size_t s = 0; s < scene.copy_sets.size() && !plan.drawn.empty(); ++s) {
    const Copies& copies = scene.copy_sets[s].copies;
    if (copies.span.empty() == time.has_value()) continue;
    for (Drawn one : plan.drawn[stretch][s]) {
      if (time && !copies.there(one.copy, *time)) continue;
      int model = copies.model[one.copy];
      const ModelFile& file = plan.file(s, model, one);
      if (!names.insert({file.blocks > 0, file.name}).second) continue;
      for (one.block = 0; one.block < file.blocks; ++one.block)
        names.insert({false, plan.file(s, model, one).name});
    }
  }
  for (const auto& [joined, name] : names) text += "#include \"" + name + "\"\n";
  return text;
}

std::string worn_copies_text(const Scene& scene, const CopyPlan& plan, std::size_t stretch, double time) {
  std::string text;
  for (std::size_t s = 0; s < scene.copy_sets.size(); ++s) {
    const CopySet& set = scene.copy_sets[s];
    if (tints_change(set)) text += tints_text(s, set.organism, set.organism.courses.tint->at(time));
    std::set<std::string> done;  // names of files
    std::map<std::pair<int, int>, WornLook> looks;
    auto declare = [&](int model, const Drawn& one) {
      auto worn = plan.worn.find({s, model, one.level});
      if (worn == plan.worn.end()) return;
      const ModelFile& file = plan.file(s, model, one);
      if (!done.insert(file.name).second) return;
      const WornModel& known = *worn->second;
      auto look = looks.find({model, one.level});
      if (look == looks.end())
        look = looks.try_emplace({model, one.level}, set.appearance.look, known.model, known.condition, time)
                   .first;
      append_looks(text, worn_name(s, file), look->second.look, look->second.model, known.parts, file);
    };
    if (plan.drawn.empty()) continue;
    for (const Drawn& one : plan.drawn[stretch][s]) declare(set.copies.model[one.copy], one);
  }
  return text;
}

ObjectText still_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan,
                             std::size_t stretch) {
  ObjectText all;
  for (std::size_t s = 0; s < scene.copy_sets.size(); ++s)
    if (!tints_change(scene.copy_sets[s])) all.text += tints_text(s, scene.copy_sets[s].organism);
  return all += copy_sets_text(space, scene, plan, stretch, 0, false);
}

ObjectText swaying_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, int frame,
                               double time) {
  std::size_t stretch = plan.stretch_of(frame);
  ObjectText all{model_includes_text(scene, plan, stretch, time)};
  return all += copy_sets_text(space, scene, plan, stretch, time, true);
}

}  // namespace frond
