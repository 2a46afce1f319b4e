#include "app/inputs.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <string_view>

#include "core/files.h"
#include "geometry/obj.h"
#include "preset/json.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Reads a positive whole number off the front of a text; 0 where there is none.
int read_number(std::string_view& text) {
  int number = 0;
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || number < 0) return 0;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

/// Reads an OBJ file as seen from the preset's folder or, where it is not there, from the working folder.
Result<Surface> load_mesh(const std::string& file, const fs::path& preset_path) {
  std::error_code error;
  fs::path path = preset_path.parent_path() / file;
  if (!fs::exists(path, error) && fs::exists(file, error)) path = file;
  Result<std::string> text = read_file(path);
  Result<Surface> mesh = text ? read_obj(*text) : text.errors();
  if (!mesh) return Error{path.string(), mesh.errors().front().what};
  return to_unit(std::move(*mesh));
}

/// Reads the OBJ files that the preset names.
Errors load_files(Preset& preset, const fs::path& preset_path) {
  Errors errors;
  auto load = [&](const std::string& file, const std::string& pointer, Surface& mesh) {
    Result<Surface> loaded = load_mesh(file, preset_path);
    if (loaded) {
      mesh = std::move(*loaded);
      return;
    }
    const Error& error = loaded.errors().front();
    errors.push_back({fmt::format("{}: {}", preset_path.string(), pointer),
                      fmt::format("{} {}", error.where, error.what)});
  };
  for (std::size_t i = 0; i < preset.organisms.size(); ++i) {
    if (auto* body = std::get_if<MeshParams>(&preset.organisms[i].body))
      load(body->file, fmt::format("/organisms/{}/file", i), body->mesh);
    auto* plant = std::get_if<PlantParams>(&preset.organisms[i].body);
    auto* coral = std::get_if<CoralParams>(&preset.organisms[i].body);
    if (GrammarText* grammar = plant ? &plant->grammar : coral ? &coral->grammar : nullptr)
      for (Error& error : load_guide(grammar->guide, preset_path, fmt::format("/organisms/{}/grammar", i)))
        errors.push_back(std::move(error));
    for (std::size_t k = 0; plant && k < plant->organs.size(); ++k)
      if (OrganParams& organ = plant->organs[k]; organ.shape == OrganShape::obj)
        load(organ.file, fmt::format("/organisms/{}/organs/{}/file", i, k), organ.mesh);
  }
  return errors;
}

}  // namespace

Result<fs::path> home() {
  const char* given = std::getenv("FROND_HOME");
  std::error_code error;
  fs::path path =
      given ? fs::path(given) : fs::read_symlink("/proc/self/exe", error).parent_path().parent_path();
  if (fs::exists(path / "templates" / "frame.pov", error)) return path;
  return Error{path.string(), "holds no templates/frame.pov; set FROND_HOME to the folder of Frond"};
}

Errors load_guide(GuideText& guide, const fs::path& file, const std::string& pointer) {
  if (guide.file.empty()) return {};
  fs::path path = file.parent_path() / guide.file;
  Result<std::string> text = read_file(path);
  Result<LineSet> lines = text ? read_obj_lines(*text) : text.errors();
  if (!lines)
    return {{fmt::format("{}: {}/guide/file", file.string(), pointer),
             fmt::format("{} {}", path.string(), lines.errors().front().what)}};
  guide.lines = {std::move(lines->place), std::move(lines->line)};
  return {};
}

Result<Preset> load_preset(const PresetArguments& arguments) {
  Result<std::string> text = read_file(arguments.path);
  if (!text) return text.errors();
  std::vector<std::string> sets = arguments.sets;
  if (arguments.size) {
    std::string_view rest = *arguments.size;
    int width = read_number(rest);
    bool cross = !rest.empty() && rest.front() == 'x';
    if (cross) rest.remove_prefix(1);
    int height = read_number(rest);
    if (!cross || width == 0 || height == 0 || !rest.empty())
      return Error{"--size",
                   fmt::format("\"{}\" is no size; expected WIDTHxHEIGHT, as in 640x360", *arguments.size)};
    sets.push_back(fmt::format("/film/size=[{},{}]", width, height));
  }
  if (arguments.quality) sets.push_back("/film/quality=" + *arguments.quality);
  Result<Preset> preset = read_preset(*text, arguments.path, sets);
  if (!preset) return preset;
  if (Errors errors = load_files(*preset, arguments.path); !errors.empty()) return errors;
  return preset;
}

bool is_grammar(const std::string& path) {
  if (!path.ends_with(".json")) return true;
  Result<std::string> text = read_file(path);
  Result<Document> document = text ? parse_json(*text, path) : text.errors();
  return document && document->root.find("axiom") && !document->root.find("organisms");
}

Result<FrameRange> read_frames(const std::string& text, int count) {
  std::string_view rest = text;
  FrameRange range{};
  range.first = range.last = read_number(rest);
  if (!rest.empty() && rest.front() == '-') {
    rest.remove_prefix(1);
    range.last = read_number(rest);
  }
  if (!rest.empty() || range.first < 1 || range.last < range.first || range.last > count)
    return Error{"--frames",
                 fmt::format("\"{}\" is no range of frames; expected A-B within 1-{}", text, count)};
  return range;
}

int fail(const Errors& errors, ExitCode code) {
  for (const Error& error : errors) fmt::print(stderr, "{}\n", error.text());
  return code;
}

}  // namespace frond
