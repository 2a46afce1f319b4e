#include "farm/farm_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "core/content.h"
#include "core/files.h"
#include "core/home.h"
#include "core/text.h"
#include "pipeline/out_folder.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// What is made in the folder of a farm before it has its name: gone with this, unless it was given one.
class Unnamed {
 public:
  explicit Unnamed(const fs::path& farm) {
    char host[256] = {};
    ::gethostname(host, sizeof host - 1);
    path_ = farm / fmt::format(".new.{}.{}", host, ::getpid());
  }
  ~Unnamed() { remove_tree(path_); }
  Unnamed(const Unnamed&) = delete;
  Unnamed& operator=(const Unnamed&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// A file, and the place of its copy within the folder of a job.
struct Copy {
  fs::path from, to;
};

/// What is to be copied, sorted by its place.
Result<std::vector<Copy>> copies_of(const fs::path& program, const std::vector<fs::path>& files) {
  const fs::path root = home_folder();
  std::vector<Copy> copies{{program, "tool/frond"}};
  for (const char* name : {"scripts/farm_task.sh", "scripts/povray.ini"})
    copies.push_back({root / name, fs::path("tool") / name});
  std::error_code error;
  for (const char* folder : {"povinc", "templates"})
    for (const fs::path& file : files_below(root / folder))
      if (fs::is_regular_file(file, error))
        copies.push_back({file, fs::path("tool") / file.lexically_relative(root)});
  for (const fs::path& file : files)
    copies.push_back({file, "files" / fs::absolute(file, error).lexically_normal().relative_path()});
  std::ranges::sort(copies, {}, [](const Copy& copy) { return copy.to.string(); });
  return copies;
}

Errors make_copies(const fs::path& folder, const std::vector<Copy>& copies, Stop& stop) {
  for (const Copy& copy : copies) {
    std::error_code error;
    fs::create_directories((folder / copy.to).parent_path(), error);
    if (!error) fs::copy_file(copy.from, folder / copy.to, fs::copy_options::overwrite_existing, error);
    if (error)
      return {error_at("", "{} could not be written: {}: {}", folder.parent_path().string(),
                       copy.from.string(), reason_of(error))};
    if (stop.asked()) return {{"", "interrupted before anything was handed out"}};
  }
  return {};
}

/// The folders that a job has, those where tasks look for files among them.
Errors make_folders(const fs::path& folder, const FarmCall& call) {
  std::error_code error;
  for (const char* name : {"frames", "raw", "models", "log", "failed"})
    if (!error) fs::create_directories(folder / name, error);
  for (const fs::path& path : {call.folder, call.assets})
    if (!error) fs::create_directories(folder / "files" / path.relative_path(), error);
  if (error) return {{"", folder.parent_path().string() + ": cannot be written to"}};
  return {};
}

/// Says what is copied and what was asked for, and not from where the call was made.
Result<std::string> hash_of(const fs::path& folder, const std::vector<Copy>& copies, FarmCall call) {
  call.folder.clear();
  std::string all = call.text();
  for (const Copy& copy : copies) {
    Result<std::string> bytes = read_file(folder / copy.to);
    if (!bytes) return bytes.errors();
    all += copy.to.string() + '\0' + content_id(*bytes) + '\0';
  }
  return content_id(all);
}

Errors links_in(const fs::path& job) {
  std::vector<fs::path> paths{job};
  for (const fs::path& folder : {job, job / "failed", job / "log"})
    for (const fs::path& path : files_in(folder)) paths.push_back(path);
  for (const fs::path& path : paths)
    if (Errors link = refuse_link(path); !link.empty()) return link;
  return {};
}

/// Has FARM/latest lead to a folder there.
Errors lead_to(const fs::path& farm, const std::string& name) {
  fs::path temporary = temporary_beside(farm / "latest");
  std::error_code error;
  fs::create_directory_symlink(name, temporary, error);
  if (!error) fs::rename(temporary, farm / "latest", error);
  if (!error) return {};
  remove_file(temporary);
  return {error_at("", "{} could not be written: {}", (farm / "latest").string(), reason_of(error))};
}

}  // namespace

std::string FarmCall::text() const {
  std::string text;
  for (const fs::path& path : {folder, preset, assets}) text += path.string() + '\0';
  for (const std::string& option : options) text += option + '\0';
  return text;
}

Result<FarmCall> read_farm_call(const fs::path& job) {
  constexpr std::size_t kPaths = 3;
  Result<std::string> text = read_file(job / "call");
  if (!text) return text.errors();
  std::vector<std::string> words = split(*text, '\0');
  if (words.size() < kPaths) return Error{"", (job / "call").string() + ": is damaged"};
  return FarmCall{words[0], words[1], words[2], {words.begin() + kPaths, words.end()}};
}

Command generate_command(const fs::path& job, const FarmCall& call, const fs::path& out,
                         const std::vector<std::string>& options) {
  auto copy_of = [&](const fs::path& path) { return (job / "files" / path.relative_path()).string(); };
  Command command;
  command.words = {(job / "tool" / "frond").string(), "generate", copy_of(call.preset),
                   "--out=" + out.string(), "-q"};
  if (!call.assets.empty()) command.words.push_back("--assets=" + copy_of(call.assets));
  command.add(call.options);
  command.add(options);
  command.environment = {"FROND_HOME=" + (job / "tool").string()};
  command.folder = copy_of(call.folder);
  command.end_with = SIGTERM;
  return command;
}

Result<fs::path> make_farm_folder(const fs::path& farm, const FarmCall& call, const fs::path& program,
                                  const std::vector<fs::path>& files, Stop& stop) {
  if (Errors link = refuse_link(farm); !link.empty()) return link;
  std::error_code error;
  fs::create_directories(farm, error);
  if (error) return Error{"", farm.string() + ": the folder cannot be made"};
  Result<std::vector<Copy>> copies = copies_of(program, files);
  if (!copies) return copies.errors();
  Unnamed made(farm);
  if (Errors errors = make_folders(made.path(), call); !errors.empty()) return errors;
  if (Errors errors = make_copies(made.path(), *copies, stop); !errors.empty()) return errors;
  Result<bool> noted = write_file(made.path() / "call", call.text());
  if (!noted) return noted.errors();
  Result<std::string> name = hash_of(made.path(), *copies, call);
  if (!name) return name.errors();
  fs::path job = farm / *name;
  if (Errors links = links_in(job); !links.empty()) return links;
  if (!fs::is_directory(job, error)) fs::rename(made.path(), job, error);
  if (!fs::is_directory(job, error)) return Error{"", farm.string() + ": cannot be written to"};
  if (Errors errors = lead_to(farm, *name); !errors.empty()) return errors;
  return job;
}

}  // namespace frond
