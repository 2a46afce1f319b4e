#include "film/film_files.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "core/content.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/growing_file.h"
#include "core/parallel.h"
#include "draw/ambience.h"
#include "draw/solids.h"
#include "emit/setting.h"
#include "film/model_summary.h"
#include "film/soft_light.h"
#include "images/whole.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Makes so many things side by side, each a step of a phase; the errors of the first that cannot be made.
Errors make_each(const ProgressSink& watch, std::string_view phase, std::size_t count,
                 const std::function<Errors(std::size_t)>& make) {
  watch.begin(phase, count);
  std::vector<Errors> errors(count);
  parallel_for(count, [&](std::size_t i) {
    errors[i] = make(i);
    if (errors[i].empty()) watch.step();
  });
  for (Errors& list : errors)
    if (!list.empty()) return std::move(list);
  return {};
}

/// Writes a file whole.
Errors put(const fs::path& file, std::string_view text) {
  Result<bool> written = write_file(file, text);
  return written ? Errors{} : written.errors();
}

/// With no more triangles of bodies than show at a level.
Model for_level(Model model, int level) {
  for (Solid& solid : model.solids.shapes)
    if (std::optional<Coarser> less = coarser(solid, kLevels[level].grain, Quality::good))
      solid = drawn_coarser(solid, *less);
  return model;
}

/// A model of one copy set or, of one species, of several.
struct SownModel {
  struct Use {
    std::size_t copy_set;
    ModelPlan plan;
  };
  std::vector<Use> uses;
  int number = 0;
  std::string summary_name;
  ModelSummary summary;
  std::vector<std::vector<ModelFile>> missing;  // of each level; empty: nothing is known of it yet
  std::shared_ptr<const Model> grown;           // where the film sees it grow
  std::map<std::pair<std::size_t, int>, std::shared_ptr<const WornModel>> worn;  // by copy set and level
};

/// Plans the files of all models that stand in a scene and writes those that are not there.
class ModelWriter {
 public:
  ModelWriter(const Scene& scene, const fs::path& folder) : scene_(scene), folder_(folder), views_(scene) {
    for (std::size_t s = 0; s < scene.copy_sets.size(); ++s)
      for (int model : models_of(scene.copy_sets[s])) {
        std::string id = id_of(s, model);
        SownModel& one = models_[id];
        one.uses.push_back({s, {}});
        one.number = model;
        one.summary_name = "model_" + id + ".summary";
      }
  }

  Result<CopyPlan> write(const ProgressSink& watch) {
    std::vector<SownModel*> each, to_grow;
    for (auto& [id, one] : models_) each.push_back(&one);
    parallel_for(each.size(), [&](std::size_t i) { look_up(*each[i]); });
    std::ranges::copy_if(each, std::back_inserter(to_grow), [&](SownModel* one) {
      return grows(*one) || wears(*one) || one->missing.empty() ||
             std::ranges::any_of(one->missing, [](const auto& of) { return !of.empty(); }) ||
             halvings(*one) != one->summary.halvings();
    });
    Errors errors =
        make_each(watch, "models", to_grow.size(), [&](std::size_t i) { return grow(*to_grow[i]); });
    if (!errors.empty()) return errors;
    return joined();
  }

 private:
  std::string id_of(std::size_t copy_set, int model) const {
    const Organism& organism = scene_.copy_sets[copy_set].organism;
    return copy_id(organism, model, copy_seasons(organism, scene_.film).has_value());
  }

  /// Those that its copies are of.
  static std::set<int> models_of(const CopySet& set) {
    return {set.copies.model.begin(), set.copies.model.end()};
  }

  /// What an earlier run knew of it.
  void look_up(SownModel& one) const {
    Result<std::string> text = read_file(folder_ / one.summary_name);
    std::optional<ModelSummary> summary = text ? read_summary(*text) : std::nullopt;
    if (!summary) return;
    one.summary = std::move(*summary);
    plan(one);
  }

  /// By what the surfels tell of its size.
  void plan(SownModel& one) const {
    std::set<std::string_view> names;
    one.missing.assign(kLevelCount, {});
    for (SownModel::Use& use : one.uses) {
      use.plan = views_.plan(use.copy_set, one.number, one.summary.surfels);
      for (const ModelFile& file : use.plan.files) {
        bool known = one.summary.parts.contains({file.level, file.block}) && path_exists(folder_ / file.name);
        if (!known && names.insert(file.name).second)
          one.missing[static_cast<std::size_t>(file.level)].push_back(file);
      }
    }
  }

