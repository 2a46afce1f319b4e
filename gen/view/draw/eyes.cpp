#include "draw/eyes.h"

#include <algorithm>
#include <cmath>

#include "core/bounds.h"
#include "core/parallel.h"
#include "draw/organs.h"

namespace frond {

namespace {

constexpr double kNearest = 0.05;  // metres from which an eye sees what it is inside of

/// Metres from the places of organs that they reach.
double organ_reach(const Model& model) {
  float most = 0;
  for (const Prototype& prototype : model.prototypes) most = std::max(most, reach_of(prototype));
  return static_cast<double>(most * largest_scale(model.organs));
}

/// Number `i` of the sequence of van der Corput in a base, 0..1.
double radical_inverse(int i, int base) {
  double share = 1, sum = 0;
  for (; i > 0; i /= base) share /= base, sum += share * (i % base);
  return sum;
}

}  // namespace

Eye eye_at(const Film& film, const Camera& camera, double time) {
  double half = std::tan(radians(camera.angle.at(time)) / 2);
  return eye_toward(camera.location.at(time), camera.look_at.at(time), half, half * film.aspect(),
                    2 * half / film.size[0]);
}

Vec2 sample_shift(const Film& film, int frame) {
  constexpr int kRound = 1024;  // frames, after which the places come again
  if (!film.raw || film.frames == 1) return Vec2(0);
  int i = frame % kRound + 1;
  return {radical_inverse(i, 2) - 0.5, radical_inverse(i, 3) - 0.5};
}

std::vector<Eye> eyes(const Film& film, const Camera& camera) {
  std::vector<Eye> list;
  for (int frame = 1; frame <= film.frames; ++frame) list.push_back(eye_at(film, camera, film.time(frame)));
  return list;
}

std::vector<Eye> different_eyes(const Scene& scene) {
  std::vector<Eye> list = eyes(scene);
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

double nearest_pixel(const std::vector<Eye>& eyes, Vec3 at, double reach, double unseen) {
  double least = 1e30;
  for (const Eye& eye : eyes) {
    double away = std::max(kNearest, static_cast<double>(glm::distance(eye.at, at)) - reach);
    least = std::min(least, away * eye.pixel * (unseen == 1 || in_view(eye, at, reach) ? 1 : unseen));
  }
  return least;
}

std::vector<double> nearest_pixels(const Scene& scene) {
  constexpr std::size_t kMost = 10'000;  // places that are looked at
  constexpr int kSwum = 4;               // frames
  std::vector<Eye> all = different_eyes(scene);
  std::vector<double> pixels(scene.specimens.size(), 0);
  parallel_for(pixels.size(), [&](std::size_t i) {
    const Specimen& b = scene.specimens[i];
    Bounds box = bounds_of(b.model);
    double least = 1e30, rough = glm::length(box.size()) / 60 + organ_reach(b.model);
    auto look_at = [&](const std::vector<Vec3>& places) {
      for (std::size_t k = 0; k < places.size(); k += 1 + places.size() / kMost)
        least = std::min(least, nearest_pixel(all, places[k], rough));
    };
    if (box.empty()) return;
    if (b.model.solids.size() > 0) least = nearest_pixel(all, box.middle(), glm::length(box.size()) / 2);
    look_at(b.model.skeleton.position);
    look_at(fallen_nodes(b));
    look_at(b.model.blades.surface.position);
    if (b.model.skeleton.size() == 0) look_at(b.model.organs.position);
    // A school swims elsewhere at each time.
    for (int frame = 1; b.life.develop && b.model.skeleton.size() == 0 && b.model.organs.size() > 0 &&
                        frame <= scene.film.frames;
         frame += kSwum)
      if (auto now = developed(b, scene.film.time(frame))) look_at((*now)->model.organs.position);
    pixels[i] = least < 1e29 ? least : 0;
  });
  return pixels;
}

}  // namespace frond
