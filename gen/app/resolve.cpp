#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands.h"
#include "app/inputs.h"
#include "app/judge.h"
#include "app/messages.h"
#include "app/streams.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/linear.h"
#include "core/parallel.h"
#include "emit/setting.h"
#include "images/png_samples.h"
#include "images/raster.h"
#include "images/tone.h"
#include "resolve/resolve.h"

// Frames of raw ones: resolve.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// The light of each value of a LinearRaster that was read from sRGB: libpng takes its curve for a power,
/// which is wrong by a tenth in the dark.
std::vector<float> exact_light() {
  constexpr double kPower = 0.45455;  // as the file's gAMA has it
  std::vector<float> light(1 << 16);
  for (std::size_t i = 0; i < light.size(); ++i)
    light[i] = static_cast<float>(linear(std::pow(static_cast<double>(i) / 65535, kPower)));
  return light;
}

/// The light of a raw frame's file.
Result<LightPicture> read_raw(const fs::path& file, const Film& film) {
  Result<std::string> bytes = read_file(file);
  if (!bytes) return bytes.errors();
  Result<LinearRaster> raster = read_linear_png(*bytes);
  if (!raster) return Error{file.string(), raster.errors()[0].what};
  auto [width, height] = film.drawn_size();
  if (raster->width != width || raster->height != height)
    return Error{file.string(),
                 fmt::format("is {}x{}; expected {}x{}", raster->width, raster->height, width, height)};
  static const std::vector<float> exact = exact_light();
  LightPicture light(raster->data.size() / 3);
  for (std::size_t i = 0; i < light.size(); ++i)
    for (int c = 0; c < 3; ++c) light[i][c] = exact[raster->data[3 * i + static_cast<std::size_t>(c)]];
  return light;
}

/// Raw frames that are not there.
Errors missing_raws(const fs::path& folder, FrameRange range) {
  Errors errors;
  std::error_code error;
  for (int frame = range.first; frame <= range.last; ++frame)
    if (fs::path file = folder / (frame_name(frame) + ".png"); !fs::exists(file, error))
      errors.push_back({file.string(), "is not there; `frond generate --resolve` and POV-Ray make it"});
  return errors;
}

/// The bytes of a picture as people see it.
Result<std::string> picture_bytes(const LightPicture& light, const Film& film, const Tone& tone) {
  auto share = [&](std::size_t i) {
    return encoded(toned(static_cast<double>(light[i / 3][static_cast<int>(i % 3)]), tone));
  };
  if (film.depth == 16) {
    PngSamples deep{film.size[0], film.size[1], 3, 16, 45455, {}};
    deep.data.resize(6 * light.size());
    for (std::size_t i = 0; i < 3 * light.size(); ++i) deep.set16(i, share(i));
    return samples_text(deep);
  }
  Raster picture(film.size[0], film.size[1], 3);
  for (std::size_t i = 0; i < picture.data.size(); ++i) picture.data[i] = to_byte(share(i));
  return png_text(picture);
}

/// Where waves throw moving light, that of other frames soon counts for little. A still is one picture, and
/// may take more rays.
ResolveOptions options_for(const Scene& scene, const ResolveArguments& arguments) {
  constexpr double kMovingFade = 0.1, kMovingClip = 2;  // seconds; deviations
  constexpr int kStillSide = 6;
  ResolveOptions options;
  options.window = arguments.window, options.reach = arguments.reach;
  if (scene.film.frames == 1) options.side = kStillSide;
  options.side = arguments.side.value_or(options.side);
  if (has_pictures(scene.stage)) {
    options.fade = std::min(options.fade, kMovingFade * scene.film.fps);
    options.clip = kMovingClip;
  }
  options.fade = arguments.fade.value_or(options.fade);
  options.clip = arguments.clip.value_or(options.clip);
  return options;
}

}  // namespace

int resolve(const ResolveArguments& arguments) {
  limit_threads(arguments.threads);
  Result<Preset> preset = load_preset(arguments.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  if (Errors errors = refuse_resolving(preset->film, true); !errors.empty()) return fail(errors, kWrongInput);
  preset->film.raw = true;
  Result<FrameRange> range = read_frames(arguments.frames, preset->film.frames, {1, preset->film.frames});
  if (!range) return fail(range.errors(), kWrongInput);
  fs::path film = arguments.folder.empty() ? fs::path("out") / fs::path(arguments.preset.path).stem()
                                           : fs::path(arguments.folder);
  fs::path raws = film / "raw", out = arguments.out.empty() ? film / "frames" : fs::path(arguments.out);
  if (Errors errors = missing_raws(raws, *range); !errors.empty()) return fail(errors, kCouldNot);
  if (Errors errors = refuse_folder(out); !errors.empty()) return fail(errors, kCouldNot);
  now_doing("growing what stands in the scene");
  Result<Scene> scene = build_scene(*preset);
  if (!scene) return fail(scene.errors(), kWrongInput);
  Result<TracedFilm> traced = traced_film(*scene, film / "frames");
  if (!traced) return fail(traced.errors(), kCouldNot);
  auto source = [&](int frame) { return read_raw(raws / (frame_name(frame) + ".png"), scene->film); };
  Resolver resolver(*scene, *traced, source, options_for(*scene, arguments));
  const Camera& camera = scene->stage.camera;
  for (int frame = range->first; frame <= range->last; ++frame) {
    now_doing("resolving frames");
    Result<LightPicture> light = resolver.frame(frame);
    if (!light) return fail(light.errors(), kCouldNot);
    Result<std::string> png = picture_bytes(*light, scene->film, {camera.highlights, camera.contrast});
    if (!png) return fail(png.errors(), kCouldNot);
    Result<bool> written = write_file(out / (frame_name(frame) + ".png"), *png);
    if (!written) return fail(written.errors(), kCouldNot);
  }
  return kDone;
}

}  // namespace frond
