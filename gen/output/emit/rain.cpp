#include "emit/rain.h"

#include <fmt/format.h>

#include "core/text.h"
#include "draw/eyes.h"
#include "draw/rain.h"
#include "emit/setting_parts.h"
#include "emit/streaks.h"
#include "model/wetness.h"
#include "settings/settings.h"

namespace frond {

std::string rain_text(const Scene& scene, double time) {
  if (!is_rainy(scene.setup)) return {};
  SceneSetup now = setup_at(scene.setup, time);
  std::string text = fmt::format("#declare Frond_Wet = {};\n", number_text(wet_share(now)));
  for (const WettingRow& row : kWettings)
    text += fmt::format("#declare {} = texture{{Rain_Film({},{})}}\n", row.texture,
                        vector_text(wet_colors(row)), number_text(row.film));
  RingField rings = ring_field(now.rain->rate.at(0), scene.film);
  text += fmt::format("#declare Frond_Rings = array[4]{{{},{},{},{}}};\n", number_text(rings.layers),
                      number_text(rings.cell), number_text(rings.life), number_text(rings.share));
  Eye eye = eye_at(scene, time);
  text += fmt::format("#declare Frond_Rings_Eye = array[4]{{{},{},{},{}}};\n", number_text(eye.at.x),
                      number_text(eye.at.y), number_text(eye.at.z), number_text(eye.pixel));
  if (double mist = now.rain->mist.at(0); mist > 0) {
    Vec3 from = scene.setup.camera.look_at.at(0);
    text += fmt::format("Rain_Mist({},{},{})\n", vector_text(drawn_daylight(now).fog), number_text(mist),
                        number_text(static_cast<double>(scene.ground->height({from.x, from.z}))));
  }
  return text;
}

namespace {

/// A drop is as bright as what it gathers from a wide part of the sky (Garg and Nayar 2007).
Vec3 drop_light(const Daylight& light) { return 0.9f * (0.7f * light.above + 0.3f * light.aside); }

}  // namespace

std::string streaks_text(const PovSpace& space, const Scene& scene, double time) {
  std::vector<Streak> streaks = rain_streaks(scene, time);
  if (streaks.empty()) return {};
  return streak_mesh_text(space, streaks, scene.setup.camera.location.at(time), StreakEnd::cut, "Rain_Streak",
                          drop_light(drawn_daylight(setup_at(scene.setup, time))));
}

}  // namespace frond
