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
  constexpr double kGills = 0.25;                     // where they end, as a share of the body
  constexpr double kThickness = 1.05, kThins = 0.75;  // of FishForm::width: at the gills, less at the tail
  constexpr double kRoundness = 0.92;                 // power of the height: 1 makes the rings ellipses
  auto first = static_cast<std::uint32_t>(mesh.position.size());
  for (int i = 0; i <= kRings; ++i) {
    double t = static_cast<double>(i) / kRings, s = t * t * (1.6 - 0.6 * t);  // closer at the nose
    double along = kFishBody * s, half = fish_depth(form, s);
    // Behind the gills the body thins sooner than it narrows.
    double thick =
        half * form.width * (s < kGills ? kThickness : kThickness - kThins * smooth_step(kGills, 1.0, s));
    for (int k = 0; k < kRound; ++k) {
      double turn = 2 * kPi * k / kRound, c = std::cos(turn), z = std::sin(turn);
      double up = half * (z < 0 ? -1 : 1) * std::pow(std::abs(z), kRoundness), out = thick * c;
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

/// How far the tail reaches back at a height, -1..1 of half its depth, as a share of its length. Hollow tails
/// reach from the first number in the middle to 1 at the corners, a round one the other way.
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

/// A fin of a pair at the sides. Its root is at a share of the fish's length from the nose, up and out by
/// shares of half the depth and half the width that the body has behind the gills.
struct SideFin {
  double along, up, out;
  double length;  // as a share of FishForm::pectoral
  double down;    // radians that it points below straight back
  double spread;  // how far it stands off the body, as a share of its length
};

constexpr SideFin kPectoral{0.225, -0.25, 0.92, 1, 0.35, 0.55}, kPelvic{0.27, -0.93, 0.12, 0.75, 0.75, 0.25};

/// Adds it to a side, -1 or 1.
void add_side_fin(Surface& mesh, const FishForm& form, const SideFin& fin, double side) {
  constexpr double kBehindGills = 0.27;             // as a share of the body
  constexpr double kRootFan = 0.5, kFansOut = 0.9;  // radians between its edges, and how many more at its rim
  constexpr double kEdgesShorter = 0.35;            // than its middle, as a share of it
  double gill = fish_depth(form, kBehindGills), wide = gill * form.width;
  double up = fin.up * gill, out = fin.out * wide, length = fin.length * form.pectoral;
  auto at = [=](double t, double r) {
    double fan = (t - 0.5) * (kRootFan + kFansOut * r),
           l = length * r * (1 - kEdgesShorter * std::pow(2 * t - 1, 2));
    return place(fin.along + l * std::cos(fan + fin.down), up - l * std::sin(fan + fin.down),
                 side * (out + fin.spread * l));
  };
  // Its colours are those of fins, from a place above the back.
  add_sheet(mesh, 5, 2, at, [&](double t, double r) { return fish_uv(0.35 + 0.1 * t, 0.5 + 0.03 * r); });
}

void add_fins(Surface& mesh, const FishForm& form) {
  constexpr double kTailRoot = 0.9, kTailOpens = 0.8;  // of the body's depth; power of the way back
  constexpr double kTrails = 0.06;  // of the fish's length, by which a fin's hind corner lies behind its root
  // Where fins of the back and the belly begin and end, as dorsal_height and anal_height have it.
  constexpr double kDorsalEnd = 0.75, kAnalBegin = 0.52, kAnalEnd = 0.75;
  double root = 0.5 * form.depth * form.peduncle, begin = kFishBody - kTailOverlap;
  auto tail = [&](double t, double r) {
    double v = 2 * t - 1, reach = tail_reach(form.tail, v) * (1 - begin) * r;
    double up = v * (root * kTailRoot + (0.5 * form.tail_depth - root) * std::pow(r, kTailOpens));
    return std::pair(begin + reach, up);
  };
  auto tall = [&](double sign, double from, double to, double (*height)(const FishForm&, double)) {
    auto at = [=, &form](double t, double r) {
      double along = from + (to - from) * t, half = fish_depth(form, along / kFishBody);
      double lean = kTrails * r * smooth_step(0.3, 1.0, t);
      // Its root is within the body.
      return std::pair(along + lean, sign * (0.93 * half + (0.07 * half + height(form, along)) * r));
    };
    add_sheet(
        mesh, kFinSteps, 2, [&](double t, double r) { return place(at(t, r).first, at(t, r).second, 0); },
        [&](double t, double r) { return fish_uv(at(t, r).first, at(t, r).second); });
  };
  add_sheet(
      mesh, kFinSteps, 4, [&](double t, double r) { return place(tail(t, r).first, tail(t, r).second, 0); },
      [&](double t, double r) { return fish_uv(tail(t, r).first, tail(t, r).second); });
  if (form.dorsal > 0) tall(1, form.dorsal_from, kDorsalEnd, dorsal_height);
  if (form.anal > 0) tall(-1, kAnalBegin, kAnalEnd, anal_height);
  if (form.pectoral > 0)
    for (double side : {-1.0, 1.0})
      for (const SideFin& fin : {kPectoral, kPelvic}) add_side_fin(mesh, form, fin, side);
}

/// Bends the fish aside: a wave that runs down its body and grows toward the tail (Videler 1993), and a bow.
/// Lengths are shares of the fish's; it swings least a fifth behind its nose.
void bend_fish(Surface& mesh, double phase, double bend) {
  constexpr double kWaves = 0.95;                  // on its length at a time
  constexpr double kBow = 0.16, kBowMiddle = 0.3;  // coefficient of the parabola; its vertex from the nose
  for (Vec3& p : mesh.position) {
    double s = 0.5 - p.y;
    double swing = 0.012 - 0.055 * s + 0.125 * s * s;
    double wave = swing * std::sin(2 * kPi * (kWaves * s - phase));
    double bow = bend * kBow * (s - kBowMiddle) * (s - kBowMiddle);
    p.x += static_cast<float>(wave + bow);
  }
}

/// The shape of a fish, one unit long, its nose toward +y, its back toward +z, at a phase of its beat (0..1)
/// and bent sideways by `bend` (-1 right .. 1 left).
Surface fish_surface(const FishForm& form, double phase, double bend) {
  Surface mesh;
  add_body(mesh, form);
  add_fins(mesh, form);
  bend_fish(mesh, phase, bend);
  set_normals(mesh);
  return mesh;
}

}  // namespace

std::vector<Prototype> fish_prototypes(const FishParams& fish) {
  std::vector<Prototype> list;
  std::string picture = fish_picture_name(fish.form, fish.look);
  for (int bend = 0; bend < kTailBends; ++bend)
    for (int phase = 0; phase < kTailPhases; ++phase) {
      Prototype made{"fish", {}, {fish.look.flank}, fish.look.back};
      Surface shape = fish_surface(fish.form, static_cast<double>(phase) / kTailPhases, bend - 1.0);
      made.parts.push_back({Tissue::leaf, std::move(shape), {picture}});
      made.luster = {.through = 0.12, .gloss = 0.9 * fish.look.gloss, .relief = 0.3 * fish.look.scales};
      list.push_back(std::move(made));
    }
  return list;
}

Organs school_organs(const SchoolParams& params, const Trajectory& trajectory, double time) {
  constexpr float kTurns = 0.7f;                    // radians a second from which its body is bent
  constexpr float kBank = 0.25f, kMostBank = 0.5f;  // radians it leans by, for one a second of turn; at most
  Organs organs;
  organs.reserve(static_cast<std::size_t>(trajectory.count));
  for (int i = 0; i < trajectory.count; ++i) {
    FishPose pose = fish_at(trajectory, i, time);
    float beats = pose.stroke - std::floor(pose.stroke);
    int phase = static_cast<int>(beats * kTailPhases + 0.5f) % kTailPhases;
    int bend = pose.turn > kTurns ? 2 : pose.turn < -kTurns ? 0 : 1;
    Vec3 ahead = pose.heading, side = glm::cross(ahead, Vec3(0, 1, 0));
    side = glm::length(side) > 1e-4f ? glm::normalize(side) : Vec3(1, 0, 0);
    // It leans into its turns.
    float bank = std::clamp(-kBank * pose.turn, -kMostBank, kMostBank);
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
