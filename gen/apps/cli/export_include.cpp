#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/streams.h"
#include "core/figures.h"
#include "core/files.h"
#include "core/parallel.h"
#include "estimate/estimate_cost.h"
#include "export/formats.h"
#include "export/include.h"
#include "film/film_files.h"
#include "pipeline/out_folder.h"
#include "settings/settings.h"

// A scene as an include for POV-Ray: export to an .inc.

namespace frond {

namespace fs = std::filesystem;

namespace {

const ProgressSink kQuiet{[](auto, auto) {}, [] {}};

/// The files of povinc.
MacroFiles read_macros() {
  MacroFiles macros;
  for (const fs::path& file : files_in(or_fail(home(), kCouldNot) / "povinc"))
    if (file.extension() == ".inc")
      macros.emplace_back(file.filename().string(), or_fail(read_file(file), kCouldNot));
  return macros;
}

/// Grows the models of what is sown.
void grow_models(IncludeVariant& variant) {
  std::vector<ModelFile> files = variant.plans.front().files;  // by copy set, model and level
  variant.models.resize(files.size());
  std::vector<Errors> errors(files.size());
  parallel_for(files.size(), [&](std::size_t i) {
    auto same = [&](std::size_t k) {
      return files[k].copy_set == files[i].copy_set && files[k].model == files[i].model;
    };
    if (i > 0 && same(i - 1)) return;
    const CopySet& set = variant.scene.copy_sets[files[i].copy_set];
    Result<Model> model = grow_copy(set.organism, files[i].model);
    if (!model) errors[i] = model.errors();
    for (std::size_t k = i; model && k < files.size() && same(k); ++k) {
      ModelText text = model_texts({files[k]}, set, *model, {})[0];
      files[k].parts = text.parts;
      variant.models[k] = text.title + text.body;
    }
  });
  for (const Errors& list : errors) or_fail(list, kCouldNot);
  for (CopyPlan& plan : variant.plans) plan.files = files;
}

/// The preset's scene by the n-th seed, with all that an include needs of it beside the include.
IncludeVariant grow_variant(const Preset& preset, const fs::path& out) {
  Preset bare = preset;
  // What is sown follows the land; all else stands on flat ground.
  auto sown = [](const Organism& organism) { return organism.sown.has_value(); };
  if (std::ranges::none_of(preset.organisms, sown)) bare.setup.setting = row_of("studio");
  IncludeVariant variant = include_variant(or_fail(build_scene(bare), kCouldNot));
  grow_models(variant);
  fs::path folder = out.has_parent_path() ? out.parent_path() : fs::path(".");
  or_fail(write_drawings(variant.scene, folder, kQuiet), kCouldNot);
  return variant;
}

/// Options of meshes and volumes, of which an include holds none: POV-Ray has the curves themselves.
Errors unfit_for_include(const ExportArguments& to) {
  const ExportArguments usual;
  for (auto [given, name] :
       {std::pair(to.keys != usual.keys, "--keys"), std::pair(to.levels != usual.levels, "--lods"),
        std::pair(to.voxel != usual.voxel, "--voxel"), std::pair(to.instances, "--instances")})
    if (given) return {{name, "is nothing that an .inc has; expected a .glb or .vdb, or none of it"}};
  if (std::ranges::any_of(fs::path(to.out).filename().string(),
                          [](char c) { return static_cast<unsigned char>(c) > 126; }))
    return {{to.out,
             "POV-Ray opens no include whose name has other letters than those of English; expected "
             "such a name, as in oak.inc"}};
  return {};
}

}  // namespace

void export_include(const ExportArguments& arguments) {
  fs::path out = arguments.out;
  or_fail(unfit_for_include(arguments), kWrongInput);
  or_fail(refuse_file(out), kCouldNot);
  Preset preset = or_fail(load_preset(arguments.preset), kWrongInput);
  if (!arguments.quiet) tell_notes(preset.notes);
  const Film& film = preset.film;
  int last = or_fail(read_frame(arguments.frame, film.frames), kWrongInput);
  FrameRange range = or_fail(read_frames(arguments.frames, film.frames, {last, last}), kWrongInput);
  Result<CostEstimate> estimate = estimate_cost(preset, {range.first, range.last});
  Errors refused = estimate ? refuse(*estimate, this_machine(".")) : estimate.errors();
  or_fail(refused, kWrongInput);
  IncludeText text{include_name(out.stem().string()),
                   out.filename().string(),
                   preset.title,
                   arguments.preset.path,
                   read_macros(),
                   {}};
  for (int frame = range.first; frame <= range.last; ++frame) text.frames.push_back(frame);
  std::vector<IncludeVariant> variants;
  for (int i = 0; i < arguments.seeds; ++i) {
    now_doing("growing what stands in the scene");
    preset.seed += i > 0 ? 1 : 0;
    variants.push_back(grow_variant(preset, out));
  }
  now_doing("writing the include");
  Result<std::string> written = include_text(text, variants);
  if (!written) {
    Errors errors = written.errors();
    bool early = errors.front().what.starts_with(kNothingYet);
    if (errors.front().where.empty()) errors.front().where = arguments.out;
    fail(errors, early ? kNothingGrown : kWrongInput);
  }
  or_fail(write_file(out, *written), kCouldNot);
  if (!arguments.quiet)
    tell(fmt::format("{}: {}; in a scene: #include \"{}\", then object {{ {}(0, 0) }}", arguments.out,
                     bytes_text(static_cast<double>(written->size())), text.file, text.name));
}

}  // namespace frond
