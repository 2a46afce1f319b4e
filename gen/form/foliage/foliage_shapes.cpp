#include "foliage/foliage_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace frond {

namespace {

float sine_of(double angle) { return static_cast<float>(std::sin(angle)); }
float cosine_of(double angle) { return static_cast<float>(std::cos(angle)); }

/// A place on a stem: `across` to the right, `up` to the upper side, `along` toward the tip.
struct StemStation {
  Vec3 at{0}, across{1, 0, 0}, up{0, 0, 1}, along{0, 1, 0};
};

/// A stem that bends down, most toward its tip, and a little aside.
std::vector<StemStation> stem_of(double bend, double power, double aside, int pieces) {
  std::vector<StemStation> stem{{}};
  for (int i = 1; i <= pieces; ++i) {
    double t = (i - 0.5) / pieces, pitch = bend * std::pow(t, power), yaw = aside * t * t;
    StemStation next;
    Vec3 level(sine_of(yaw), cosine_of(yaw), 0);
    next.along = level * cosine_of(pitch) - Vec3(0, 0, 1) * sine_of(pitch);
    next.across = glm::normalize(glm::cross(next.along, Vec3(0, 0, 1)) + Vec3(1e-6f, 0, 0));
    next.up = glm::normalize(glm::cross(next.across, next.along));
    next.at = stem.back().at + next.along * (1.0f / static_cast<float>(pieces));
    stem.push_back(next);
  }
  stem[0].along = stem[1].along, stem[0].up = stem[1].up, stem[0].across = stem[1].across;
  return stem;
}

StemStation station_at(const std::vector<StemStation>& stem, double t) {
  double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(stem.size() - 1);
  std::size_t i = std::min(static_cast<std::size_t>(place), stem.size() - 2);
  auto share = static_cast<float>(place - static_cast<double>(i));
  StemStation s;
  s.at = glm::mix(stem[i].at, stem[i + 1].at, share);
  s.across = glm::normalize(glm::mix(stem[i].across, stem[i + 1].across, share));
  s.along = glm::normalize(glm::mix(stem[i].along, stem[i + 1].along, share));
  s.up = glm::normalize(glm::cross(s.across, s.along));
  return s;
}

/// Radii of the stalk of a compound leaf at its foot and tip, shares of its length; by eye.
struct StalkRadii {
  double foot, tip;
};
constexpr StalkRadii kRachis{0.011, 0.0015}, kTwig{0.010, 0.004};

constexpr double kDroopPower = 1.4;  // above 1: leaflets droop mostly toward their tips

/// A tapering rod of five sides along a stem.
Surface rod(const std::vector<StemStation>& stem, StalkRadii radii) {
  constexpr std::uint32_t kSides = 5;
  constexpr double kTaper = 0.8;  // below 1: it thins mostly near its foot
  constexpr double kClasp = 30;   // a length over that of its widened foot
  auto [foot, tip] = radii;
  Surface s;
  for (std::size_t i = 0; i < stem.size(); ++i) {
    double t = static_cast<double>(i) / static_cast<double>(stem.size() - 1);
    // Widened at the foot, where it clasps what it stands on.
    auto radius =
        static_cast<float>(foot + (tip - foot) * std::pow(t, kTaper) + foot * std::exp(-t * kClasp));
    for (std::uint32_t k = 0; k < kSides; ++k) {
      double angle = 2 * kPi * k / kSides;
      Vec3 out = stem[i].across * cosine_of(angle) + stem[i].up * sine_of(angle);
      s.position.push_back(stem[i].at + out * radius);
    }
  }
  for (std::uint32_t i = 0; i + 1 < stem.size(); ++i) {
    for (std::uint32_t k = 0; k < kSides; ++k) {
      std::uint32_t a = i * kSides + k, b = i * kSides + (k + 1) % kSides;
      s.triangle.push_back({a, a + kSides, b});
      s.triangle.push_back({b, a + kSides, b + kSides});
    }
  }
  set_normals(s);
  return s;
}

/// A narrow leaflet, folded along its midrib as a roof, that droops from `from` on.
void add_leaflet(Surface& s, const StemStation& from, double length, double width, double droop) {
  constexpr int kPieces = 5;
  constexpr std::array<double, kPieces + 1> kWidths{0.35, 0.9, 1.0, 0.85, 0.55, 0.0};
  constexpr float kAside = 0.9f, kDown = 0.45f;  // of half the width: where its rims lie, as a roof's
  auto start = static_cast<std::uint32_t>(s.position.size());
  Vec3 at = from.at;
  for (int i = 0; i <= kPieces; ++i) {
    double t = static_cast<double>(i) / kPieces, angle = droop * std::pow(t, kDroopPower);
    Vec3 along = from.along * cosine_of(angle) - from.up * sine_of(angle);
    Vec3 up = from.up * cosine_of(angle) + from.along * sine_of(angle);
    if (i > 0) at += along * static_cast<float>(length / kPieces);
    auto half = static_cast<float>(0.5 * width * kWidths[i]);
    for (int side = -1; side <= 1; ++side) {
      float out = static_cast<float>(side) * half;
      s.position.push_back(at + from.across * out * kAside - up * (kDown * std::abs(out)));
      s.uv.emplace_back(static_cast<float>(t), 0.5f + 0.5f * static_cast<float>(side));
    }
  }
  for (std::uint32_t i = 0; i < kPieces; ++i) {
    for (std::uint32_t k = 0; k < 2; ++k) {
      std::uint32_t a = start + 3 * i + k;
      s.triangle.push_back({a, a + 1, a + 4});
      if (i + 1 < kPieces) s.triangle.push_back({a, a + 4, a + 3});
    }
  }
}

/// A leaflet that is parted into lobes down to its midrib, each of two triangles on either side.
void add_pinna(Surface& s, const StemStation& from, double length, double width, double droop, int lobes) {
  constexpr double kNarrower = 0.85;             // share of its width that it loses toward its tip
  constexpr double kNarrowingPower = 1.7;        // above 1: it narrows mostly near its tip
  constexpr double kFirst = 0.8;                 // width of the first lobes over that of the second, about
  constexpr float kHang = 0.30f, kLean = 0.35f;  // of half the width: how far a rim lies lower, and forward
  constexpr double kLobe = 0.62;                 // of the way from lobe to lobe: the length of a rim
  auto start = static_cast<std::uint32_t>(s.position.size());
  auto add = [&](Vec3 at, double u, double v) {
    s.position.push_back(at);
    s.uv.emplace_back(static_cast<float>(u), static_cast<float>(v));
  };
  Vec3 at = from.at;
  for (int i = 0; i <= lobes; ++i) {
    double t = static_cast<double>(i) / lobes, angle = droop * std::pow(t, kDroopPower),
           step = length / lobes;
    Vec3 along = from.along * cosine_of(angle) - from.up * sine_of(angle);
    Vec3 up = from.up * cosine_of(angle) + from.along * sine_of(angle);
    add(at, t, 0.5);
    if (i == lobes) break;
    // A lobe leans forward, and its rim hangs.
    auto half = static_cast<float>(0.5 * width * (1 - kNarrower * std::pow(t, kNarrowingPower)) *
                                   (i == 0 ? kFirst : 1.0));
    for (float side : {-1.0f, 1.0f}) {
      Vec3 rim = at + from.across * (side * half) - up * (kHang * half) + along * (kLean * half);
      add(rim, t, 0.5 + 0.5 * static_cast<double>(side));
      add(rim + along * static_cast<float>(kLobe * step), t + kLobe / lobes,
          0.5 + 0.5 * static_cast<double>(side));
    }
    at += along * static_cast<float>(step);
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(lobes); ++i) {
    std::uint32_t m = start + 5 * i, next = m + 5;
    s.triangle.push_back({m, m + 2, m + 1});
    s.triangle.push_back({m, next, m + 2});
    add_quad(s, m, m + 3, m + 4, next);
  }
}

/// A leaflet with that many lobes on either side, which is whole without any.
void add_parted(Surface& s, const StemStation& from, double length, double width, double droop, int lobes) {
  if (lobes > 0) return add_pinna(s, from, length, width, droop, lobes);
  add_leaflet(s, from, length, width, droop);
}

void append_shaped(Surface& to, const Surface& from, const glm::mat3& turn, Vec3 shift) {
  glm::mat3 normals = turn / std::cbrt(std::max(std::abs(glm::determinant(turn)), 1e-20f));
  append_mapped(
      to, from, [&](Vec3 p) { return turn * p + shift; },
      [&](Vec3 n) { return glm::normalize(normals * n); });
}

/// By how much the leaflets of a frond differ to either side; by eye.
struct FrondVariation {
  double bend = 0.15;                          ///< share of the rachis' own
  double aside = 0.25;                         ///< radians by which the tip of the rachis turns aside
  double place = 0.25;                         ///< of the space from leaflet to leaflet
  double length = 0.10, droop = 0.35;          ///< shares of a leaflet's own
  double forward = 6, raised = 8, twist = 25;  ///< degrees
};

/// Turned about an axis of its own.
Vec3 turned(Vec3 v, Vec3 axis, double angle) { return glm::angleAxis(static_cast<float>(angle), axis) * v; }

}  // namespace

