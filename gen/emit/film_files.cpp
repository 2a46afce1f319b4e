#include "emit/film_files.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include "core/content.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/growing_file.h"
#include "core/parallel.h"
#include "emit/setting.h"
#include "emit/soft_light.h"
#include "emit/solid.h"
#include "images/whole.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// The parts that a model's file declares, if it is there.
std::optional<std::vector<int>> parts_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head;
  if (!std::getline(file, head)) return std::nullopt;
  return model_parts(head);
}

std::string crumbs_name(const std::string& id) { return "model_" + id + ".crumbs"; }

/// Those that its copies are of.
std::set<int> models_of(const SownStand& stand) {
  return {stand.copies.model.begin(), stand.copies.model.end()};
}

/// What lives, with no more triangles than show at a level.
Model for_level(Model model, int level) {
  for (Solid& solid : model.solids.shapes)
    if (lives(solid.material)) solid = with_edges(solid, 2 * kLevels[level].grain);
  return model;
}

}  // namespace

Result<CopyPlan> write_models(const Scene& scene, const fs::path& folder, const Watch& watch) {
  /// A model of one stand or, of one species, of several.
  struct Grown {
    struct Use {
      std::size_t stand;
      ModelPlan plan;
    };
    std::vector<Use> uses;
    int model = 0;
    std::string crumbs_name;
    std::vector<Crumb> crumbs;
    std::vector<std::vector<ModelFile>> missing;  // of each level
    std::shared_ptr<const Model> grown;           // where the film sees it grow
  };
  Views views(scene);
  std::map<std::string, Grown> all;
  for (std::size_t s = 0; s < scene.stands.size(); ++s)
    for (int model : models_of(scene.stands[s])) {
      std::string id = copy_id(scene.stands[s].organism, model);
      Grown& one = all[id];
      one.uses.push_back({s, {}});
      one.model = model;
      one.crumbs_name = crumbs_name(id);
    }
  // By what the crumbs tell of its size.
  auto plan = [&](Grown& one) {
    std::set<std::string_view> names;
    one.missing.assign(kLevelCount, {});
    for (Grown::Use& use : one.uses) {
      use.plan = views.plan(use.stand, one.model, one.crumbs);
      for (const ModelFile& file : use.plan.files)
        if (!parts_of(folder / file.name) && names.insert(file.name).second)
          one.missing[static_cast<std::size_t>(file.level)].push_back(file);
    }
  };
  auto grows = [&](const Grown& one) {
    return std::ranges::any_of(one.uses, [&](const Grown::Use& use) {
      return copy_growth(scene.stands[use.stand].organism, scene.film, one.model).has_value();
    });
  };
  std::vector<Grown*> each, to_grow;
  for (auto& [id, one] : all) each.push_back(&one);
  parallel_for(each.size(), [&](std::size_t i) {
    Result<std::string> text = read_file(folder / each[i]->crumbs_name);
    if (!text) return;
    each[i]->crumbs = read_crumbs(*text);
    plan(*each[i]);
  });
  for (Grown* one : each)
    if (grows(*one) || one->missing.empty() ||
        std::ranges::any_of(one->missing, [](const auto& of) { return !of.empty(); }))
      to_grow.push_back(one);
  watch.begin("models", to_grow.size());
  std::vector<Errors> errors(to_grow.size());
  parallel_for(to_grow.size(), [&](std::size_t i) {
    Grown& one = *to_grow[i];
    const SownStand& stand = scene.stands[one.uses[0].stand];
    Result<Model> model = grow_copy(stand.organism, one.model);
    if (!model) {
      errors[i] = model.errors();
      return;
    }
    auto put = [&](const std::string& name, const std::string& text) {
      Result<bool> written = write_file(folder / name, text);
      if (!written) errors[i] = written.errors();
    };
    if (one.missing.empty()) {
      // As they are read again.
      std::string text = crumbs_text(crumbs_of(stand.dress.look, *model));
      put(one.crumbs_name, text);
      one.crumbs = read_crumbs(text);
      plan(one);
    }
    ModelBlocks blocks = blocks_of(one.crumbs);
    for (const std::vector<ModelFile>& files : one.missing) {
      if (files.empty()) continue;
      bool living =
          std::ranges::any_of(model->solids.shapes, [](const Solid& s) { return lives(s.material); });
      std::vector<std::string> texts =
          model_texts(files, stand, living ? for_level(*model, files[0].level) : *model, blocks);
      for (std::size_t k = 0; k < files.size(); ++k) put(files[k].name, texts[k]);
    }
    if (grows(one)) {
      int finest = kLevelCount - 1;
      for (const Grown::Use& use : one.uses)
        for (const ModelFile& file : use.plan.files) finest = std::min(finest, file.level);
      one.grown = std::make_shared<const Model>(for_level(std::move(*model), finest));
    }
    watch.step();
  });
  for (const Errors& list : errors)
    if (!list.empty()) return list;
  CopyPlan joined = views.empty_plan();
  for (std::size_t s = 0; s < scene.stands.size(); ++s)
    for (int model : models_of(scene.stands[s])) {
      Grown& one = all.at(copy_id(scene.stands[s].organism, model));
      auto use = std::ranges::find(one.uses, s, &Grown::Use::stand);
      Views::add(joined, s, use->plan);
      if (one.grown) joined.growing[{s, model}] = one.grown;
      std::vector<std::vector<Crumb>>& crumbs = joined.crumbs[s];
      crumbs.resize(std::max(crumbs.size(), static_cast<std::size_t>(model) + 1));
      crumbs[static_cast<std::size_t>(model)] = one.crumbs;
      joined.crumb_files.push_back(one.crumbs_name);
    }
  for (ModelFile& file : joined.files) file.parts = parts_of(folder / file.name).value_or(std::vector<int>{});
  return joined;
}

