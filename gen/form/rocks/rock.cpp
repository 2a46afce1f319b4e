#include "rocks/rock.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/joined_sets.h"
#include "core/noise.h"
#include "core/parallel.h"

namespace frond {

namespace {

constexpr int kTries = 24;
constexpr std::size_t kVerticesATask = 2048;

/// Where the blobs' space lies in metres.
struct Frame {
  DVec3 foot{0};    // in the blobs' space
  double unit = 1;  // metres one of its units makes
};

Frame frame_of(const RockShape& shape, const Box& box) {
  DVec3 size = box.size(), middle = box.middle();
  return {{middle.x, box.low.y, middle.z}, shape.size / std::max(size.x, std::max(size.y, size.z))};
}

/// The blobs turned so that the axis of their shortest side is upright. x, y and z change places in turn, so
/// that the shape is not mirrored.
Blobs laid(const Blobs& blobs) {
  DVec3 size = field_bounds(blobs).size();
  int shortest = size.x < size.y ? (size.x < size.z ? 0 : 2) : (size.y < size.z ? 1 : 2);
  Blobs turned = blobs;
  for (std::size_t i = 0; i < blobs.blobs.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      int from = (axis + shortest + 2) % 3;
      turned.blobs[i].radius[axis] = blobs.blobs[i].radius[from];
      turned.blobs[i].center[axis] = blobs.blobs[i].center[from];
    }
  return turned;
}

Vec3 random_direction(Seed seed) {
  double y = seed.child("y").range(-1, 1), turn = seed.child("turn").range(0, 2 * kPi),
         r = std::sqrt(1 - y * y);
  return Vec3(r * std::cos(turn), y, r * std::sin(turn));
}

/// 0 well below 0, x well above, and round over `soft` either way.
float soft_excess(float x, float soft) {
  assert(soft >= 0);
  if (x <= -soft) return 0;
  if (x >= soft) return x;
  return (x + soft) * (x + soft) / (4 * soft);
}

/// Breaks pieces off: what lies beyond a plane is pressed onto it.
void break_off(Surface& rock, const RockShape& shape, Seed seed) {
  const Weathering& w = shape.weathering;
  float soft = static_cast<float>((0.004 + 0.12 * w.edge) * shape.size);
  Vec3 middle(0);
  for (const Vec3& p : rock.position) middle += p / static_cast<float>(rock.position.size());
  for (int i = 0; i < w.facets; ++i) {
    Seed own = seed.child("facet", i);
    Vec3 n = random_direction(own);
    float reach = 0;
    for (const Vec3& p : rock.position) reach = std::max(reach, glm::dot(p - middle, n));
    float plane = reach * static_cast<float>(1 - w.facet_depth * own.child("depth").range(0.25, 1));
    for (Vec3& p : rock.position) p -= n * soft_excess(glm::dot(p - middle, n) - plane, soft);
  }
}

/// How far soft layers lie back at a place, as a share of the thickness of a layer.
double recess(const Vec3& p, const Vec3& up, double thickness, double size, Vec3 shift, Seed seed) {
  Vec3 q = p / static_cast<float>(size) + shift;
  double t = glm::dot(p, up) / thickness + 0.45 * noise(q * 1.6f) + 0.12 * noise(q * 7.0f);
  double layer = std::floor(t), part = t - layer;
  auto soft = [&](double number) {
    return seed.child("layer", static_cast<std::int64_t>(number) + 100000).unit();
  };
  double own = soft(layer), below = soft(layer - 1);
  double depth = below + (own - below) * smooth_step(0.0, 0.22, part);
  // A joint between two layers weathers out.
  return depth + 0.35 * (1 - smooth_step(0.0, 0.13, std::min(part, 1 - part)));
}

/// Layers and noise, each along the normal.
void wear(Surface& rock, const RockShape& shape, Seed seed) {
  assert(rock.normal.size() == rock.position.size());
  const Weathering& w = shape.weathering;
  Vec3 shift = random_shift(seed, 50);
  double toward = seed.child("dip").range(0, 2 * kPi), sine = std::sin(w.dip);
  Vec3 up(sine * std::cos(toward), std::cos(w.dip), sine * std::sin(toward));
  float size = static_cast<float>(shape.size);
  Seed layers = seed.child("strata");
  parallel_for((rock.position.size() + kVerticesATask - 1) / kVerticesATask, [&](std::size_t share) {
    for (std::size_t i = share * kVerticesATask;
         i < std::min((share + 1) * kVerticesATask, rock.position.size()); ++i) {
      Vec3 p = rock.position[i], n = rock.normal[i], q = p / size + shift;
      if (w.roughness > 0) {
        double lumps = 0.045 * fractal_noise(q * 1.9f, 2);
        double dents = 0.020 * (0.4 - std::abs(noise(q * 5.1f))) + 0.010 * (0.4 - std::abs(noise(q * 11.0f)));
        double grain = 0.0035 * fractal_noise(q * 26.0f, 2);
        rock.position[i] += n * static_cast<float>(w.roughness * shape.size * 2 * (lumps + dents + grain));
      }
      if (w.strata > 0) {
        Vec3 out = n - up * glm::dot(n, up);
        double back =
            w.strata * w.layer * shape.size * recess(p, up, w.layer * shape.size, shape.size, shift, layers);
        rock.position[i] -= out * static_cast<float>(back);
      }
    }
  });
}

/// Cuts the rock flat below and puts the cut at y = 0.
void cut_underside(Surface& rock, const RockShape& shape) {
  assert(!rock.position.empty());
  float low = rock.position[0].y, high = low;
  for (const Vec3& p : rock.position) low = std::min(low, p.y), high = std::max(high, p.y);
  float cut = low + static_cast<float>(shape.weathering.underside) * (high - low);
  float soft = static_cast<float>(0.03 * shape.size);
  for (Vec3& p : rock.position) p.y = soft_excess(p.y - cut, soft);
}

bool weathered(const Weathering& w) {
  return (w.facets > 0 && w.facet_depth > 0) || w.roughness > 0 || w.strata > 0 || w.underside > 0;
}

}  // namespace

int count_pieces(const Surface& surface) {
  JoinedSets joined(surface.position.size());
  for (auto [a, b, c] : surface.triangle) joined.join(a, b), joined.join(b, c);
  int pieces = 0;
  for (std::uint32_t v = 0; v < surface.position.size(); ++v) pieces += joined.top(v) == v;
  return pieces;
}

Blobs rock_blobs(const RockShape& shape, Seed seed) {
  Blobs blobs{shape.own, shape.falloff, shape.level};
  for (std::uint64_t i = 0; shape.own.empty() && i <= kTries; ++i) {
    // The last is the first again.
    blobs.blobs = random_blobs(shape.chance, seed.child("blobs", i % kTries));
    if (i < kTries && count_pieces(blob_surface(blobs, {4, 0.01})) == 1) break;
  }
  return shape.lying ? laid(blobs) : blobs;
}

Surface bare_rock(const RockShape& shape, const Blobs& blobs) {
  assert(shape.size > 0);
  Surface rock = blob_surface(blobs, shape.cells);
  Frame frame = frame_of(shape, field_bounds(blobs));
  for (Vec3& p : rock.position) p = (DVec3(p) - frame.foot) * frame.unit;
  return rock;
}

Isosurface native_rock(const RockShape& shape, const Blobs& blobs) {
  Box box = field_bounds(blobs);
  Frame frame = frame_of(shape, box);
  // A little wider, so that the surface does not touch its box.
  DVec3 more = box.size() * 0.02;
  box = {box.low - more, box.high + more};
  return {blobs, box, field_steepest(blobs, box), frame.foot, frame.unit};
}

Surface rock_surface(const RockShape& shape, Seed seed) {
  if (shape.form != RockForm::blobs) {
    FrameworkCells cells{std::exp2(-shape.cells.depth), shape.cells.tolerance};
    auto make = shape.form == RockForm::rubble ? rubble_surface : framework_surface;
    return make(shape.framework, shape.size, cells, seed);
  }
  Surface rock = bare_rock(shape, rock_blobs(shape, seed));
  if (rock.position.empty() || !weathered(shape.weathering)) return rock;
  if (shape.weathering.facet_depth > 0) break_off(rock, shape, seed);
  set_normals(rock);
  wear(rock, shape, seed.child("wear"));
  cut_underside(rock, shape);
  set_normals(rock);
  return rock;
}

}  // namespace frond
