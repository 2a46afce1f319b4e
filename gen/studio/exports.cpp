#include "studio/exports.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "core/files.h"
#include "core/text.h"
#include "core/work_folder.h"
#include "export/formats.h"
#include "render/process.h"
#include "studio/answers.h"
#include "studio/carry.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr int kMostExports = 1000;

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

Result<fs::path> export_doc(const Documents& documents, const fs::path& home, const Doc& doc, double time,
                            const std::string& type) {
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
  int frame = frame_at(preset->film, time);
  int told = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  Command command;
  command.words = {own_program().string(), "export", copy.string(), "--out", path->string(), "--quiet"};
  if (type != ".inc") command.words.insert(command.words.end(), {"--frame", std::to_string(frame)});
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
