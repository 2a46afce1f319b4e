#include <algorithm>
#include <filesystem>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "cli/traced_run.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "images/png_samples.h"
#include "ink/ink.h"

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

void draw_ink(const DrawArguments& arguments) {
  limit_threads(arguments.threads);
  Preset preset = or_fail(load_preset(arguments.preset), kWrongInput);
  if (preset.film.crop || preset.film.depth != 8)
    fail({{preset.film.crop ? "--crop" : "--depth", "drawings are whole pictures of 8 bits"}}, kWrongInput);
  TracedRun run;
  run.begin(preset,
            arguments.out.empty() ? out_folder("", arguments.preset) / "drawn" : fs::path(arguments.out),
            arguments.frames);
  const Film& film = run.scene->film;
  bool paper = !film.transparent();
  const std::array<int, 2>& size = film.size;
  InkStyle style{pen_for(size, arguments.pen), static_cast<float>(arguments.hatch), paper};
  now_doing("drawing frames");
  for (int frame = run.range.first; frame <= run.range.last; ++frame) {
    TracedFrame traced = or_fail(run.film->at(film.time(frame)), kCouldNot);
    Grid ink = ink_drawing(ink_samples(traced, size[0], size[1], fine_for(size)), style);
    std::string png = or_fail(png_text(ink_picture(ink, paper)), kCouldNot);
    if (film.dpi > 0) png = with_density(png, film.dpi);
    fs::path file = run.out / (frame_name(frame) + ".png");
    or_fail(write_file(file, png), kCouldNot);
    put(file.string() + "\n");
  }
}

}  // namespace frond
