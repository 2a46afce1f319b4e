#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/bounds.h"
#include "core/linear.h"
#include "core/parallel.h"
#include "draw/draw_list.h"
#include "light/light.h"

// What stands in a scene as bits of surface, for whom they are enough.

namespace frond {

/// Calls `bit(at, area, facing)` for points all over a triangle, none more than `step` wide.
template <class Bit>
void each_bit(const std::array<Vec3, 3>& corner, float step, const Bit& bit) {
  Vec3 cross = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  float twice = glm::length(cross);
  if (!(twice > 0)) return;
  int count = static_cast<int>(std::clamp(0.5f * twice / (step * step), 1.0f, 1e5f));
  Facing ways = facing(cross / twice);
  for (int i = 0; i < count; ++i) {
    // A lattice of good spread (Roberts), folded into the triangle.
    double u = 0.5 + 0.7548776662466927 * i, v = 0.5 + 0.5698402909980532 * i;
    auto a = static_cast<float>(u - std::floor(u)), b = static_cast<float>(v - std::floor(v));
    if (a + b > 1) a = 1 - a, b = 1 - b;
    if (count == 1) a = b = 1.0f / 3;
    bit(corner[0] + a * (corner[1] - corner[0]) + b * (corner[2] - corner[0]),
        0.5f * twice / static_cast<float>(count), ways);
  }
}

/// Twice what triangles hide of what is behind them, in the mean of all directions: the area of leaves that
/// lie apart; less where they overlap, and half of its skin for a body.
float apart_area(const std::vector<std::array<Vec3, 3>>& triangles);

/// What bits go to: `add(at, area, albedo, facing, bulk)` as to SoftLight, and `step(at)`, how fine they are
/// to be there: a bit of a body or an organ is not much smaller than a step is wide.
template <class Sink>
struct SurfelSampler {
  const Sink& sink;

  void skeleton(const Skeleton& s, const std::vector<Vec3>& position, const std::vector<float>& radius,
                const BranchLook& look, const Model& model) const {
    const Vec3 own = look.albedo();
    parallel_for((s.size() + 1023) / 1024, [&](std::size_t part) {
      for (std::size_t i = part * 1024; i < std::min(s.size(), (part + 1) * 1024); ++i) {
        std::int32_t parent = s.parent[i];
        if (parent < 0) continue;
        Vec3 from = position[static_cast<std::size_t>(parent)], offset = position[i] - from;
        float length = glm::length(offset), r = radius[i];
        if (!(length > 0) || !(r > 0)) continue;
        const Vec3 albedo = look.others.empty() ? own : look.albedo_at(model, static_cast<std::int32_t>(i));
        float step = sink.step(from);
        int along = static_cast<int>(std::clamp(std::ceil(length / step), 1.0f, 1e4f));
        int round = r > 0.7f * step ? static_cast<int>(std::min(std::ceil(6.2832f * r / step), 256.0f)) : 1;
        Vec3 ahead = offset / length;
        Vec3 side = glm::normalize(glm::cross(ahead, reference_axis(ahead)));
        Vec3 other = glm::cross(ahead, side);
        float area = 6.2832f * r * length / static_cast<float>(along * round);
        for (int k = 0; k < along; ++k) {
          Vec3 at = from + offset * ((static_cast<float>(k) + 0.5f) / static_cast<float>(along));
          if (round == 1) {
            sink.add(at, area, albedo, kAllFacings, 2 * r);
            continue;
          }
          for (int q = 0; q < round; ++q) {
            float turn = 6.2832f * static_cast<float>(q) / static_cast<float>(round);
            Vec3 out = std::cos(turn) * side + std::sin(turn) * other;
            sink.add(at + r * out, area, albedo, facing(out), 2 * r);
          }
        }
      }
    });
  }

  void surface(const Surface& surface, Vec3 albedo, bool solid, Vec3 at = Vec3(0),
               Quat turn = Quat(1, 0, 0, 0), Vec3 scale = Vec3(1)) const {
    float bulk = 0;
    if (solid) {
      Bounds box = bounds_of(surface.position);
      bulk = glm::length(scale * (box.high - box.low));
    }
    parallel_for((surface.triangle.size() + 1023) / 1024, [&](std::size_t part) {
      for (std::size_t i = part * 1024; i < std::min(surface.triangle.size(), (part + 1) * 1024); ++i) {
        std::array<Vec3, 3> corner;
        for (std::size_t c = 0; c < 3; ++c)
          corner[c] = at + turn * (scale * surface.position[surface.triangle[i][c]]);
        each_bit(corner, sink.step(corner[0]), [&](Vec3 where, float area, Facing ways) {
          sink.add(where, area, albedo, solid ? ways : kAllFacings, bulk);
        });
      }
    });
  }

