#include "studio/documents.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/content.h"
#include "core/files.h"
#include "core/read_as.h"
#include "preset/json.h"
#include "scene/named_files.h"
#include "studio/grammar_files.h"
#include "studio/mesh_files.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargestFile = 8 << 20;  // bytes of a preset's file
constexpr const char* kSaveFirst =
    "save the preset under a name of your own first: what is written lies beside it, where one that is "
    "shipped does not look";

std::optional<fs::path> without_links(const fs::path& path) {
  // The system takes a name to end at a NUL: what is judged would not be what is opened.
  if (path.native().find('\0') != std::string::npos) return std::nullopt;
  std::error_code error;
  fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
  if (error) return std::nullopt;
  return real;
}

bool lies_below(const fs::path& path, const fs::path& folder) {
  return std::ranges::mismatch(folder, path).in1 == folder.end();
}

/// What follows the last colon of a text, as a number; 0 where that is none. The text loses it.
int split_number(std::string& text) {
  std::size_t colon = text.rfind(':');
  if (colon == text.npos) return 0;
  std::optional<int> number = read_as<int>(std::string_view(text).substr(colon + 1));
  if (number) text.resize(colon);
  return number.value_or(0);
}

/// The picture in the gallery that shows a preset, by its path below presets/.
std::optional<std::string> picture_of(const fs::path& gallery, const fs::path& preset) {
  std::string stem = preset.stem().string(), folder = preset.parent_path().filename().string();
  std::string one = folder.ends_with('s') ? folder.substr(0, folder.size() - 1) : folder;
  std::string part = stem;  // "reef_dusk" is one of the reef
  if (std::size_t at = part.find('_'); at != part.npos) part[at] = '-';
  for (const std::string& name : {folder + '-' + stem, one + '-' + stem, stem, part})
    if (path_exists(gallery / (name + ".jpg"))) return name + ".jpg";
  return std::nullopt;
}

/// Files of presets in a folder and those in it, `deep` of them down; not in hidden ones, nor those that are
/// links, and no more than `most` are looked at.
void find_presets(const fs::path& folder, int deep, int& most, std::vector<fs::path>& found) {
  std::error_code error;
  for (const fs::path& path : files_in(folder)) {
    if (--most < 0) return;
    if (path.filename().string().starts_with('.') || fs::is_symlink(path, error)) continue;
    if (path.extension() == ".json" && fs::is_regular_file(path, error) &&
        fs::file_size(path, error) <= kLargestFile)
      found.push_back(path);
    else if (deep > 0 && path.filename() != "node_modules" && fs::is_directory(path, error))
      find_presets(path, deep - 1, most, found);
  }
}

/// A title each; none where a file is no preset.
std::optional<std::string> title_of(const fs::path& file) {
  Result<std::string> text = read_file(file);
  Result<Document> document = text ? parse_json(*text, file.string()) : text.errors();
  if (!document || !(document->root.find("organisms") || document->root.find("base")))
    return std::nullopt;  // a grammar
  const Value* title = document->root.find("title");
  return title && title->is(Value::Type::text) ? title->text : file.stem().string();
}

/// The text of a preset that moves from one folder to another, with the files that it names: they are copied
/// beside it, under a name of their own where theirs is taken, and the text names them there. Nothing else of
/// the text changes. Only what `readable` allows is copied.
Result<std::string> moved_text(const std::string& text, const fs::path& from, const fs::path& to,
                               const std::function<bool(const fs::path&)>& readable) {
  return renamed(text, from, [&](const fs::path& file) -> Result<std::string> {
    if (!readable(file)) return std::string();
    auto put = [&]() -> Result<PutFiles> {
      if (file.extension() == ".l") return put_grammar(to, file);
      if (is_mesh_name(file)) return copy_mesh(to, file);
      Result<std::string> content = read_file(file);
      if (!content) return content.errors();
      return put_beside(to, file.filename().string(), *content);
    }();
    if (!put) return put.errors();
    return put->name;
  });
}

/// A preset as the page knows it.
Json read_json(const fs::path& file, const std::string& text) {
  return {{"file", file.string()},
          {"name", file.filename().string()},
          {"text", text},
          {"disk", content_id(text)}};
}

}  // namespace

