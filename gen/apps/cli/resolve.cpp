
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/heartbeat.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/linear.h"
#include "core/parallel.h"
#include "emit/setting.h"
#include "estimate/estimate_pictures.h"
#include "images/png_rows.h"
#include "images/png_samples.h"
#include "images/raster.h"
#include "images/tone.h"
#include "pipeline/out_folder.h"
#include "pipeline/pass_picture.h"
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

LightPicture light_of(const LinearRaster& raster) {
  static const std::vector<float> exact = exact_light();
  LightPicture light(raster.data.size() / 3);
  for (std::size_t i = 0; i < light.size(); ++i)
    for (int c = 0; c < 3; ++c) light[i][c] = exact[raster.data[3 * i + static_cast<std::size_t>(c)]];
  return light;
}

Error wrong_size(const fs::path& file, int width, int height, const Film& film) {
  auto [wide, high] = film.drawn_size();
  return error_at(file.string(), "is {}x{}; expected {}x{}", width, height, wide, high);
}

/// The light of a raw frame's file.
Result<LightPicture> read_raw(const fs::path& file, const Film& film) {
  Result<std::string> bytes = read_file(file);
  if (!bytes) return bytes.errors();
  Result<LinearRaster> raster = read_linear_png(*bytes);
  if (!raster) return Error{file.string(), raster.errors()[0].what};
  if (std::array{raster->width, raster->height} != film.drawn_size())
    return wrong_size(file, raster->width, raster->height, film);
  return light_of(*raster);
}

/// The rows of a raw still's file, of which the last are kept: bands share some.
class RawRows {
 public:
  static Result<RawRows> open(const fs::path& file, const Film& film) {
    RawRows rows;
    Result<std::string> bytes = read_file(file);
    if (!bytes) return bytes.errors();
    rows.bytes_ = std::make_unique<std::string>(std::move(*bytes));
    Result<PngRows> png = PngRows::open(*rows.bytes_);
    if (!png) return Error{file.string(), png.errors()[0].what};
    if (std::array{png->width(), png->height()} != film.drawn_size())
      return wrong_size(file, png->width(), png->height(), film);
    rows.png_ = std::move(*png);
    return rows;
  }

  Result<LightPicture> read(int first, int count) {
    auto wide = static_cast<std::size_t>(png_->width());
    kept_.erase(kept_.begin(),
                kept_.begin() + static_cast<std::ptrdiff_t>(wide * static_cast<std::size_t>(first - first_)));
    first_ = first;
    Result<LinearRaster> more = png_->next_linear(first + count - png_->done(), false);
    if (!more) return more.errors();
    std::ranges::copy(light_of(*more), std::back_inserter(kept_));
    return kept_;
  }

 private:
  std::unique_ptr<std::string> bytes_;
  std::optional<PngRows> png_;
  LightPicture kept_;
  int first_ = 0;  // of those that are kept
};

/// Rows of a picture as people see it, the first of them of that number.
PngSamples seen_rows(const LightPicture& light, int first, const Film& film, const Tone& tone) {
  int rows = static_cast<int>(light.size() / static_cast<std::size_t>(film.size[0]));
  PngSamples rows_seen{film.size[0], rows, 3, film.depth == 16 ? 16 : 8, 45455, {}};
  rows_seen.data.resize(rows_seen.row() * static_cast<std::size_t>(rows));
  for (std::size_t p = 0; p < light.size(); ++p) {
    auto n = static_cast<int>(p);
    auto of = [&](int c) { return static_cast<double>(light[p][c]); };
    std::array<double, 3> color =
        seen({of(0), of(1), of(2)}, tone, {n % film.size[0], first + n / film.size[0]}, film.size);
    for (std::size_t c = 0; c < 3; ++c) {
      if (rows_seen.bits == 16)
        rows_seen.set16(3 * p + c, color[c]);
      else
        rows_seen.data[3 * p + c] = to_byte(color[c]);
    }
  }
  return rows_seen;
}

/// Raw frames that are not there.
Errors missing_raws(const fs::path& folder, FrameRange range) {
  Errors errors;
  for (int frame = range.first; frame <= range.last; ++frame)
    if (fs::path file = folder / (frame_name(frame) + ".png"); !path_exists(file))
      errors.push_back({file.string(), "is not there; `frond generate --resolve` and POV-Ray make it"});
  return errors;
}

