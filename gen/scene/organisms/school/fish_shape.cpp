#include <algorithm>
#include <cmath>
#include <functional>

#include "organisms/school/school.h"

namespace frond {

namespace {

constexpr int kRings = 22, kRound = 14;  // of the body
constexpr int kFinSteps = 12;            // along a fin
constexpr double kTailOverlap = 0.03;    // of the tail's root in the body

/// Adds a sheet of `columns` x 2 places: `edge(t, 0 root or 1 rim)`.
void add_sheet(Surface& mesh, int columns, int rows, const std::function<Vec3(double, double)>& place,
               const std::function<Vec2(double, double)>& uv) {
  auto first = static_cast<std::uint32_t>(mesh.position.size());
  for (int i = 0; i <= columns; ++i)
    for (int j = 0; j <= rows; ++j) {
      double t = static_cast<double>(i) / columns, r = static_cast<double>(j) / rows;
      mesh.position.push_back(place(t, r));
      mesh.uv.push_back(uv(t, r));
    }
  auto wide = static_cast<std::uint32_t>(rows + 1);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(columns); ++i)
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j) {
      std::uint32_t a = first + i * wide + j;
      mesh.triangle.push_back({a, a + 1, a + wide});
      mesh.triangle.push_back({a + 1, a + wide + 1, a + wide});
    }
}

/// From the side: `along` from the nose, `up` from the middle line, `out` to the left.
Vec3 place(double along, double up, double out) {
  return {static_cast<float>(out), static_cast<float>(0.5 - along), static_cast<float>(up)};
}

void add_body(Surface& mesh, const FishForm& form) {
  auto first = static_cast<std::uint32_t>(mesh.position.size());
  for (int i = 0; i <= kRings; ++i) {
    double t = static_cast<double>(i) / kRings, s = t * t * (1.6 - 0.6 * t);  // closer at the nose
    double along = kFishBody * s, half = fish_depth(form, s);
    // Behind the gills the body thins sooner than it narrows.
    double thick = half * form.width * (s < 0.25 ? 1.05 : 1.05 - 0.75 * smooth_step(0.25, 1.0, s));
    for (int k = 0; k < kRound; ++k) {
      double turn = 2 * kPi * k / kRound, c = std::cos(turn), z = std::sin(turn);
      double up = half * (z < 0 ? -1 : 1) * std::pow(std::abs(z), 0.92), out = thick * c;
      mesh.position.push_back(place(along, up, out));
      mesh.uv.push_back(fish_uv(along, up));
    }
  }
  for (std::uint32_t i = 0; i < kRings; ++i)
    for (std::uint32_t k = 0; k < kRound; ++k) {
      std::uint32_t a = first + i * kRound + k, b = first + i * kRound + (k + 1) % kRound;
      if (i > 0) mesh.triangle.push_back({a, b, a + kRound});
      mesh.triangle.push_back({b, b + kRound, a + kRound});
    }
}

/// How far the tail reaches back at a height, -1..1 of half its depth.
double tail_reach(TailShape shape, double v) {
  double a = std::abs(v);
  switch (shape) {
    case TailShape::forked:
      return 0.45 + 0.55 * std::pow(a, 1.2);
    case TailShape::lunate:
      return 0.22 + 0.78 * std::pow(a, 1.9);
    case TailShape::round:
      return 0.55 + 0.45 * std::sqrt(std::max(0.0, 1 - a * a));
    case TailShape::square:
      return 0.92;
  }
  return 1;
}

