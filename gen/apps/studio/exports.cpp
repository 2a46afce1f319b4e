#include "studio/exports.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "core/files.h"
#include "core/printable.h"
#include "core/text.h"
#include "core/work_folder.h"
#include "export/export_scene.h"
#include "export/formats.h"
#include "render/process.h"
#include "scene/named_files.h"
#include "studio/answers.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr int kMostExports = 1000;
constexpr int kKeys = 12;  // shapes of an animation, as `frond export` has it

bool known(const std::string& type) {
  return type == ".inc" ||
         std::ranges::any_of(formats(), [&](const Format& f) { return f.extension == type; });
}

/// A file of that name and type that is not there yet.
Result<fs::path> free_path(const Documents& documents, const std::string& name, const std::string& type) {
  std::error_code error;
  fs::path folder = documents.folder() / "out/exports";
  if (fs::create_directories(folder, error); access(folder.c_str(), W_OK) != 0)
    fs::create_directories(folder = fs::temp_directory_path() / "frond-exports", error);
  for (int number = 1; number <= kMostExports; ++number)
    if (fs::path path = folder / fmt::format("{}-{}{}", name, number, type); !fs::exists(path, error))
      return path;
  return Error{folder.string(), "there are too many exports"};
}

}  // namespace

ExportOrder export_order(const Json& question) {
  ExportOrder order;
  order.type = question.value("type", order.type);
  order.time = question.value("time", order.time);
  order.detail = std::clamp(question.value("detail", order.detail), 100.0, 1e8);
  order.levels = static_cast<int>(std::clamp(question.value("levels", 1.0), 1.0, 6.0));
  order.wind = question.value("wind", false) && order.type == ".glb";
  if (order.wind || order.type != ".glb") order.levels = 1;
  return order;
}

Json export_size(const Scene& scene, const ExportOrder& order) {
  constexpr double kVertexBytes = 36, kTriangleBytes = 12;  // place, normal, picture and tint; three numbers
  constexpr double kShiftBytes = 24;
  ExportOptions options;
  options.detail = order.detail;
  double first = estimate_export(scene, options).triangles;
  options.levels = order.levels;
  if (order.wind) options.keys.resize(kKeys);
  ExportSize size = estimate_export(scene, options);
  Json triangles = Json::array();
  for (int level = 0; level < order.levels; ++level) triangles.push_back(first * std::pow(kCoarser, level));
  std::size_t sown = 0;
  for (const CopySet& set : scene.copy_sets) sown += set.copies.size();
  double bytes = kVertexBytes * size.vertices + kTriangleBytes * size.triangles + kShiftBytes * size.shifts +
                 size.pictures;
  return {{"triangles", triangles}, {"vertices", size.vertices}, {"bytes", bytes}, {"sown", sown}};
}

Answer export_size(const Documents& documents, Scenes& scenes, const Doc& doc, const ExportOrder& order) {
  Result<Preset> preset = documents.preset(doc);
  if (!preset) return wrong(preset.errors());
  Result<std::shared_ptr<const Scene>> scene = scenes.scene(doc, std::move(*preset), [] { return false; });
  if (!scene) return wrong(scene.errors());
  return {200, export_size(**scene, order)};
}

Result<fs::path> export_doc(const Documents& documents, const fs::path& home, const Doc& doc,
                            const ExportOrder& order) {
  const std::string& type = order.type;
  if (!known(type)) return Error{"", fmt::format("\"{}\" is no format of exports", type)};
  Result<Preset> preset = documents.preset(doc);
  if (!preset) return preset.errors();
  Result<std::string> text = with_whole_paths(doc.text, doc.file.parent_path());
  if (!text) return text.errors();
  std::string name = plain_name(doc.file.stem().string(), "scene");
  Result<fs::path> path = free_path(documents, name, type);
  if (!path) return path;
  WorkFolder work;
  fs::path copy = work.path() / (name + ".json"), log = work.path() / "log";
  if (Result<bool> written = write_file(copy, *text); !written) return written.errors();
  int frame = frame_at(preset->film, order.time);
  int told = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  Command command;
  command.words = {own_program().string(), "export", copy.string(), "--out", path->string(), "--quiet"};
  if (type != ".inc" && type != ".vdb") command.add({"--detail", fmt::format("{:.0f}", order.detail)});
  if (order.levels > 1) command.add({"--lods", std::to_string(order.levels)});
  if (bool moves = order.wind && preset->film.frames > 1; moves)
    command.add({"--frames", fmt::format("1-{}", preset->film.frames)});
  else if (type != ".inc")
    command.add({"--frame", std::to_string(frame)});
  command.environment = {"FROND_HOME=" + fs::absolute(home).string()};
  command.out = command.err = told;
  command.apart = true;
  Result<int> code = frond::run(command);
  if (told >= 0) ::close(told);
  if (!code) return code.errors();
  if (*code == 0) return path;
  Result<std::string> said = read_file(log);
  return Error{"", said && !said->empty() ? *said : fmt::format("the export ended with {}", *code)};
}

}  // namespace frond
