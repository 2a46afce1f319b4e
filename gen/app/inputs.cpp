#include "app/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "app/streams.h"
#include "core/files.h"
#include "crown/arbaro.h"
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

/// A file as seen from the preset's folder or, where it is not there, from the working folder.
fs::path seen_from(const fs::path& preset_path, const std::string& file) {
  std::error_code error;
  fs::path path = preset_path.parent_path() / file;
  return !fs::exists(path, error) && fs::exists(file, error) ? fs::path(file) : path;
}

Result<Surface> load_mesh(const std::string& file, const fs::path& preset_path) {
  fs::path path = seen_from(preset_path, file);
  Result<std::string> text = read_file(path);
  Result<Surface> mesh = text ? read_obj(*text) : text.errors();
  if (!mesh) return Error{path.string(), mesh.errors().front().what};
  return to_unit(std::move(*mesh));
}

Result<Silhouette> load_outline(const fs::path& path) {
  Result<std::string> text = read_file(path);
  if (!text) return text.errors();
  if (path.extension() == ".svg") {
    Result<std::vector<std::vector<Vec2>>> drawn = read_svg(*text);
    if (!drawn) return Error{path.string(), drawn.errors().front().what};
    for (auto& outline : *drawn)
      for (Vec2& p : outline) p.y = -p.y;  // SVG's y runs down
    return Silhouette::from_outlines(std::move(*drawn));
  }
  Result<Raster> picture = read_png(*text);
  if (!picture)
    return Error{path.string(), picture.errors().front().what + "; expected an SVG or a PNG file"};
  return Silhouette::from_picture(*picture);
}

/// Reads what a tree names: a species of Arbaro, the mesh or the silhouette of an envelope.
template <class LoadMesh>
void load_tree(Organism& organism, std::size_t i, const fs::path& preset_path, Errors& errors,
               const LoadMesh& load) {
  auto note = [&](std::string_view pointer, const Errors& found) {
    for (const Error& error : found)
      errors.push_back({fmt::format("{}: /organisms/{}{}", preset_path.string(), i, pointer), error.text()});
  };
  if (auto* tree = std::get_if<WeberPennParams>(&organism.body); tree && !tree->species.empty()) {
    fs::path path = seen_from(preset_path, tree->species);
    Result<std::string> text = read_file(path);
    Result<ArbaroSpecies> species = text ? read_arbaro(*text, path.string()) : text.errors();
    if (!species) return note("/species", species.errors());
    tree->tree = species->tree;
  }
  auto* tree = std::get_if<ColonizedParams>(&organism.body);
  if (!tree || tree->envelope.file.empty()) return;
  EnvelopeParams& e = tree->envelope;
  if (e.kind == EnvelopeKind::mesh)
    return load(e.file, fmt::format("/organisms/{}/envelope/file", i), e.mesh);
  if (e.kind != EnvelopeKind::outline) return;
  Result<Silhouette> outline = load_outline(seen_from(preset_path, e.file));
  if (!outline) return note("/envelope/file", outline.errors());
  e.outline = std::move(*outline);
}

/// Reads the map that says how densely an organism is sown.
void load_map(Organism& organism, std::size_t i, const fs::path& preset_path, Errors& errors) {
  if (!organism.sown || organism.sown->where.map.empty()) return;
  fs::path path = seen_from(preset_path, organism.sown->where.map);
  Result<std::string> text = read_file(path);
  Result<Raster> picture = text ? read_png(*text) : text.errors();
  if (picture) {
    organism.sown->where.density = density_of(*picture);
    return;
  }
  const std::string& what = picture.errors().front().what;
  errors.push_back(
      {fmt::format("{}: /organisms/{}/sown/where/map", preset_path.string(), i),
       text ? path.string() + ": " + what + "; expected a PNG file" : text.errors().front().text()});
}

/// Reads the files that the preset names.
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
    load_tree(preset.organisms[i], i, preset_path, errors, load);
    load_map(preset.organisms[i], i, preset_path, errors);
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

/// What sets the size of a film to so many times what it is.
Result<std::string> scaled_size(const Film& film, double scale) {
  constexpr double kMost = 16;
  constexpr long kLargest = 16384;
  if (!(scale >= 1 && scale <= kMost))
    return Error{"--scale",
                 fmt::format("{} is no such factor; expected a number from 1 to {}", scale, kMost)};
  long width = std::lround(film.size[0] * scale), height = std::lround(film.size[1] * scale);
  if (std::max(width, height) > kLargest)
    return Error{"--scale", fmt::format("pictures of {}x{} would be {}x{} pixels; expected {} at most",
                                        film.size[0], film.size[1], width, height, kLargest)};
  return fmt::format("/film/size=[{},{}]", width, height);
}

/// The files that the shape of an organism depends on, as the preset names them.
std::vector<std::string> files_of(const Organism& organism) {
  std::vector<std::string> files;
  if (const auto* mesh = std::get_if<MeshParams>(&organism.body)) files = {mesh->file};
  if (const auto* tree = std::get_if<WeberPennParams>(&organism.body)) files = {tree->species};
  if (const auto* tree = std::get_if<ColonizedParams>(&organism.body)) files = {tree->envelope.file};
  if (const auto* coral = std::get_if<CoralParams>(&organism.body)) files = {coral->grammar.guide.file};
  if (const auto* plant = std::get_if<PlantParams>(&organism.body)) {
    files = {plant->grammar.guide.file};
    for (const OrganParams& organ : plant->organs) files.push_back(organ.file);
  }
  return files;
}

/// What is sown is grown anew where one of its files has changed.
void note_files(Organism& organism, const fs::path& preset_path) {
  if (!organism.sown) return;
  for (const std::string& file : files_of(organism)) {
    if (file.empty()) continue;
    if (Result<std::string> text = read_file(seen_from(preset_path, file)))
      organism.text += fmt::format(" {:016x}", Seed{}.child(*text).key);
  }
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
  now_doing("reading the preset");
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
  if (preset && arguments.scale) {
    Result<std::string> size = scaled_size(preset->film, *arguments.scale);
    if (!size) return size.errors();
    sets.push_back(*size);
    preset = read_preset(*text, arguments.path, sets);
  }
  if (!preset) return preset;
  if (Errors errors = load_files(*preset, arguments.path); !errors.empty()) return errors;
  for (Organism& organism : preset->organisms) note_files(organism, arguments.path);
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
  for (const Error& error : errors) tell(error.text() + "\n");
  return code;
}

}  // namespace frond
