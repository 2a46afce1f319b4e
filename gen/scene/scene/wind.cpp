#include "scene/wind.h"

#include "core/parallel.h"

namespace frond {

namespace {

constexpr double kGustFactor = 2.5;  // deviations by which the strongest gust of a storm exceeds its mean

/// The storms of a film.
std::vector<Gale> gales_of(const Preset& preset, double gusts) {
  std::vector<Gale> gales;
  for (const Event& event : preset.events) {
    if (event.storm <= 0) continue;
    for (const Organism& organism : preset.organisms) {
      const Perennial* years = organism.grower->perennial();
      if (auto storm = years ? years->storm_of(event) : std::nullopt) {
        gales.push_back({storm->time, storm->lasts, storm->gust / (1 + kGustFactor * gusts)});
        break;
      }
    }
  }
  return gales;
}

}  // namespace

bool in_wind(const Motion& motion, const SceneSetup& setup) {
  return setup.wind && motion.wood && motion.wave.amplitude == 0;
}

bool sown_in_wind(const Organism& organism, const Motion& motion, const SceneSetup& setup) {
  return in_wind(motion, setup) ||
         (setup.wind && organism.grower->traits().branches && motion.wave.amplitude == 0);
}

std::optional<WindField> wind_in(const Scene& scene, std::vector<Gale> gales) {
  if (!scene.setup.wind) return {};
  return wind_field(*scene.setup.wind, scene.film.loop(), scene.seed.child("wind"), std::move(gales));
}

void add_wind(Scene& scene, const Preset& preset) {
  if (!scene.setup.wind) return;
  bool filmed = preset.film.frames > 1;
  auto field = std::make_shared<const WindField>(
      *wind_in(scene, filmed ? gales_of(preset, scene.setup.wind->gusts) : std::vector<Gale>{}));
  parallel_for(scene.specimens.size(), [&](std::size_t i) {
    if (Specimen& s = scene.specimens[i]; in_wind(s.motion, scene.setup)) set_wind(s, field);
  });
  for (CopySet& set : scene.copy_sets)
    if (sown_in_wind(set.organism, set.appearance.motion, scene.setup)) set.wind = field;
}

}  // namespace frond