Surface leaflets_surface(std::span<const LeafletPlace> places, double width, int lobes) {
  Surface leaflets;
  for (const LeafletPlace& place : places) {
    StemStation foot;
    foot.at = place.at, foot.along = place.along;
    Vec3 across = glm::cross(place.along, place.up);
    if (!(glm::length(across) > 1e-3f)) across = glm::cross(place.along, Vec3(1, 0.01f, 0));
    foot.across = turned(glm::normalize(across), place.along, place.twist);
    foot.up = glm::cross(foot.across, foot.along);
    auto length = static_cast<double>(place.length);
    add_parted(leaflets, foot, length, width * length, place.droop, lobes);
  }
  set_normals(leaflets);
  return leaflets;
}

TwigParts frond_foliage(const FrondShape& shape, Seed seed) {
  constexpr double kBendPower = 1.5;                   // above 1: the rachis bends mostly toward its tip
  constexpr double kForward = 64, kForwardLobed = 80;  // degrees between rachis and the lowest leaflets
  constexpr double kForwardTip = 38;                   // degrees less at the tip
  constexpr double kFlatter = 0.4;                     // share by which leaflets are raised less at the tip
  constexpr double kWide = 1.15, kWideLobed = 1.05;    // of the space from leaflet to leaflet: width of one
  constexpr double kMostWide = 0.3, kMostWideLobed = 0.5;   // of its own length
  constexpr double kEndLength = 0.14, kMostEndWide = 0.05;  // of the frond's width: the leaflet at its end
  constexpr FrondVariation kVaries;
  TwigParts frond;
  std::vector<StemStation> stem = stem_of(shape.bend * (1 + kVaries.bend * seed.child(0).range(-1, 1)),
                                          kBendPower, kVaries.aside * seed.child(1).range(-1, 1), 24);
  frond.stem = rod(stem, kRachis);
  double spacing = (1 - shape.stalk) / shape.pairs;
  for (int i = 0; i < shape.pairs; ++i) {
    for (int side : {-1, 1}) {
      Seed own = seed.child("leaflet", 2 * i + (side > 0));
      double s = (i + 0.5 + kVaries.place * own.child(0).range(-1, 1)) / shape.pairs;
      StemStation foot = station_at(stem, shape.stalk + (1 - shape.stalk) * s);
      // Long in the middle, short at both ends; forward at the tip.
      double length = 0.5 * shape.width * std::pow(std::sin(kPi * (0.18 + 0.74 * s)), 0.7);
      if (shape.lobes > 0)  // widest below the middle, and drawn out to a point
        length = 0.62 * shape.width * std::min(1.0, 0.42 + 1.9 * s) * std::pow(1 - 0.97 * s, 0.75);
      length *= 1 + kVaries.length * own.child(1).range(-1, 1);
      double forward = radians((shape.lobes > 0 ? kForwardLobed : kForward) - kForwardTip * s +
                               kVaries.forward * own.child(2).range(-1, 1));
      double raised = shape.fold * (1 - kFlatter * s) + radians(kVaries.raised) * own.child(3).range(-1, 1);
      Vec3 out = foot.across * static_cast<float>(side) * cosine_of(raised) + foot.up * sine_of(raised);
      StemStation leaflet;
      leaflet.at = foot.at;
      leaflet.along = glm::normalize(foot.along * cosine_of(forward) + out * sine_of(forward));
      leaflet.across = glm::normalize(glm::cross(leaflet.along, foot.up));
      leaflet.across =
          turned(leaflet.across, leaflet.along, radians(kVaries.twist) * own.child(4).range(-1, 1));
      leaflet.up = glm::normalize(glm::cross(leaflet.across, leaflet.along));
      double droop = shape.droop * (1 + kVaries.droop * own.child(5).range(-1, 1));
      double wide = shape.lobes > 0 ? std::min(kWideLobed * spacing, kMostWideLobed * length)
                                    : std::min(kWide * spacing, kMostWide * length);
      add_parted(frond.blades, leaflet, length, wide, droop, shape.lobes);
    }
  }
  // One leaflet ends the frond.
  StemStation end = stem.back();
  add_leaflet(frond.blades, end, kEndLength * shape.width,
              std::min(kWide * spacing, kMostEndWide * shape.width), shape.droop);
  set_normals(frond.blades);
  return frond;
}

