#include "app/named_files.h"

#include <fmt/format.h>

#include <string_view>

#include "crown/arbaro.h"
#include "geometry/obj.h"

namespace frond {

namespace {

/// What was read from a file, or what is wrong with that.
Error about(const NamedFile& file, const Errors& errors) {
  Error error = errors.front();
  if (error.where.empty()) error.where = file.path.string();
  return Error{"", error.text()};
}

Result<Surface> load_mesh(const std::string& name, const Assets& assets) {
  Result<NamedFile> file = assets.read(name);
  if (!file) return file.errors();
  Result<Surface> mesh = read_obj(file->text, file->path.string());
  if (!mesh) return about(*file, mesh.errors());
  return to_unit(std::move(*mesh));
}

Result<Silhouette> load_outline(const std::string& name, const Assets& assets) {
  Result<NamedFile> file = assets.read(name);
  if (!file) return file.errors();
  if (file->path.extension() == ".svg") {
    Result<std::vector<std::vector<Vec2>>> drawn = read_svg(file->text);
    if (!drawn) return about(*file, drawn.errors());
    for (auto& outline : *drawn)
      for (Vec2& p : outline) p.y = -p.y;  // SVG's y runs down
    Result<Silhouette> outline = Silhouette::from_outlines(std::move(*drawn));
    return outline ? std::move(outline) : about(*file, outline.errors());
  }
  Result<Raster> picture = read_png(file->text);
  if (!picture) {
    Error error = about(*file, picture.errors());
    return Error{"", error.what + "; expected an SVG or a PNG file"};
  }
  Result<Silhouette> outline = Silhouette::from_picture(*picture);
  return outline ? std::move(outline) : about(*file, outline.errors());
}

/// Reads the files of one organism.
class Loader {
 public:
  Loader(Preset& preset, std::size_t index, const Assets& assets, Errors& errors)
      : preset_(preset),
        organism_(preset.organisms[index]),
        index_(index),
        assets_(assets),
        errors_(errors) {}

  void load() {
    if (auto* body = std::get_if<MeshParams>(&organism_.body)) mesh(body->file, "/file", body->mesh);
    if (auto* tree = std::get_if<WeberPennParams>(&organism_.body)) species(*tree);
    if (auto* tree = std::get_if<ColonizedParams>(&organism_.body)) envelope(tree->envelope);
    if (organism_.sown) map(organism_.sown->where);
    auto* plant = std::get_if<PlantParams>(&organism_.body);
    auto* coral = std::get_if<CoralParams>(&organism_.body);
    if (GrammarText* grammar = plant ? &plant->grammar : coral ? &coral->grammar : nullptr)
      note("/grammar/guide/file", load_guide(grammar->guide, assets_));
    for (std::size_t k = 0; plant && k < plant->organs.size(); ++k)
      if (OrganParams& organ = plant->organs[k]; organ.shape == OrganShape::obj)
        mesh(organ.file, fmt::format("/organs/{}/file", k), organ.mesh);
  }

 private:
  void note(std::string_view pointer, const Errors& found) {
    for (const Error& error : found)
      errors_.push_back(fault_at(preset_, fmt::format("/organisms/{}{}", index_, pointer), error.text()));
  }

  void mesh(const std::string& name, std::string_view pointer, Surface& into) {
    Result<Surface> mesh = load_mesh(name, assets_);
    if (!mesh) return note(pointer, mesh.errors());
    into = std::move(*mesh);
  }

  void species(WeberPennParams& tree) {
    if (tree.species.empty()) return;
    Result<NamedFile> file = assets_.read(tree.species);
    if (!file) return note("/species", file.errors());
    Result<ArbaroSpecies> species = read_arbaro(file->text, file->path.string());
    if (!species) return note("/species", species.errors());
    tree.tree = species->tree;
    note("/species", check(organism_));
  }

  void envelope(EnvelopeParams& envelope) {
    if (envelope.file.empty()) return;
    if (envelope.kind == EnvelopeKind::mesh) mesh(envelope.file, "/envelope/file", envelope.mesh);
    if (envelope.kind != EnvelopeKind::outline) return;
    Result<Silhouette> outline = load_outline(envelope.file, assets_);
    if (!outline) return note("/envelope/file", outline.errors());
    envelope.outline = std::move(*outline);
  }

  /// The map that says how densely it is sown.
  void map(SowRules& where) {
    if (where.map.empty()) return;
    Result<NamedFile> file = assets_.read(where.map);
    if (!file) return note("/sown/where/map", file.errors());
    Result<Raster> picture = read_png(file->text);
    if (picture) {
      where.density = density_of(*picture);
    } else {
      Error error = about(*file, picture.errors());
      note("/sown/where/map", {{"", error.what + "; expected a PNG file"}});
    }
  }

  Preset& preset_;
  Organism& organism_;
  std::size_t index_;
  const Assets& assets_;
  Errors& errors_;
};

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
void note_files(Organism& organism, const Assets& assets) {
  if (!organism.sown) return;
  for (const std::string& name : files_of(organism)) {
    if (name.empty()) continue;
    if (Result<NamedFile> file = assets.read(name))
      organism.text += fmt::format(" {:016x}", Seed{}.child(file->text).key);
  }
}

}  // namespace

Errors load_guide(GuideText& guide, const Assets& assets) {
  if (guide.file.empty()) return {};
  Result<NamedFile> file = assets.read(guide.file);
  if (!file) return file.errors();
  Result<LineSet> lines = read_obj_lines(file->text, file->path.string());
  if (!lines) return {about(*file, lines.errors())};
  guide.lines = {std::move(lines->place), std::move(lines->line)};
  return {};
}

Errors load_files(Preset& preset, const Assets& assets) {
  Errors errors;
  for (std::size_t i = 0; i < preset.organisms.size(); ++i) {
    Loader(preset, i, assets, errors).load();
    note_files(preset.organisms[i], assets);
  }
  return errors;
}

}  // namespace frond
