#include <fmt/format.h>

#include <filesystem>

#include "cli/commands.h"
#include "cli/heartbeat.h"
#include "cli/inputs.h"
#include "cli/judge.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "draw/sizes.h"
#include "preview/quick_look.h"

// What a preset is going to look like: look.

namespace frond {

int look(const LookArguments& arguments) {
  Heartbeat heartbeat;
  Result<Preset> preset = load_preset(arguments.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  const Film& film = preset->film;
  Result<int> asked = read_frame(arguments.frame, film.frames);
  if (!asked) return fail(asked.errors(), kWrongInput);
  int frame = *asked;
  std::string out = arguments.out.empty()
                        ? std::filesystem::path(arguments.preset.path).stem().string() + "_look.png"
                        : arguments.out;
  if (!out.ends_with(".png"))
    return fail({Error{"--out", fmt::format("{} has no known extension; expected .png", out)}}, kWrongInput);
  if (Errors errors = refuse_file(out); !errors.empty()) return fail(errors, kCouldNot);
  tell_notes(preset->notes);
  now_doing("growing what stands in the scene");
  Result<Scene> scene = build_scene(*preset);
  if (!scene) return fail(scene.errors(), kWrongInput);
  for (const std::string& note : scene->notes) tell(note);
  now_doing("drawing what the camera sees");
  Result<std::string> png = png_text(quick_look(*scene, film.time(frame)));
  Result<bool> written = png ? write_file(out, *png) : png.errors();
  if (!written) return fail(written.errors(), kCouldNot);
  Result<std::vector<GrownSize>> sizes = sizes_of(*scene, *preset, film.time(frame));
  if (!sizes) return fail(sizes.errors(), kCouldNot);
  for (const std::string& line : sizes_lines(*sizes)) tell(line);
  put(out + "\n");
  return kDone;
}

}  // namespace frond
