#include "rocks/blobs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <limits>

namespace frond {

namespace {

constexpr double kRounding = 1e-13;  // far above what sums of some hundred terms lose
constexpr int kBoundSteps = 5;

/// A falloff and its first two derivatives by q = d^2.
struct Fall {
  double value, slope, bend;
};

Fall fall(Falloff kind, double r, double q) {
  double t = q / (r * r), per = 1 / (r * r);
  switch (kind) {
    case Falloff::gaussian: {
      double e = std::exp(-r * q);
      return {e, -r * e, r * r * e};
    }
    case Falloff::soft:
      if (t >= 1) return {0, 0, 0};
      return {1 + t * (-22 + t * (17 - 4 * t)) / 9, (-22 + t * (34 - 12 * t)) / 9 * per,
              (34 - 24 * t) / 9 * per * per};
    case Falloff::cubic: {
      if (t >= 1) return {0, 0, 0};
      double s = 1 - t;
      return {s * s * s, -3 * s * s * per, 6 * s * per * per};
    }
  }
  return {};
}

double largest(const DVec3& v) { return std::max(v.x, std::max(v.y, v.z)); }

/// Where a box lies on one axis of a blob, in radii from its middle.
Interval span(const Blob& blob, const Box& box, int axis) {
  return {box.low[axis] / blob.radius[axis] - blob.center[axis],
          box.high[axis] / blob.radius[axis] - blob.center[axis]};
}

Interval distance2_range(const Blob& blob, const Box& box) {
  return squared(span(blob, box, 0)) + squared(span(blob, box, 1)) + squared(span(blob, box, 2));
}

/// Beyond which q a field is certainly less than `part`, which is above 0.
double reach(Falloff kind, double r, double part) {
  if (part >= 1) return 0;
  if (kind == Falloff::gaussian) return -std::log(part) / r;
  double low = 0, high = r * r;
  for (int i = 0; i < 60; ++i) {
    double q = (low + high) / 2;
    (fall(kind, r, q).value < part ? high : low) = q;
  }
  return high;
}

/// Adds to `found` what of the surface lies in `box`, to cells of 1/2^steps of it.
void collect(const Blobs& shape, const Box& box, int steps, Box& found) {
  if (!field_range(shape, box).holds(0)) return;
  // What lies within what is already known of adds nothing.
  if (glm::all(glm::greaterThanEqual(box.low, found.low)) &&
      glm::all(glm::lessThanEqual(box.high, found.high)))
    return;
  if (steps == 0) {
    found.low = glm::min(found.low, box.low);
    found.high = glm::max(found.high, box.high);
    return;
  }
  DVec3 half = box.size() * 0.5;
  for (int i = 0; i < 8; ++i) {
    DVec3 low = box.low + half * DVec3(i & 1, i >> 1 & 1, i >> 2);
    collect(shape, {low, low + half}, steps - 1, found);
  }
}

}  // namespace

double field_value(const Blobs& shape, const DVec3& p) {
  double sum = -shape.level;
  for (const Blob& blob : shape.blobs) {
    DVec3 u = p / blob.radius - blob.center;
    sum += fall(shape.falloff, largest(blob.radius), glm::dot(u, u)).value;
  }
  return sum;
}

DVec3 field_gradient(const Blobs& shape, const DVec3& p) {
  DVec3 sum(0);
  for (const Blob& blob : shape.blobs) {
    DVec3 u = p / blob.radius - blob.center;
    sum += u / blob.radius * (2 * fall(shape.falloff, largest(blob.radius), glm::dot(u, u)).slope);
  }
  return sum;
}

double field_curvature(const Blobs& shape, const DVec3& p) {
  DVec3 gradient(0);
  glm::dmat3 hessian(0.0);
  for (const Blob& blob : shape.blobs) {
    DVec3 u = p / blob.radius - blob.center, w = u / blob.radius * 2.0;
    Fall f = fall(shape.falloff, largest(blob.radius), glm::dot(u, u));
    gradient += w * f.slope;
    for (int i = 0; i < 3; ++i) {
      hessian[i] += w * (w[i] * f.bend);
      hessian[i][i] += 2 * f.slope / (blob.radius[i] * blob.radius[i]);
    }
  }
  double steep = glm::length(gradient);
  if (!(steep > 0)) return std::numeric_limits<double>::infinity();
  // What the second derivatives do in the tangent plane; its Frobenius norm is not less than the larger
  // curvature.
  DVec3 n = gradient / steep, hn = hessian * n;
  double nhn = glm::dot(n, hn), sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      double h = hessian[i][k] - n[i] * hn[k] - hn[i] * n[k] + nhn * n[i] * n[k];
      sum += h * h;
    }
  return std::sqrt(sum) / steep;
}

