#include "cli/traced_run.h"

#include "cli/commands.h"
#include "cli/judge.h"
#include "cli/messages.h"
#include "cli/streams.h"

namespace frond {

int TracedRun::begin(const Preset& preset, const std::optional<std::string>& frames) {
  const int last = preset.film.frames;
  Result<FrameRange> asked = read_frames(frames, last, {last, last});
  if (!asked) return fail(asked.errors(), kWrongInput);
  range = *asked;
  if (Errors errors = refuse_folder(out); !errors.empty()) return fail(errors, kCouldNot);
  now_doing("growing what stands in the scene");
  Result<Scene> grown = build_scene(preset);
  if (!grown) return fail(grown.errors(), kWrongInput);
  scene.emplace(std::move(*grown));
  if (models.path().empty()) return fail({{"", "no folder can be made for models"}}, kCouldNot);
  Result<TracedFilm> traced = traced_film(*scene, models.path() / "frames");
  if (!traced) return fail(traced.errors(), kCouldNot);
  film.emplace(std::move(*traced));
  return kDone;
}

}  // namespace frond
