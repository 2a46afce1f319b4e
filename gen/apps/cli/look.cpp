#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/heartbeat.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "draw/sizes.h"
#include "pipeline/out_folder.h"
#include "preview/quick_look.h"
#include "scene/specimen_cache.h"

// What a preset is going to look like: look.

namespace frond {

namespace {

/// Draws a picture into a larger one.
void paste(const Raster& picture, int left, int top, Raster& sheet) {
  for (int y = 0; y < picture.height; ++y)
    std::copy_n(&picture.data[picture.index(0, y)], 3 * static_cast<std::size_t>(picture.width),
                &sheet.data[sheet.index(left, top + y)]);
}

/// Six views of what the preset's camera looks at, two for each side that light may come from; tells how each
/// is asked for.
Result<Raster> composed_views(const Preset& preset, int frame) {
  constexpr int kColumns = 2, kRows = 3, kGap = 4, kWidest = 480;  // pixels
  constexpr std::pair<std::string_view, LightSide> kLights[kRows] = {
      {"back", LightSide::back}, {"side", LightSide::side}, {"front", LightSide::front}};
  constexpr std::pair<std::string_view, Third> kThirds[kColumns] = {{"left", Third::left},
                                                                    {"right", Third::right}};
  auto [width, height] = preset.film.size;
  std::array<int, 2> size{std::min(width, kWidest), 0};
  size[1] = std::max(1, height * size[0] / width);
  Raster sheet(kColumns * (size[0] + kGap) - kGap, kRows * (size[1] + kGap) - kGap, 3);
  std::ranges::fill(sheet.data, std::uint8_t{255});
  SpecimenCache cache;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      Preset view = preset;
      Composition& composition =
          view.setup.camera.compose.emplace(preset.setup.camera.compose.value_or(Composition{}));
      auto [light, side] = kLights[row];
      auto [third, part] = kThirds[column];
      composition.light = side, composition.third = part;
      now_doing("growing what stands in the scene");
      Result<Scene> scene = build_scene(view, {[](auto, auto) {}, [] {}}, &cache);
      if (!scene) return scene.errors();
      now_doing("drawing six views");
      paste(quick_look(*scene, preset.film.time(frame), size), column * (size[0] + kGap),
            row * (size[1] + kGap), sheet);
      tell(
          fmt::format("row {}, {}: --set /scene/camera/compose/light={} --set /scene/camera/compose/third={}",
                      row + 1, third, light, third));
    }
  return sheet;
}

}  // namespace

void look(const LookArguments& arguments) {
  Heartbeat heartbeat;
  Preset preset = or_fail(load_preset(arguments.preset), kWrongInput);
  const Film& film = preset.film;
  int frame = or_fail(read_frame(arguments.frame, film.frames), kWrongInput);
  std::string out = out_file(arguments.out, arguments.preset, arguments.views ? "_views.png" : "_look.png");
  if (!out.ends_with(".png"))
    fail({error_at("--out", "{} has no known extension; expected .png", out)}, kWrongInput);
  or_fail(refuse_file(out), kCouldNot);
  tell_notes(preset.notes);
  auto save = [&](const Raster& picture) {
    or_fail(write_file(out, or_fail(png_text(picture), kCouldNot)), kCouldNot);
  };
  if (arguments.views) {
    save(or_fail(composed_views(preset, frame), kWrongInput));
    put(out + "\n");
    return;
  }
  now_doing("growing what stands in the scene");
  Scene scene = or_fail(build_scene(preset), kWrongInput);
  for (const std::string& note : scene.notes) tell(note);
  now_doing("drawing what the camera sees");
  save(quick_look(scene, film.time(frame)));
  std::vector<GrownSize> sizes = or_fail(sizes_of(scene, preset, film.time(frame)), kCouldNot);
  for (const std::string& line : sizes_lines(sizes)) tell(line);
  put(out + "\n");
}

}  // namespace frond
