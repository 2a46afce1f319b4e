#include "cli/albedo.h"

#include <fmt/format.h>

#include <utility>

#include "cli/inputs.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "film/film_files.h"
#include "images/raster.h"
#include "render/process.h"

namespace frond {

namespace fs = std::filesystem;

Result<Albedo> Albedo::of(Scene& scene, const fs::path& folder) {
  Albedo made(scene, folder);
  ProgressSink quiet{[](auto, auto) {}, [] {}};
  Result<fs::path> root = home();
  if (!root) return root.errors();
  Result<std::string> layout = read_file(*root / "templates" / "frame.pov");
  if (!layout) return layout.errors();
  made.layout_ = std::move(*layout);
  if (Errors errors = write_drawings(scene, folder, quiet); !errors.empty()) return errors;
  Result<CopyPlan> plan = write_models(scene, folder, quiet);
  if (!plan) return plan.errors();
  made.parts_ = prepare_frames(scene, std::move(*plan));
  for (const Picture& file : made.parts_.files)
    if (Result<bool> written = write_file(folder / file.name, file.bytes); !written) return written.errors();
  return made;
}

/// Sharp, as rays through the middles of pixels see it.
Errors Albedo::write_scene(int frame) const {
  auto aperture = std::exchange(scene_.setup.camera.aperture, std::nullopt);
  Result<FrameFile> written = write_frame_file(scene_, parts_, layout_, folder_, frame);
  scene_.setup.camera.aperture = aperture;
  return written ? Errors{} : written.errors();
}

Errors Albedo::add_to(FramePasses& passes, int frame) const {
  if (Errors errors = write_scene(frame); !errors.empty()) return errors;
  std::string scene = (folder_ / (frame_name(frame) + ".pov")).string(),
              picture = (folder_ / (frame_name(frame) + ".png")).string();
  OutputCapture said;
  Command command;
  command.out = command.err = said.descriptor();
  command.environment = {fmt::format("FROND_THREADS={}", thread_count())};
  command.words = {own_program().string(),
                   "frame",
                   scene,
                   picture,
                   fmt::format("{}x{}", passes.width, passes.height),
                   "--",
                   "+Q1",
                   "-A",
                   "-J",
                   "+FN16",
                   "File_Gamma=1.0",
                   "Declare=Frond_Albedo=1"};
  Result<int> status = run(command);
  if (!status) return status.errors();
  if (*status != 0) return {{"", "POV-Ray could not draw the colours: " + said.text()}};
  Result<std::string> bytes = read_file(picture);
  if (!bytes) return bytes.errors();
  Result<LinearRaster> raster = read_linear_png(*bytes);
  if (!raster) return raster.errors();
  passes.albedo.assign(passes.depth.size(), Vec3(0));
  for (std::size_t i = 0; i < passes.albedo.size(); ++i)
    for (int c = 0; c < 3 && passes.normal[i] != Vec3(0); ++c)
      passes.albedo[i][c] = static_cast<float>(raster->data[3 * i + static_cast<std::size_t>(c)]) / 65535;
  return {};
}

}  // namespace frond
