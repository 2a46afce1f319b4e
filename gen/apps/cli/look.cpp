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

int look(const LookArguments& arguments) {
  Heartbeat heartbeat;
  Result<Preset> preset = load_preset(arguments.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  const Film& film = preset->film;
  Result<int> asked = read_frame(arguments.frame, film.frames);
  if (!asked) return fail(asked.errors(), kWrongInput);
  int frame = *asked;
  std::string out = arguments.out.empty() ? std::filesystem::path(arguments.preset.path).stem().string() +
                                                (arguments.views ? "_views.png" : "_look.png")
                                          : arguments.out;
  if (!out.ends_with(".png"))
    return fail({Error{"--out", fmt::format("{} has no known extension; expected .png", out)}}, kWrongInput);
  if (Errors errors = refuse_file(out); !errors.empty()) return fail(errors, kCouldNot);
  tell_notes(preset->notes);
  auto save = [&](const Raster& picture) {
    Result<std::string> png = png_text(picture);
    return png ? write_file(out, *png) : Result<bool>(png.errors());
  };
  if (arguments.views) {
    Result<Raster> sheet = composed_views(*preset, frame);
    if (!sheet) return fail(sheet.errors(), kWrongInput);
    if (Result<bool> written = save(*sheet); !written) return fail(written.errors(), kCouldNot);
    put(out + "\n");
    return kDone;
  }
  now_doing("growing what stands in the scene");
  Result<Scene> scene = build_scene(*preset);
  if (!scene) return fail(scene.errors(), kWrongInput);
  for (const std::string& note : scene->notes) tell(note);
  now_doing("drawing what the camera sees");
  if (Result<bool> written = save(quick_look(*scene, film.time(frame))); !written)
    return fail(written.errors(), kCouldNot);
  Result<std::vector<GrownSize>> sizes = sizes_of(*scene, *preset, film.time(frame));
  if (!sizes) return fail(sizes.errors(), kCouldNot);
  for (const std::string& line : sizes_lines(*sizes)) tell(line);
  put(out + "\n");
  return kDone;
}

}  // namespace frond