  void strewn(const std::vector<ScatteredInstances>& list) const {
    for (const ScatteredInstances& kind : list)
      for (const ScatteredInstances::At& at : kind.at)
        surface(*kind.shape, linear(kind.color), true, at.place, at.turn, at.size);
  }

  void bodies(const std::vector<DrawnBody>& bodies) const {
    for (const DrawnBody& body : bodies) {
      PlainLook look = plain_look(body.solid->material);
      for (const OrganPlace& place : body.places)
        surface(body.surface(), linear(look.color), look.opacity == 1, place.at, place.turn, place.scale);
    }
  }

  void organs(const std::vector<Prototype>& prototypes, const DrawnOrgans& organs) const {
    std::vector<Part> parts;
    for (const Prototype& prototype : prototypes) {
      Part part;
      part.shape = &prototype;
      std::vector<std::array<Vec3, 3>> triangles;
      for (const OrganPart& p : prototype.parts) {
        for (const auto& t : p.surface.triangle) {
          Vec3 a = p.surface.position[t[0]], b = p.surface.position[t[1]], c = p.surface.position[t[2]];
          float area = 0.5f * glm::length(glm::cross(b - a, c - a));
          part.area += area;
          part.bits.emplace_back((a + b + c) / 3.0f, part.area);
          part.middle += area * part.bits.back().first;
          triangles.push_back({a, b, c});
        }
      }
      if (part.area > 0) {
        part.middle /= part.area;
        float apart = std::min(1.0f, apart_area(triangles) / part.area);
        for (auto& bit : part.bits) bit.second *= apart;
        part.area *= apart, part.apart = apart;
      }
      parts.push_back(std::move(part));
    }
    for (const OrganGroup& group : organs.groups) {
      const Part& part = parts[group.prototype];
      Vec3 albedo = linear(group.tint);
      std::span<const OrganPlace> places = organs.places(group);
      parallel_for((places.size() + 1023) / 1024, [&](std::size_t some) {
        for (const OrganPlace& place :
             places.subspan(some * 1024, std::min<std::size_t>(1024, places.size() - some * 1024)))
          organ(part, place, albedo);
      });
    }
  }

 private:
  /// An organ of one unit: bits, each with the area of all up to and with it.
  struct Part {
    const Prototype* shape = nullptr;
    float apart = 1;  ///< share of its triangles' area that counts
    std::vector<std::pair<Vec3, float>> bits;
    Vec3 middle{0};
    float area = 0;
  };

  void organ(const Part& part, const OrganPlace& place, Vec3 albedo) const {
    float wide = std::cbrt(place.scale.x * place.scale.y * place.scale.z), area = std::pow(wide, 2.0f);
    float step = sink.step(place.at);
    if (wide < 1.5f * step || part.bits.size() < 2) {
      sink.add(place.at + place.turn * (place.scale * part.middle), area * part.area, albedo, kAllFacings, 0);
      return;
    }
    constexpr std::size_t kCoarse = 4;  // bits that a triangle should be, from which it is more than one
    auto wanted = static_cast<std::size_t>(std::min(area * part.area / (step * step), 1e6f)) + 1;
    if (wanted > kCoarse * part.bits.size()) {  // as of a fish that is near
      for (const OrganPart& p : part.shape->parts)
        for (const auto& t : p.surface.triangle) {
          std::array<Vec3, 3> corner;
          for (std::size_t c = 0; c < 3; ++c)
            corner[c] = place.at + place.turn * (place.scale * p.surface.position[t[c]]);
          each_bit(corner, step, [&](Vec3 where, float bit_area, Facing) {
            sink.add(where, part.apart * bit_area, albedo, kAllFacings, 0);
          });
        }
      return;
    }
    // One bit of a run stands for all of it.
    float before = 0;
    std::size_t each = std::max<std::size_t>(part.bits.size() / wanted, 1);
    for (std::size_t k = 0; k < part.bits.size(); k += each) {
      std::size_t last = std::min(k + each, part.bits.size()) - 1;
      float upto = part.bits[last].second;
      sink.add(place.at + place.turn * (place.scale * part.bits[(k + last) / 2].first),
               area * (upto - before), albedo, kAllFacings, 0);
      before = upto;
    }
  }
};

/// All that is drawn of an organism.
template <class Sink>
void sample_surfels(const Sink& sink, const DrawList& drawn) {
  SurfelSampler<Sink> to{sink};
  const Pose& pose = drawn.pose;
  to.skeleton(drawn.model.skeleton, pose.position, pose.radius, drawn.traits.look.branches, drawn.model);
  to.bodies(drawn.bodies);
  to.organs(drawn.model.prototypes, drawn.organs);
  for (const DrawnBlades& blades : drawn.blades)
    to.surface(blades.surface, linear(plain_look(drawn.traits.look.blades, blades.color).color), false);
}

}  // namespace frond
