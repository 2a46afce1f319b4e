#include "emit/film_files.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include "core/files.h"
#include "core/growing_file.h"
#include "core/parallel.h"
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

}  // namespace

Errors write_models(const Scene& scene, CopyPlan& plan, const fs::path& folder, const Watch& watch) {
  // Stands of one species may share a model, which is grown and written once.
  std::map<std::string, std::vector<const ModelFile*>> missing;
  std::set<std::string_view> names;
  for (const ModelFile& file : plan.files)
    if (!parts_of(folder / file.name) && names.insert(file.name).second)
      missing[copy_id(scene.stands[file.stand].organism, file.model)].push_back(&file);
  std::vector<std::vector<const ModelFile*>> to_grow;
  for (auto& [key, files] : missing) to_grow.push_back(std::move(files));
  watch.begin("models", to_grow.size());
  std::vector<Errors> errors(to_grow.size());
  parallel_for(to_grow.size(), [&](std::size_t i) {
    const SownStand& stand = scene.stands[to_grow[i][0]->stand];
    Result<Model> model = grow_copy(stand.organism, to_grow[i][0]->model);
    if (!model) {
      errors[i] = model.errors();
      return;
    }
    for (const ModelFile* file : to_grow[i]) {
      Result<bool> written = write_file(folder / file->name, model_text(*file, stand, *model));
      if (!written) errors[i] = written.errors();
    }
    watch.step();
  });
  for (const Errors& list : errors)
    if (!list.empty()) return list;
  for (ModelFile& file : plan.files) file.parts = parts_of(folder / file.name).value_or(0);
  return {};
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

Result<FrameFile> write_frame_file(const Scene& scene, const FrameParts& parts, const std::string& layout,
                                   const fs::path& path, int frame) {
  GrowingFile file(path);
  Result<std::size_t> nodes =
      write_frame(scene, parts, layout, frame, [&](std::string_view text) { file.add(text); });
  if (!nodes) return nodes.errors();
  Result<bool> changed = file.close();
  if (!changed) return changed.errors();
  return FrameFile{*changed, *nodes};
}

}  // namespace frond