TwigParts sprig_foliage(const TwigShape& shape, Seed seed) {
  constexpr double kLastLeaf = 0.6;  // of a leaf's length: what the last one adds to the twig's
  constexpr double kBendPower = 1.2, kAside = 0.3;  // as of the rachis of a frond
  constexpr double kFirst = 0.12, kSpan = 0.85;     // of the twig: where leaves begin, and how far they go on
  // Degrees outward from the twig at its foot, and less at its tip; degrees upward; and how all of it varies.
  constexpr double kOutward = 58, kOutwardTip = 16, kUpward = -12;
  constexpr double kOutwardVaries = 14, kUpwardVaries = 30, kRollVaries = 28;
  constexpr double kSizeVaries = 0.12;
  TwigParts sprig;
  Surface blade = blade_surface(shape.leaf);
  double reach = 1 - kLastLeaf * shape.leaf_length;  // the last leaf makes the rest of the length
  std::vector<StemStation> stem = stem_of(shape.bend, kBendPower, kAside * seed.child(0).range(-1, 1), 8);
  for (StemStation& station : stem) station.at *= static_cast<float>(reach);
  sprig.stem = rod(stem, kTwig);
  for (int i = 0; i < shape.leaves; ++i) {
    Seed own = seed.child("leaf", i);
    bool last = i + 1 == shape.leaves;
    double s = shape.leaves > 1 ? static_cast<double>(i) / (shape.leaves - 1) : 1.0;
    StemStation foot = station_at(stem, last ? 1.0 : kFirst + kSpan * s);
    double side = last ? 0.0 : i % 2 == 0 ? -1.0 : 1.0;
    double outward = side * radians(kOutward - kOutwardTip * s + kOutwardVaries * own.child(0).range(-1, 1));
    double pitch = radians(kUpward + kUpwardVaries * own.child(1).range(-1, 1));
    double roll = radians(kRollVaries) * own.child(2).range(-1, 1);
    Vec3 along = turned(foot.along, foot.up, -outward), up = foot.up;
    Vec3 across = glm::normalize(glm::cross(along, up));
    along = turned(along, across, pitch), up = glm::normalize(glm::cross(across, along));
    across = turned(across, along, roll), up = glm::normalize(glm::cross(across, along));
    // The largest are in the middle.
    double size = shape.leaf_length * (0.8 + 0.35 * std::sin(kPi * (0.2 + 0.6 * s))) *
                  (1 + kSizeVaries * own.child(3).range(-1, 1));
    append_shaped(sprig.blades, blade, glm::mat3(across, along, up) * static_cast<float>(size), foot.at);
  }
  return sprig;
}

}  // namespace frond
