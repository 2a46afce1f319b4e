#include <fmt/format.h>

#include "app/commands.h"
#include "app/inputs.h"
#include "app/streams.h"
#include "export/formats.h"

namespace frond {

int export_scene(const ExportArguments& arguments) {
  if (arguments.out.ends_with(".inc")) return export_include(arguments);
  Result<const Format*> format = format_of(arguments.out);
  if (!format) return fail(format.errors(), kWrongInput);
  Result<Preset> preset = load_preset(arguments.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  if (!arguments.quiet) tell_notes(preset->notes);
  const Film& film = preset->film;
  int frame = arguments.frame == 0 ? 1 : arguments.frame;
  if (frame < 1 || frame > film.frames)
    return fail(
        {Error{"--frame", fmt::format("{} is no frame of this film; expected 1-{}", frame, film.frames)}},
        kWrongInput);
  now_doing("growing what stands in the scene");
  Result<Scene> scene = build_scene(*preset);
  if (!scene) return fail(scene.errors(), kWrongInput);

  auto foretell = [&](double bytes) {
    if (!arguments.quiet) tell(fmt::format("{}: about {:.2g} MB", arguments.out, bytes / 1e6));
  };
  now_doing("writing the mesh or the volume");
  Result<bool> written = write_scene(
      **format, *scene, film.time(frame),
      {arguments.sides, arguments.voxel, arguments.detail, arguments.texture, arguments.instances},
      arguments.out, foretell);
  if (written) return kDone;
  // What the disk says stands at a path; all else is what was asked for.
  Errors errors = written.errors();
  bool wrong = errors.front().where.empty();
  if (wrong) errors.front().where = arguments.out;
  return fail(errors, wrong ? kWrongInput : kCouldNot);
}

}  // namespace frond