  /// How often its surfels have to be halved for the light.
  std::vector<int> halvings(const SownModel& one) const {
    std::vector<int> most(one.summary.surfels.size());
    for (const SownModel::Use& use : one.uses) {
      std::vector<int> wanted = wanted_halvings(scene_, use.copy_set, one.number, one.summary.surfels);
      std::ranges::transform(most, wanted, most.begin(), [](int a, int b) { return std::max(a, b); });
    }
    return most;
  }

  /// Whether the film sees it grow.
  bool grows(const SownModel& one) const {
    return turns(one) || std::ranges::any_of(one.uses, [&](const SownModel::Use& use) {
             return copy_growth(scene_.copy_sets[use.copy_set].organism, scene_.film, one.number).has_value();
           });
  }

  /// Whether the film sees its leaves change.
  bool turns(const SownModel& one) const {
    return copy_seasons(scene_.copy_sets[one.uses[0].copy_set].organism, scene_.film).has_value();
  }

  /// Whether the film sees the look of its copies change.
  bool wears(const SownModel& one) const {
    return std::ranges::any_of(one.uses, [&](const SownModel::Use& use) {
      return copy_condition(scene_.copy_sets[use.copy_set].organism, one.number).has_value();
    });
  }

  /// Keeps what frames have to know of it.
  void keep_worn(SownModel& one, const Model& model, bool living) const {
    const ModelBlocks blocks = blocks_of(one.summary.surfels);
    for (const SownModel::Use& use : one.uses) {
      const CopySet& set = scene_.copy_sets[use.copy_set];
      std::optional<Condition> condition = copy_condition(set.organism, one.number);
      if (!condition) continue;
      lay_turf(*condition, model.solids);
      for (const ModelFile& file : use.plan.files) {
        std::shared_ptr<const WornModel>& kept = one.worn[{use.copy_set, file.level}];
        if (kept) continue;
        auto worn = std::make_shared<WornModel>();
        worn->condition = *condition;
        worn->model.prototypes = model.prototypes;
        for (Prototype& organ : worn->model.prototypes)
          for (OrganPart& part : organ.parts) part.surface = {};
        for (const Solid& solid : model.solids.shapes)
          worn->model.solids.shapes.push_back({.surface = {}, .material = solid.material});
        add_ailing(worn->model, set.appearance.look, condition->courses);
        const Look& look = set.appearance.look;
        worn->parts =
            copy_parts(look, living ? for_level(model, file.level) : model, kLevels[file.level], &blocks);
        kept = std::move(worn);
      }
    }
  }

  Errors grow(SownModel& one) const {
    const CopySet& set = scene_.copy_sets[one.uses[0].copy_set];
    Result<Model> model = grow_copy(set.organism, one.number, turns(one));
    if (!model) return model.errors();
    if (one.missing.empty()) {
      one.summary.surfels = surfels_of(set.appearance.look, *model);
      plan(one);
    }
    if (std::vector<int> wanted = halvings(one); wanted != one.summary.halvings())
      refine(one.summary.surfels, wanted, set.appearance.look, *model);
    if (Errors errors = write_summary(one); !errors.empty()) return errors;
    if (turns(one)) {
      // Its files hold the wood, frames the leaves.
      auto leaves = std::make_shared<Model>();
      leaves->prototypes = model->prototypes;
      leaves->organs = std::exchange(model->organs, {});
      one.grown = std::move(leaves);
    }
    bool living = std::ranges::any_of(model->solids.shapes,
                                      [](const Solid& s) { return is_of_reef(s.material.matter); });
    if (wears(one)) keep_worn(one, *model, living);
    for (const std::vector<ModelFile>& files : one.missing) {
      if (files.empty()) continue;
      Errors errors = write_level(one, files, living ? for_level(*model, files[0].level) : *model);
      if (!errors.empty()) return errors;
    }
    if (one.grown || !grows(one)) return {};
    int finest = kLevelCount - 1;
    for (const SownModel::Use& use : one.uses)
      for (const ModelFile& file : use.plan.files) finest = std::min(finest, file.level);
    one.grown = std::make_shared<const Model>(for_level(std::move(*model), finest));
    return {};
  }

  /// Files first, so that the summary names none that is not there.
  Errors write_level(SownModel& one, const std::vector<ModelFile>& files, const Model& model) const {
    std::vector<ModelText> texts =
        model_texts(files, scene_.copy_sets[one.uses[0].copy_set], model, blocks_of(one.summary.surfels));
    for (std::size_t k = 0; k < files.size(); ++k) {
      if (Errors errors = put(folder_ / files[k].name, texts[k].file_text()); !errors.empty()) return errors;
      one.summary.parts[{files[k].level, files[k].block}] = std::move(texts[k].parts);
    }
    return write_summary(one);
  }