Interval field_range(const Blobs& shape, const Box& box) {
  Interval sum;
  for (const Blob& blob : shape.blobs) {
    Interval q = distance2_range(blob, box);
    double r = largest(blob.radius);
    sum = sum + Interval{fall(shape.falloff, r, q.high).value, fall(shape.falloff, r, q.low).value};
  }
  return widened(sum, kRounding) + -shape.level;
}

Interval field_slope_range(const Blobs& shape, const Box& box, const DVec3& direction) {
  Interval sum;
  for (const Blob& blob : shape.blobs) {
    Interval q = distance2_range(blob, box);
    double r = largest(blob.radius);
    // The slope of each falloff rises with q. How far one goes along the direction is linear in the place.
    Interval slope{fall(shape.falloff, r, q.low).slope, fall(shape.falloff, r, q.high).slope}, along;
    for (int i = 0; i < 3; ++i) along = along + span(blob, box, i) * (2 * direction[i] / blob.radius[i]);
    sum = sum + slope * along;
  }
  return widened(sum, kRounding);
}

Box field_bounds(const Blobs& shape) {
  Box all{DVec3(std::numeric_limits<double>::infinity()), DVec3(-std::numeric_limits<double>::infinity())};
  // Outside of the reach of all each term is less than its part of the level, and so is the sum.
  double part = shape.level / static_cast<double>(std::max<std::size_t>(1, shape.blobs.size()));
  assert(part > 0);
  for (const Blob& blob : shape.blobs) {
    DVec3 half = blob.radius * (std::sqrt(reach(shape.falloff, largest(blob.radius), part)) * (1 + 1e-9));
    all.low = glm::min(all.low, blob.radius * blob.center - half);
    all.high = glm::max(all.high, blob.radius * blob.center + half);
  }
  Box found{all.high, all.low};
  if (!shape.blobs.empty()) collect(shape, all, kBoundSteps, found);
  return found.low.x > found.high.x || shape.blobs.empty() ? Box{} : found;
}

double field_steepest(const Blobs& shape, const Box& box) {
  constexpr int kParts = 8;
  double most = 0;
  DVec3 width = box.size() / static_cast<double>(kParts);
  for (int i = 0; i < kParts * kParts * kParts; ++i) {
    DVec3 low = box.low + width * DVec3(i % kParts, i / kParts % kParts, i / kParts / kParts);
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      DVec3 along(0);
      along[axis] = 1;
      sum += squared(field_slope_range(shape, {low, low + width}, along)).high;
    }
    most = std::max(most, sum);
  }
  return std::sqrt(most);
}

std::vector<Blob> random_blobs(const BlobChance& chance, Seed seed) {
  assert(chance.count > 0 && chance.least_radius > 0 && chance.least_radius <= chance.most_radius);
  std::vector<Blob> blobs(static_cast<std::size_t>(chance.count));
  DVec3 box(0);
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    Seed own = seed.child("radius", i);
    for (int axis = 0; axis < 3; ++axis)
      blobs[i].radius[axis] = own.child(axis).range(chance.least_radius, chance.most_radius);
    box = glm::max(box, blobs[i].radius);
  }
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    Seed own = seed.child("center", i);
    for (int axis = 0; axis < 3; ++axis) {
      double room = box[axis] / blobs[i].radius[axis] - 1;
      blobs[i].center[axis] = own.child(axis).range(-room, room);
    }
  }
  return blobs;
}

}  // namespace frond