void add_fins(Surface& mesh, const FishForm& form) {
  double root = 0.5 * form.depth * form.peduncle, begin = kFishBody - kTailOverlap;
  auto tail = [&](double t, double r) {
    double v = 2 * t - 1, reach = tail_reach(form.tail, v) * (1 - begin) * r;
    double up = v * (root * 0.9 + (0.5 * form.tail_depth - root) * std::pow(r, 0.8));
    return std::pair(begin + reach, up);
  };
  auto tall = [&](double sign, double from, double to, double (*height)(const FishForm&, double)) {
    auto at = [=, &form](double t, double r) {
      double along = from + (to - from) * t, half = fish_depth(form, along / kFishBody);
      double lean = 0.06 * r * smooth_step(0.3, 1.0, t);  // its hind corner trails
      return std::pair(along + lean, sign * (0.93 * half + (0.07 * half + height(form, along)) * r));
    };
    add_sheet(
        mesh, kFinSteps, 2, [&](double t, double r) { return place(at(t, r).first, at(t, r).second, 0); },
        [&](double t, double r) { return fish_uv(at(t, r).first, at(t, r).second); });
  };
  add_sheet(
      mesh, kFinSteps, 4, [&](double t, double r) { return place(tail(t, r).first, tail(t, r).second, 0); },
      [&](double t, double r) { return fish_uv(tail(t, r).first, tail(t, r).second); });
  if (form.dorsal > 0) tall(1, form.dorsal_from, 0.75, dorsal_height);
  if (form.anal > 0) tall(-1, 0.52, 0.75, anal_height);
  // Pairs at the sides: pectoral fins behind the gills, pelvic fins below.
  for (double side : {-1.0, 1.0}) {
    auto pair = [&](double along, double up, double out, double length, double down, double spread) {
      auto at = [=](double t, double r) {
        double fan = (t - 0.5) * (0.5 + 0.9 * r), l = length * r * (1 - 0.35 * std::pow(2 * t - 1, 2));
        return place(along + l * std::cos(fan + down), up - l * std::sin(fan + down),
                     side * (out + spread * l));
      };
      // Its colours are those of fins, from a place above the back.
      add_sheet(mesh, 5, 2, at, [&](double t, double r) { return fish_uv(0.35 + 0.1 * t, 0.5 + 0.03 * r); });
    };
    double gill = fish_depth(form, 0.27), wide = gill * form.width;
    if (form.pectoral > 0) pair(0.225, -0.25 * gill, 0.92 * wide, form.pectoral, 0.35, 0.55);
    if (form.pectoral > 0) pair(0.27, -0.93 * gill, 0.12 * wide, 0.75 * form.pectoral, 0.75, 0.25);
  }
}

/// Bends the fish aside: a wave that runs down its body and grows toward the tail (Videler 1993), and a bow.
void bend_fish(Surface& mesh, double phase, double bend) {
  for (Vec3& p : mesh.position) {
    double s = 0.5 - p.y;
    double swing = 0.012 - 0.055 * s + 0.125 * s * s;
    double wave = swing * std::sin(2 * kPi * (0.95 * s - phase));
    double bow = bend * 0.16 * (s - 0.3) * (s - 0.3);
    p.x += static_cast<float>(wave + bow);
  }
}

}  // namespace

Surface fish_surface(const FishForm& form, double phase, double bend) {
  Surface mesh;
  add_body(mesh, form);
  add_fins(mesh, form);
  bend_fish(mesh, phase, bend);
  set_normals(mesh);
  return mesh;
}

std::vector<Prototype> fish_prototypes(const FishParams& fish) {
  std::vector<Prototype> list;
  std::string picture = fish_picture_name(fish.form, fish.look);
  for (int bend = 0; bend < kTailBends; ++bend)
    for (int phase = 0; phase < kTailPhases; ++phase) {
      Prototype made{"fish", {}, {fish.look.flank}, fish.look.back};
      Surface shape = fish_surface(fish.form, static_cast<double>(phase) / kTailPhases, bend - 1.0);
      made.parts.push_back({Tissue::leaf, std::move(shape), {picture}});
      made.luster = Luster{0.12, 0.9 * fish.look.gloss, 0.3 * fish.look.scales};
      list.push_back(std::move(made));
    }
  return list;
}

Organs school_organs(const SchoolParams& params, const Trajectory& trajectory, double time) {
  Organs organs;
  organs.reserve(static_cast<std::size_t>(trajectory.count));
  for (int i = 0; i < trajectory.count; ++i) {
    FishPose pose = fish_at(trajectory, i, time);
    float beats = pose.stroke - std::floor(pose.stroke);
    int phase = static_cast<int>(beats * kTailPhases + 0.5f) % kTailPhases;
    int bend = pose.turn > 0.7f ? 2 : pose.turn < -0.7f ? 0 : 1;
    Vec3 ahead = pose.heading, side = glm::cross(ahead, Vec3(0, 1, 0));
    side = glm::length(side) > 1e-4f ? glm::normalize(side) : Vec3(1, 0, 0);
    // It leans into its turns.
    float bank = std::clamp(-0.25f * pose.turn, -0.5f, 0.5f);
    glm::mat3 axes(side, ahead, glm::cross(side, ahead));
    Quat turn = glm::normalize(glm::angleAxis(bank, ahead) * glm::quat_cast(axes));
    float length = static_cast<float>(params.fish.length) * pose.size;
    organs.prototype.push_back(static_cast<std::uint16_t>(bend * kTailPhases + phase));
    organs.position.push_back(pose.position);
    organs.turn.push_back(turn);
    organs.scale.push_back(Vec3(length));
    organs.node.push_back(Skeleton::kRoot);
    organs.birth.push_back(0);
    organs.color.push_back(0);
    organs.id.push_back(0);  // all of one shade: after the film each takes another's place
  }
  return organs;
}

}  // namespace frond