/// The bytes of a picture as people see it.
Result<std::string> picture_bytes(const LightPicture& light, const Film& film, const Tone& tone) {
  PngSamples rows = seen_rows(light, 0, film, tone);
  if (rows.bits == 16) return samples_text(rows);
  Raster picture(film.size[0], film.size[1], 3);
  picture.data = std::move(rows.data);
  return png_text(picture);
}

/// The bytes of the picture of a still that is too large to be held.
Result<std::string> large_still(Resolver& resolver, const fs::path& raw, const Film& film, const Tone& tone,
                                int band) {
  Result<RawRows> rows = RawRows::open(raw, film);
  if (!rows) return rows.errors();
  PngWriter writer({film.size[0], film.size[1], 3, film.depth == 16 ? 16 : 8, 45455, {}});
  int done = 0;  // rows
  Errors errors =
      resolver.still_in_bands([&](int first, int count) { return rows->read(first, count); }, band,
                              [&](const LightPicture& light) {
                                PngSamples part = seen_rows(light, done, film, tone);
                                done += part.height;
                                writer.add(part);
                                return Errors{};
                              });
  return errors.empty() ? writer.finish() : Result<std::string>(errors);
}

/// Rows of a still that are resolved at a time; 0: all of it. Through a lens samples come from all over the
/// picture.
int band_of(const Scene& scene) {
  constexpr double kBand = kResolvedWhole / 4;  // samples
  auto [width, height] = scene.film.drawn_size();
  if (scene.film.frames > 1 || scene.setup.camera.aperture ||
      static_cast<double>(width) * height <= kResolvedWhole)
    return 0;
  return std::max(16, static_cast<int>(kBand / width * scene.film.size[1] / height));
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
  if (has_pictures(scene.setup)) {
    options.fade = std::min(options.fade, kMovingFade * scene.film.fps);
    options.clip = kMovingClip;
  }
  options.fade = arguments.fade.value_or(options.fade);
  options.clip = arguments.clip.value_or(options.clip);
  return options;
}

}  // namespace

void resolve(const ResolveArguments& arguments) {
  limit_threads(arguments.threads);
  Heartbeat heartbeat(arguments.quiet);
  Preset preset = or_fail(load_preset(arguments.preset), kWrongInput);
  or_fail(refuse_resolving(preset.film, true), kWrongInput);
  preset.film.raw = true;
  FrameRange range =
      or_fail(read_frames(arguments.frames, preset.film.frames, {1, preset.film.frames}), kWrongInput);
  fs::path film = out_folder(arguments.folder, arguments.preset);
  fs::path raws = film / "raw", out = arguments.out.empty() ? film / "frames" : fs::path(arguments.out);
  or_fail(missing_raws(raws, range), kCouldNot);
  or_fail(refuse_folder(out), kCouldNot);
  now_doing("growing what stands in the scene");
  Scene scene = or_fail(build_scene(preset), kWrongInput);
  TracedFilm traced = or_fail(traced_film(scene, film / "frames"), kCouldNot);
  auto source = [&](int frame) { return read_raw(raws / (frame_name(frame) + ".png"), scene.film); };
  Resolver resolver(scene, traced, source, options_for(scene, arguments));
  const Camera& camera = scene.setup.camera;
  Tone tone{camera.highlights, camera.contrast, camera.saturation, camera.warmth, camera.vignette};
  auto picture = [&](int frame) -> Result<std::string> {
    if (int band = band_of(scene))
      return large_still(resolver, raws / (frame_name(frame) + ".png"), scene.film, tone, band);
    Result<LightPicture> light = resolver.frame(frame);
    return light ? picture_bytes(*light, scene.film, tone) : light.errors();
  };
  for (int frame = range.first; frame <= range.last; ++frame) {
    now_doing("resolving frames");
    std::string png = or_fail(picture(frame), kCouldNot);
    or_fail(write_file(out / (frame_name(frame) + ".png"), png), kCouldNot);
  }
}

}  // namespace frond
