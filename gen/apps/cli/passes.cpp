#include "passes/frame_passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/albedo.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/pass_views.h"
#include "cli/streams.h"
#include "cli/traced_run.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "pipeline/pass_picture.h"
#include "render/process.h"

// What compositors want to know of frames besides their colours: passes.

namespace frond {

namespace fs = std::filesystem;

int passes(const PassesArguments& arguments) {
  limit_threads(arguments.threads);
  Result<Preset> preset = load_preset(arguments.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  std::string povray = environment_or("FROND_POVRAY", "povray");
  if (arguments.albedo && !find_program(povray))
    return fail({{"--albedo", povray + ": no such program; it is what draws the colours"}}, kCouldNot);
  TracedRun run;
  if (int code = run.begin(*preset, arguments, "passes"); code != kDone) return code;
  std::optional<Albedo> albedo;
  if (arguments.albedo) {
    Result<Albedo> made = Albedo::of(*run.scene, run.models.path() / "frames");
    if (!made) return fail(made.errors(), kCouldNot);
    albedo.emplace(std::move(*made));
  }
  const Camera& camera = run.scene->setup.camera;
  float middle = std::max(glm::distance(camera.location.at(0), camera.look_at.at(0)), 1e-3f);
  now_doing("tracing frames");
  for (int frame = run.range.first; frame <= run.range.last; ++frame) {
    Result<FramePasses> made = frame_passes(*run.scene, *run.film, frame, arguments.side);
    if (!made) return fail(made.errors(), kCouldNot);
    if (Errors errors = albedo ? albedo->add_to(*made, frame) : Errors{}; !errors.empty())
      return fail(errors, kCouldNot);
    Result<std::string> picture = pass_picture(*run.scene, *made);
    if (!picture) return fail(picture.errors(), kCouldNot);
    fs::path file = run.out / (frame_name(frame) + ".exr");
    Result<bool> written = write_file(file, *picture);
    if (!written) return fail(written.errors(), kCouldNot);
    put(file.string() + "\n");
    if (!arguments.views) continue;
    for (const PassView& view : pass_views(*made, middle)) {
      Result<std::string> png = png_text(view.picture);
      if (!png) return fail(png.errors(), kCouldNot);
      if (written = write_file(run.out / fmt::format("{}_{}.png", frame_name(frame), view.name), *png);
          !written)
        return fail(written.errors(), kCouldNot);
    }
  }
  return kDone;
}

}  // namespace frond
