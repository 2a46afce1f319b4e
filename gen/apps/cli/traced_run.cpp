#include "cli/traced_run.h"

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "pipeline/out_folder.h"
#include "pipeline/pass_picture.h"

namespace frond {

void TracedRun::begin(const Preset& preset, const std::filesystem::path& to,
                      const std::optional<std::string>& frames) {
  out = to;
  const int last = preset.film.frames;
  range = or_fail(read_frames(frames, last, {last, last}), kWrongInput);
  or_fail(refuse_folder(out), kCouldNot);
  now_doing("growing what stands in the scene");
  scene.emplace(or_fail(build_scene(preset), kWrongInput));
  if (models.path().empty()) fail({{"", "no folder can be made for models"}}, kCouldNot);
  film.emplace(or_fail(traced_film(*scene, models.path() / "frames"), kCouldNot));
}

}  // namespace frond
