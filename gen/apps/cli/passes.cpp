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

void passes(const PassesArguments& arguments) {
  limit_threads(arguments.threads);
  Preset preset = or_fail(load_preset(arguments.preset), kWrongInput);
  std::string povray = environment_or("FROND_POVRAY", "povray");
  if (arguments.albedo && !find_program(povray))
    fail({{"--albedo", povray + ": no such program; it is what draws the colours"}}, kCouldNot);
  TracedRun run;
  run.begin(preset,
            arguments.out.empty() ? out_folder("", arguments.preset) / "passes" : fs::path(arguments.out),
            arguments.frames);
  std::optional<Albedo> albedo;
  if (arguments.albedo)
    albedo.emplace(or_fail(Albedo::of(*run.scene, run.models.path() / "frames"), kCouldNot));
  const Camera& camera = run.scene->setup.camera;
  float middle = std::max(glm::distance(camera.location.at(0), camera.look_at.at(0)), 1e-3f);
  now_doing("tracing frames");
  for (int frame = run.range.first; frame <= run.range.last; ++frame) {
    FramePasses made = or_fail(frame_passes(*run.scene, *run.film, frame, arguments.side), kCouldNot);
    or_fail(albedo ? albedo->add_to(made, frame) : Errors{}, kCouldNot);
    std::string picture = or_fail(pass_picture(*run.scene, made), kCouldNot);
    fs::path file = run.out / (frame_name(frame) + ".exr");
    or_fail(write_file(file, picture), kCouldNot);
    put(file.string() + "\n");
    if (!arguments.views) continue;
    for (const PassView& view : pass_views(made, middle)) {
      std::string png = or_fail(png_text(view.picture), kCouldNot);
      or_fail(write_file(run.out / fmt::format("{}_{}.png", frame_name(frame), view.name), png), kCouldNot);
    }
  }
}

}  // namespace frond
