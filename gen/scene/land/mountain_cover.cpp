#include "land/mountain_cover.h"

#include <algorithm>

#include "core/noise.h"

namespace frond {

double mountain_cover_at(const AltitudeLines& lines, const MountainPlace& place) {
  using namespace mountain_cover;
  double steep = glm::length(place.slope);
  double rough = fractal_noise(Vec3(place.at.x, 0, place.at.y) / 420.0f, 4);
  double above = place.height - lines.trees + 90 * rough;
  // Up the slope: woods, a belt of heath with grass in it, grass, then what little soil there is.
  double cover = kHeath * smooth_step(-40.0, 30.0, above) +
                 (kGrass - kHeath) * smooth_step(60.0, 320.0, above + 140 * rough) +
                 (kScree - kGrass) * smooth_step(330.0, 620.0, above + 150 * rough);
  auto toward = [&](double what, double share) { cover += (what - cover) * share; };
  // Stones come down gullies, some way into the woods.
  double gully = smooth_step(0.05, 0.22, place.hollow + 0.05 * rough);
  toward(kScree, gully * smooth_step(0.45, 0.7, steep) * smooth_step(-120.0, 160.0, above));
  toward(kRock,
         smooth_step(0.8, 1.15,
                     steep + 0.22 * rough - 0.5 * place.hollow + 0.15 * smooth_step(0.0, 500.0, above)));
  double shade =
      steep > 0 ? static_cast<double>(glm::dot(-place.slope, lines.shaded)) / std::max(steep, 0.3) : 0;
  double snow = place.height - lines.snow + 220 * shade + 1100 * place.hollow + 160 * rough;
  double held = 1 - smooth_step(0.95, 1.35, steep - 0.9 * place.hollow + 0.12 * rough);
  toward(kSnow, smooth_step(-70.0, 110.0, snow) * held);
  return cover;
}

}  // namespace frond
