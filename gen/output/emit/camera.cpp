#include "emit/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/eyes.h"
#include "draw/focus.h"

namespace frond {

namespace {

/// A lens before film 36 mm wide, for what is not in focus. POV-Ray's rays start within a circle half as wide
/// as its aperture, as measured of a point out of focus.
void append_lens(std::string& text, const PovSpace& space, const Camera& camera, Quality quality, double time,
                 std::optional<Vec3> focus) {
  text += " aperture ";
  append(text, 2 * lens_width(camera, time) * space.unit, 6);
  text += " focal_point";
  append_point(text, space, focus ? *focus : focus_of(camera, time));
  // Each of a pixel's 5, 5 or 10 samples of anti-aliasing takes so many rays through the lens, and up to the
  // second number where they differ much: a bright thing against a dark one, out of focus.
  constexpr std::string_view kLensSamples[] = {"4", "4,16 confidence 0.9 variance 1/300",
                                               "8,32 confidence 0.9 variance 1/1000"};
  text += " blur_samples ";
  text += kLensSamples[static_cast<std::size_t>(quality)];
}

/// What the camera sees, as vectors that no look_at turns back: the direction leans aside by the shift.
void append_view(std::string& text, const Film& film, const Camera& camera, double time, Vec2 shift) {
  Eye eye = eye_at(film, camera, time);
  Vec3 right = glm::cross(eye.ahead, eye.up) * static_cast<float>(2 * eye.broad),
       up = eye.up * static_cast<float>(2 * eye.tall);
  Vec3 direction = eye.ahead + right * (shift.x / static_cast<float>(film.size[0])) -
                   up * (shift.y / static_cast<float>(film.size[1]));
  for (auto [name, v] : {std::pair(" right", right), {" up", up}, {" direction", direction}}) {
    text += name;
    append_vector(text, 9, v.x, v.y, -v.z);
  }
}

/// POV-Ray draws whole blocks, so that anti-aliasing finds the same neighbours as in the whole picture.
std::string crop_text(const Film& film) {
  constexpr int kBlock = 32;  // pixels
  if (!film.crop) return {};
  auto [x, y, width, height] = *film.crop;
  auto end = [](int at, int size) { return std::min((at + kBlock - 1) / kBlock * kBlock, size); };
  return fmt::format(" +SC{} +EC{} +SR{} +ER{} (of which {},{},{}x{})", x / kBlock * kBlock + 1,
                     end(x + width, film.size[0]), y / kBlock * kBlock + 1, end(y + height, film.size[1]), x,
                     y, width, height);
}

}  // namespace

std::string mist_text(const Film& film, const SceneSetup& setup, double time) {
  if (!film.raw || !film.air) return {};
  const Air& air = *setup.air;
  return fmt::format(", with air: visibility {} m at {} m, thinning in {} m, forward {}",
                     number_text(air.visibility.at(time)), number_text(air.level), number_text(air.height),
                     number_text(air.forward));
}

std::string tone_text(const Film& film, const Camera& camera, int exposure, int exposures) {
  if (film.raw) return " +FN16; then frond resolve";
  std::string text = crop_text(film);
  if (film.transparent()) text += " +UA";
  bool developed = camera.toned() || exposures > 1;
  if (!developed && film.depth == 8) return text;
  text += " +FN16";
  if (!developed) return text;
  if (exposures > 1) text += "; exposure " + number_text(exposure) + " of " + number_text(exposures);
  if (exposure > 1) return text;
  text += "; then frond develop --highlights " + number_text(camera.highlights) + " --contrast " +
          number_text(camera.contrast);
  if (camera.saturation != 1) text += " --saturation " + number_text(camera.saturation);
  if (camera.warmth != 0) text += " --warmth " + number_text(camera.warmth);
  if (camera.vignette != 0) text += " --vignette " + number_text(camera.vignette);
  return text + (film.depth == 16 ? " --depth 16" : "");
}

std::string camera_text(const PovSpace& space, const Camera& camera, const Film& film, double time,
                        std::optional<Vec3> focus, Vec2 shift) {
  Vec3 location = camera.location.at(time), view = camera.look_at.at(time) - location;
  bool upright = std::abs(view.y) > 0.999f * glm::length(view);
  std::string text = "camera{location";
  append_point(text, space, location);
  if (shift != Vec2(0)) {
    append_view(text, film, camera, time, shift);
  } else {
    if (upright) text += " sky z";
    text += " right x*image_width/image_height angle ";
    append(text, camera.angle.at(time), 4);
    text += " look_at";
    append_point(text, space, camera.look_at.at(time));
  }
  if (camera.aperture && !film.raw) append_lens(text, space, camera, film.quality, time, focus);
  text += '}';
  return text;
}

}  // namespace frond
