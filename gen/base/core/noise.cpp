#include "core/noise.h"

#include <glm/gtc/noise.hpp>

namespace frond {

double noise(Vec3 p) { return glm::simplex(p); }

Vec3 noise3(Vec3 p) {
  return {glm::simplex(p), glm::simplex(p + Vec3(31.7f, -47.2f, 12.9f)),
          glm::simplex(p + Vec3(-19.1f, 73.4f, -58.3f))};
}

double fractal_noise(Vec3 p, int octaves) {
  double sum = 0, strength = 1;
  for (int i = 0; i < octaves; ++i, strength /= 2, p = p * 2.0f + Vec3(17.3f)) sum += strength * noise(p);
  return sum;
}

Vec3 random_shift(Seed seed, double most) {
  auto along = [&](const char* axis) { return static_cast<float>(seed.child(axis).range(-most, most)); };
  return {along("x"), along("y"), along("z")};
}

}  // namespace frond
