#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/commands.h"
#include "app/inputs.h"
#include "app/messages.h"
#include "app/streams.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "core/work_folder.h"
#include "drawing/ink.h"
#include "images/png_samples.h"
#include "scene/scene.h"

// Ink drawings of frames: draw.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Rays a pixel, along each side: fewer where a picture is large, whose lines are many pixels wide.
int fine_for(const std::array<int, 2>& size) {
  constexpr double kMost = 6e6;
  return static_cast<double>(size[0]) * size[1] <= kMost ? 2 : 1;
}

/// A line is about a thousandth of the picture's long side wide, but never less than most of a pixel.
float pen_for(const std::array<int, 2>& size, double width) {
  return static_cast<float>(width * std::max(0.8, std::max(size[0], size[1]) / 1100.0));
}

}  // namespace

int draw_ink(const DrawArguments& arguments) {
  limit_threads(arguments.threads);
  Result<Preset> preset = load_preset(arguments.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  if (preset->film.crop || preset->film.depth != 8)
    return fail({{preset->film.crop ? "--crop" : "--depth", "drawings are whole pictures of 8 bits"}},
                kWrongInput);
  const int last = preset->film.frames;
  Result<FrameRange> range = read_frames(arguments.frames, last, {last, last});
  if (!range) return fail(range.errors(), kWrongInput);
  bool paper = !preset->film.transparent();
  fs::path out = arguments.out.empty() ? fs::path("out") / fs::path(arguments.preset.path).stem() / "drawn"
                                       : fs::path(arguments.out);
  now_doing("growing what stands in the scene");
  Result<Scene> scene = build_scene(*preset);
  if (!scene) return fail(scene.errors(), kWrongInput);
  WorkFolder models;
  if (models.path().empty()) return fail({{"", "no folder can be made for models"}}, kCouldNot);
  Result<TracedFilm> film = traced_film(*scene, models.path() / "frames");
  if (!film) return fail(film.errors(), kCouldNot);
  const std::array<int, 2>& size = scene->film.size;
  InkStyle style{pen_for(size, arguments.pen), static_cast<float>(arguments.hatch), paper};
  now_doing("drawing frames");
  for (int frame = range->first; frame <= range->last; ++frame) {
    Result<TracedFrame> traced = film->at(scene->film.time(frame));
    if (!traced) return fail(traced.errors(), kCouldNot);
    Grid ink = ink_drawing(ink_samples(*traced, size[0], size[1], fine_for(size)), style);
    Result<std::string> png = png_text(ink_picture(ink, paper));
    if (!png) return fail(png.errors(), kCouldNot);
    if (scene->film.dpi > 0) png = with_density(*png, scene->film.dpi);
    fs::path file = out / (frame_name(frame) + ".png");
    Result<bool> written = write_file(file, *png);
    if (!written) return fail(written.errors(), kCouldNot);
    put(file.string() + "\n");
  }
  return kDone;
}

}  // namespace frond
