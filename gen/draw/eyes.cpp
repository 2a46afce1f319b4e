#include "draw/eyes.h"

#include <cmath>

namespace frond {

Eye eye_at(const Scene& scene, double time) {
  const Camera& camera = scene.stage.camera;
  const Film& film = scene.film;
  double half = std::tan(radians(camera.angle.at(time)) / 2);
  return eye_toward(camera.location.at(time), camera.look_at.at(time), half, half * film.aspect(),
                    2 * half / film.size[0]);
}

std::vector<Eye> eyes(const Scene& scene) {
  std::vector<Eye> list;
  for (int frame = 1; frame <= scene.film.frames; ++frame)
    list.push_back(eye_at(scene, scene.film.time(frame)));
  return list;
}

}  // namespace frond
