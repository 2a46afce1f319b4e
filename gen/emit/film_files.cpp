#include "emit/film_files.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include "core/content.h"
#include "core/files.h"
#include "core/growing_file.h"
#include "core/parallel.h"
#include "emit/setting.h"
#include "emit/soft_light.h"
#include "images/whole.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// How many parts a model's file declares, if it is there.
std::optional<int> parts_of(const fs::path& path) {
  char head[64] = {};
  std::ifstream(path, std::ios::binary).read(head, sizeof head - 1);
  return model_parts(head);
}

std::string crumbs_name(const std::string& id) { return "model_" + id + ".crumbs"; }

/// Those that its copies are of.
std::set<int> models_of(const SownStand& stand) {
  return {stand.copies.model.begin(), stand.copies.model.end()};
}

}  // namespace

Errors write_models(const Scene& scene, CopyPlan& plan, const fs::path& folder, const Watch& watch) {
  // Stands of one species may share a model, which is grown and written once.
  struct Missing {
    const SownStand* stand = nullptr;
    int model = 0;
    std::string crumbs;  // name of their file
    std::vector<const ModelFile*> files;
  };
  std::map<std::string, Missing> missing;
  std::set<std::string_view> names;
  auto lacks = [&](const SownStand& stand, int model, const ModelFile* file) {
    std::string id = copy_id(stand.organism, model);
    Missing& one = missing[id];
    one.stand = &stand;
    one.model = model;
    one.crumbs = crumbs_name(id);
    if (file) one.files.push_back(file);
  };
  for (const ModelFile& file : plan.files)
    if (!parts_of(folder / file.name) && names.insert(file.name).second)
      lacks(scene.stands[file.stand], file.model, &file);
  bool lit = ambience_of(scene, 0).has_value();
  auto each_model = [&](const auto& visit) {
    for (std::size_t s = 0; lit && s < scene.stands.size(); ++s)
      for (int model : models_of(scene.stands[s])) visit(s, model);
  };
  each_model([&](std::size_t s, int model) {
    const SownStand& stand = scene.stands[s];
    std::error_code error;
    if (!fs::exists(folder / crumbs_name(copy_id(stand.organism, model)), error))
      lacks(stand, model, nullptr);
  });
  std::vector<const Missing*> to_grow;
  for (const auto& [id, one] : missing) to_grow.push_back(&one);
  watch.begin("models", to_grow.size());
  std::vector<Errors> errors(to_grow.size());
  parallel_for(to_grow.size(), [&](std::size_t i) {
    const Missing& one = *to_grow[i];
    Result<Model> model = grow_copy(one.stand->organism, one.model);
    if (!model) {
      errors[i] = model.errors();
      return;
    }
    auto put = [&](const std::string& name, const std::string& text) {
      Result<bool> written = write_file(folder / name, text);
      if (!written) errors[i] = written.errors();
    };
    if (lit) put(one.crumbs, crumbs_text(crumbs_of(one.stand->dress.look, *model)));
    for (const ModelFile* file : one.files) put(file->name, model_text(*file, *one.stand, *model));
    watch.step();
  });
  for (const Errors& list : errors)
    if (!list.empty()) return list;
  for (ModelFile& file : plan.files) file.parts = parts_of(folder / file.name).value_or(0);
  plan.crumbs.resize(scene.stands.size());
  Errors unread;
  each_model([&](std::size_t s, int model) {
    Result<std::string> text = read_file(folder / crumbs_name(copy_id(scene.stands[s].organism, model)));
    plan.crumb_files.push_back(crumbs_name(copy_id(scene.stands[s].organism, model)));
    if (!text) return unread.insert(unread.end(), text.errors().begin(), text.errors().end()), void();
    auto which = static_cast<std::size_t>(model);
    plan.crumbs[s].resize(std::max(plan.crumbs[s].size(), which + 1));
    plan.crumbs[s][which] = read_crumbs(*text);
  });
  return unread;
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
                                   const fs::path& path, int frame) {
  if (parts.light == kOwnLight) {
    Result<std::string> light =
        soft_light_text(parts.space, scene, parts.plan.crumbs, scene.film.time(frame));
    if (!light) return light.errors();
    fs::path beside = path;
    if (Result<bool> written = write_file(beside.replace_extension(".rca"), *light); !written)
      return written.errors();
  }
  Result<std::vector<Picture>> pictures = setting_pictures(scene, scene.film.time(frame));
  if (!pictures) return pictures.errors();
  for (const Picture& picture : *pictures)
    if (Result<bool> written = write_file(path.parent_path() / picture.name, picture.bytes); !written)
      return written.errors();
  GrowingFile file(path);
  Result<std::size_t> nodes =
      write_frame(scene, parts, layout, frame, [&](std::string_view text) { file.add(text); });
  if (!nodes) return nodes.errors();
  Result<bool> changed = file.close();
  if (!changed) return changed.errors();
  return FrameFile{*changed, *nodes};
}

}  // namespace frond