Documents::Documents(const StudioOptions& options)
    : presets_(*without_links(options.home / "presets")), docs_(*without_links(options.home / "docs")) {
  if (options.preset) preset_ = without_links(*options.preset);
  folder_ = preset_ ? preset_->parent_path() : *without_links(".");
  if (options.assets) assets_ = without_links(*options.assets);
  made_ = std::make_shared<MadeFiles>(folder_);
}

Json Documents::opened() const {
  if (!preset_) return nullptr;
  Result<Json> read_in = read(preset_->string());
  return read_in ? *read_in : Json(nullptr);
}

Json Documents::shipped() const {
  Json list = Json::array();
  for (const fs::path& file : files_below(presets_)) {
    if (file.extension() != ".json") continue;
    std::optional<std::string> title = title_of(file);
    if (!title) continue;
    std::optional<std::string> picture = picture_of(docs_ / "gallery", file.lexically_relative(presets_));
    list.push_back({{"file", file.string()},
                    {"name", file.lexically_relative(presets_).replace_extension().string()},
                    {"title", *title},
                    {"picture", picture ? Json(*picture) : Json(nullptr)}});
  }
  return list;
}

Json Documents::own() const {
  constexpr int kMost = 20'000, kDeep = 2;  // files and folders; folders in folders
  constexpr std::size_t kShown = 200;
  std::vector<fs::path> files;
  int most = kMost;
  find_presets(folder_, kDeep, most, files);
  if (assets_ && !lies_below(*assets_, folder_)) find_presets(*assets_, kDeep, most, files);
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  for (const fs::path& file : files) {
    std::error_code error;
    if (!lies_below(file, presets_)) found.emplace_back(fs::last_write_time(file, error), file);
  }
  std::ranges::sort(found, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  Json list = Json::array();
  for (const auto& [when, file] : found) {
    if (list.size() >= kShown) break;
    std::optional<std::string> title = title_of(file);
    if (!title) continue;
    bool near = lies_below(file, folder_);
    list.push_back({{"file", file.string()},
                    {"name", near ? file.lexically_relative(folder_).string() : file.string()},
                    {"title", *title},
                    {"picture", nullptr}});
  }
  return list;
}

std::string Documents::disk(const std::string& file) const {
  std::optional<fs::path> path = readable(file);
  Result<std::string> text = path ? read_file(*path) : Error{file, ""};
  return text ? content_id(*text) : "";
}

std::optional<fs::path> Documents::readable(const std::string& file) const {
  std::optional<fs::path> path = without_links(file);
  if (!path) return std::nullopt;
  bool fine =
      lies_below(*path, folder_) || lies_below(*path, presets_) || (assets_ && lies_below(*path, *assets_));
  return fine ? path : std::nullopt;
}

Result<Json> Documents::read(const std::string& file) const {
  std::optional<fs::path> path = readable(file);
  if (!path) return Error{file, "is in no folder that the studio may read"};
  Result<std::string> text = read_file(*path);
  if (!text) return text.errors();
  bool own = path == preset_ || (lies_below(*path, folder_) && !lies_below(*path, presets_));
  Json json = read_json(*path, *text);
  json["copy"] = !own;
  return json;
}

Result<std::string> Documents::leaf(const std::string& shelf, const std::string& name) const {
  bool is_page = shelf == "docs";
  fs::path folder = is_page ? docs_ : docs_ / (shelf == "strip" ? "kinds/pictures" : "gallery");
  std::optional<fs::path> path = without_links(folder / name);
  if (!path || !lies_below(*path, folder) || path->extension() != (is_page ? ".md" : ".jpg"))
    return Error{name, "is not there"};
  return read_file(*path);
}

Json Documents::strips() const {
  Json names = Json::array();
  for (const fs::path& file : files_in(docs_ / "kinds/pictures"))
    if (file.extension() == ".jpg") names.push_back(file.stem().string());
  return names;
}

Result<Preset> Documents::preset(const Doc& doc, const std::vector<std::string>& sets) const {
  made_->restore(doc.text);
  // What Frond brings is one folder; of all else only the preset's own and --assets are read.
  fs::path only = assets_.value_or(doc.file.parent_path());
  if (lies_below(doc.file, presets_)) only = lies_below(presets_, folder_) ? folder_ : presets_;
  return read_preset(doc.text, doc.file.string(), sets, only);
}

std::optional<fs::path> Documents::writable(const std::string& file) const {
  std::optional<fs::path> path = without_links(folder_ / file);  // an absolute one stays as it is
  // A link, too, may lead only to what a preset may be.
  if (!path || !file.ends_with(".json") || path->extension() != ".json") return std::nullopt;
  return lies_below(*path, folder_) || (assets_ && lies_below(*path, *assets_)) ? path : std::nullopt;
}

Answer Documents::save(const std::string& file, const Doc& doc, const std::string& disk,
                       bool overwrite) const {
  const auto& [text, from] = doc;
  std::optional<fs::path> path = writable(file);
  if (!path)
    return refused(
        403, fmt::format("\"{}\" cannot be written: expected a name that ends with .json, below {}", file,
                         folder_.string()));
  // Between the look at what is there and the writing nobody else saves, another studio neither.
  FolderLock lock(path->parent_path());
  if (path_exists(*path) && !overwrite) {
    Result<std::string> there = read_file(*path);
    std::string id = there ? content_id(*there) : "";
    if (disk.empty() || id != disk)
      return {409, {{"error", disk.empty() ? "exists" : "changed on disk"}, {"disk", id}}};
  }
  Result<std::string> moved =
      from.parent_path() == path->parent_path()
          ? Result<std::string>(text)
          : moved_text(text, from.parent_path(), path->parent_path(),
                       [&](const fs::path& named) { return readable(named.string()).has_value(); });
  Result<bool> written = moved ? write_file(*path, *moved) : moved.errors();
  if (!written) return refused(500, written.errors().front().text());
  made_->saved(from, *moved);
  return {200, read_json(*path, *moved)};
}

bool Documents::reaches(const fs::path& of) const {
  std::optional<fs::path> real = without_links(of);
  return !real || of.empty() || !lies_below(*real, presets_) || lies_below(presets_, folder_);
}

Answer Documents::add_file(const std::string& name, const char* type, const std::string& content,
                           const std::string& of) const {
  return add(of, 500, [&] { return put_beside(folder_, fs::path(name).stem().string() + type, content); });
}

Answer Documents::add_mesh(const std::string& name, const std::string& content,
                           const std::map<std::string, std::string>& beside, const std::string& of) const {
  return add(of, 400, [&] { return put_mesh(folder_, name, content, beside); });
}

Answer Documents::add_grammar(const fs::path& grammar, const std::map<std::string, std::string>& texts,
                              const std::string& of) const {
  return add(of, 500, [&] { return put_grammar(folder_, grammar, texts); });
}

Answer Documents::add(const std::string& of, int fault, const std::function<Result<PutFiles>()>& put) const {
  if (!reaches(of)) return refused(409, kSaveFirst);
  FolderLock lock(folder_);
  Result<PutFiles> own = put();
  if (!own) return refused(fault, own.errors().front().text());
  // Files that name each other are known by their folder.
  made_->add(own->name.substr(0, own->name.find('/')), of, own->fresh);
  return {200, {{"file", own->name}, {"path", (folder_ / own->name).string()}}};
}

Answer refused(int status, std::string_view why) { return {status, {{"error", why}}}; }

Json errors_json(const Errors& errors) {
  Json list = Json::array();
  for (const Error& error : errors) {
    // "file:line:column: /pointer", of which some may be missing.
    std::string where = error.where, pointer;
    if (std::size_t at = where.find(": /"); at != where.npos) {
      pointer = where.substr(at + 2);
      if (std::size_t end = pointer.find(": "); end != pointer.npos) pointer.resize(end);
      where.resize(at);
    } else if (where.starts_with('/')) {
      std::swap(where, pointer);
    }
    int column = split_number(where), line = split_number(where);
    if (line == 0) std::swap(line, column);
    list.push_back({{"text", error.what},
                    {"where", error.where},
                    {"line", line},
                    {"column", column},
                    {"pointer", pointer}});
  }
  return list;
}

}  // namespace frond