  Errors write_summary(const SownModel& one) const {
    return put(folder_ / one.summary_name, summary_text(one.summary));
  }

  CopyPlan joined() const {
    CopyPlan plan = views_.empty_plan();
    for (std::size_t s = 0; s < scene_.copy_sets.size(); ++s)
      for (int model : models_of(scene_.copy_sets[s])) {
        const SownModel& one = models_.at(id_of(s, model));
        std::size_t first = plan.files.size();
        Views::add(plan, s, std::ranges::find(one.uses, s, &SownModel::Use::copy_set)->plan);
        for (std::size_t f = first; f < plan.files.size(); ++f)
          plan.files[f].parts = one.summary.parts.at({plan.files[f].level, plan.files[f].block});
        for (const auto& [key, worn] : one.worn)
          if (key.first == s) plan.worn[{s, model, key.second}] = worn;
        if (one.grown) plan.growing[{s, model}] = one.grown;
        std::vector<std::vector<Surfel>>& surfels = plan.surfels[s];
        surfels.resize(std::max(surfels.size(), static_cast<std::size_t>(model) + 1));
        surfels[static_cast<std::size_t>(model)] = one.summary.surfels;
        plan.summaries.push_back(one.summary_name);
      }
    return plan;
  }

  const Scene& scene_;
  const fs::path& folder_;
  Views views_;
  std::map<std::string, SownModel> models_;  // by copy_id()
};

}  // namespace

Result<CopyPlan> write_models(const Scene& scene, const fs::path& folder, const ProgressSink& watch) {
  return ModelWriter(scene, folder).write(watch);
}

Errors write_drawings(const Scene& scene, const fs::path& folder, const ProgressSink& watch) {
  std::vector<const Drawing*> to_draw;
  std::set<std::string> names;  // organisms may share a picture
  for (const Drawing& drawing : scene.drawings) {
    auto is_there = [&](const std::string& name) {
      Result<std::string> picture = read_file(folder / name);
      return picture && whole_png(*picture);
    };
    if (!names.insert(drawing.names[0]).second) continue;
    if (!std::ranges::all_of(drawing.names, is_there)) to_draw.push_back(&drawing);
  }
  return make_each(watch, "texture", to_draw.size(), [&](std::size_t i) {
    Result<std::vector<Picture>> drawn = to_draw[i]->draw();
    return drawn ? write_pictures(folder, *drawn) : drawn.errors();
  });
}

Errors write_pictures(const fs::path& folder, const std::vector<Picture>& pictures) {
  for (const Picture& picture : pictures)
    if (Errors errors = put(folder / picture.name, picture.bytes); !errors.empty()) return errors;
  return {};
}

Errors write_light(const Scene& scene, FrameParts& parts, const fs::path& folder) {
  if (!has_soft_light(scene.setup)) return {};
  if (light_changes(scene, parts.pixel)) {
    parts.light = kOwnLight;
    return {};
  }
  Result<std::string> text = soft_light_text(parts.space, scene, parts.plan.surfels, 0, false);
  if (!text) return text.errors();
  if (text->empty()) return {};
  parts.light = "light_" + content_id(*text) + ".rca";
  return put(folder / parts.light, *text);
}

Result<FrameFile> write_frame_file(const Scene& scene, const FrameParts& parts, const std::string& layout,
                                   const fs::path& folder, int frame, int exposure) {
  double time =
      exposure > 0 ? exposure_time(scene.film, scene.setup.camera, frame, exposure) : scene.film.time(frame);
  if (parts.light == kOwnLight && exposure <= 1) {
    Result<std::string> light =
        soft_light_text(parts.space, scene, parts.plan.surfels, scene.film.time(frame), true);
    if (!light) return light.errors();
    if (Errors errors = put(folder / light_name(frame), *light); !errors.empty()) return errors;
  }
  Result<std::vector<Picture>> pictures = setting_pictures(scene, time);
  if (!pictures) return pictures.errors();
  if (Errors errors = write_pictures(folder, *pictures); !errors.empty()) return errors;
  GrowingFile file(folder / (exposure_name(frame, exposure) + ".pov"));
  Result<FrameCount> count = write_frame(
      scene, parts, layout, frame, [&](std::string_view text) { file.add(text); }, exposure);
  if (!count) return count.errors();
  Result<bool> changed = file.close();
  if (!changed) return changed.errors();
  return FrameFile{*changed, count->nodes};
}

}  // namespace frond