Errors write_drawings(const Scene& scene, const fs::path& folder, const Watch& watch) {
  std::vector<const Drawing*> to_draw;
  std::set<std::string> names;  // organisms may share a picture
  for (const Drawing& drawing : scene.drawings) {
    auto is_there = [&](const std::string& name) {
      Result<std::string> picture = read_file(folder / name);
      return picture && whole_png(*picture);
    };
    if (!names.insert(drawing.names[0]).second) continue;
    if (!std::all_of(drawing.names.begin(), drawing.names.end(), is_there)) to_draw.push_back(&drawing);
  }
  watch.begin("texture", to_draw.size());
  std::vector<Errors> errors(to_draw.size());
  parallel_for(to_draw.size(), [&](std::size_t i) {
    Result<std::vector<Picture>> drawn = to_draw[i]->draw();
    if (!drawn) {
      errors[i] = drawn.errors();
      return;
    }
    for (const Picture& picture : *drawn) {
      Result<bool> written = write_file(folder / picture.name, picture.bytes);
      if (!written) errors[i] = written.errors();
    }
    watch.step();
  });
  for (const Errors& list : errors)
    if (!list.empty()) return list;
  return {};
}

Errors write_light(const Scene& scene, FrameParts& parts, const fs::path& folder) {
  if (!ambience_of(scene, 0)) return {};
  if (light_changes(scene)) {
    parts.light = kOwnLight;
    return {};
  }
  Result<std::string> text = soft_light_text(parts.space, scene, parts.plan.crumbs, 0);
  if (!text) return text.errors();
  if (text->empty()) return {};
  parts.light = "light_" + content_id(*text) + ".rca";
  Result<bool> written = write_file(folder / parts.light, *text);
  return written ? Errors{} : written.errors();
}

Result<FrameFile> write_frame_file(const Scene& scene, const FrameParts& parts, const std::string& layout,
                                   const fs::path& folder, int frame, int exposure) {
  double time =
      exposure > 0 ? exposure_time(scene.film, scene.stage.camera, frame, exposure) : scene.film.time(frame);
  if (parts.light == kOwnLight && exposure <= 1) {
    Result<std::string> light =
        soft_light_text(parts.space, scene, parts.plan.crumbs, scene.film.time(frame));
    if (!light) return light.errors();
    if (Result<bool> written = write_file(folder / light_name(frame), *light); !written)
      return written.errors();
  }
  Result<std::vector<Picture>> pictures = setting_pictures(scene, time);
  if (!pictures) return pictures.errors();
  for (const Picture& picture : *pictures)
    if (Result<bool> written = write_file(folder / picture.name, picture.bytes); !written)
      return written.errors();
  GrowingFile file(folder / (exposure_name(frame, exposure) + ".pov"));
  Result<std::size_t> nodes = write_frame(
      scene, parts, layout, frame, [&](std::string_view text) { file.add(text); }, exposure);
  if (!nodes) return nodes.errors();
  Result<bool> changed = file.close();
  if (!changed) return changed.errors();
  return FrameFile{*changed, *nodes};
}

}  // namespace frond
