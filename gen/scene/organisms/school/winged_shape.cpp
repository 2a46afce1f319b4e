#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "organisms/school/swimmer_shape.h"

// Animals that fly through the water: turtles and mantas.

namespace frond {

namespace {

/// The beat of a wing. Its slope at each place swings, later toward its tip, so that a wave runs outward; its
/// length stays as it is.
struct WingBeat {
  double rise;       ///< radians, its mean slope
  double amplitude;  ///< radians, of its tip's slope
  double stiffness;  ///< power of the share of its length: the greater, the more its root stays
  double lag;        ///< beats by which the tip is behind the root
};

/// Where a place on it is: out from its root and up, for a share of its length.
glm::dvec2 beaten(const WingBeat& beat, double share, double phase) {
  constexpr int kSteps = 16;
  glm::dvec2 at(0);
  for (int i = 0; i < kSteps; ++i) {
    double s = share * (i + 0.5) / kSteps;
    double slope =
        beat.rise + beat.amplitude * std::pow(s, beat.stiffness) * std::sin(2 * kPi * (phase - beat.lag * s));
    at += share / kSteps * glm::dvec2(std::cos(slope), std::sin(slope));
  }
  return at;
}

/// A part whose outline is swept round an axis: upper and lower side apart, since they have their own
/// pictures.
void add_sides(Surface& mesh, int rings, int round, FunctionRef<Vec3(double, double)> place,
               FunctionRef<Vec2(double, bool, double)> uv) {
  for (bool above : {true, false})
    add_sheet(
        mesh, rings, round, [&](double t, double r) { return place(t, kPi * (above ? r : r + 1)); },
        [&](double t, double r) { return uv(t, above, kPi * (above ? r : r + 1)); });
}

/// Normals that are shared where vertices of two sides lie at one place.
void set_joined_normals(Surface& mesh) {
  set_normals(mesh);
  std::vector<std::uint32_t> order(mesh.position.size());
  std::iota(order.begin(), order.end(), 0u);
  auto key = [&](std::uint32_t i) {
    const Vec3& p = mesh.position[i];
    return std::tuple(std::lround(p.x * 1e5f), std::lround(p.y * 1e5f), std::lround(p.z * 1e5f));
  };
  std::ranges::sort(
      order, [&](std::uint32_t i, std::uint32_t j) { return key(i) != key(j) ? key(i) < key(j) : i < j; });
  for (std::size_t from = 0; from < order.size();) {
    std::size_t to = from;
    Vec3 sum(0);
    while (to < order.size() && key(order[to]) == key(order[from])) sum += mesh.normal[order[to++]];
    if (glm::length(sum) > 1e-3f)
      for (std::size_t k = from; k < to; ++k) mesh.normal[order[k]] = glm::normalize(sum);
    from = to;
  }
}

/// Adds a mesh and its mirror image.
void add_both_sides(Surface& mesh, const Surface& right) {
  append(mesh, right);
  Surface left = right;
  for (Vec3& p : left.position) p.x = -p.x;
  for (auto& triangle : left.triangle) std::swap(triangle[1], triangle[2]);
  append(mesh, left);
}

/// An eye: a dark ball.
void add_eye(Surface& mesh, double along, double up, double out, double radius) {
  add_sheet(
      mesh, 6, 10,
      [=](double t, double r) {
        double a = kPi * t, b = 2 * kPi * r;
        return swimmer_place(along + radius * std::cos(a), up + radius * std::sin(a) * std::sin(b),
                             out + radius * std::sin(a) * std::cos(b));
      },
      [](double, double) { return eye_uv(); });
}

/// A paddle of a turtle, on its right.
struct Flipper {
  double along, aside, up;  ///< its root
  double length, chord;
  double back;   ///< radians that it points back from straight aside
  double sweep;  ///< how far its tip lies behind that, as a share of its length
  double reach;  ///< how far its tip goes forward and back in a beat, likewise
  double twist;  ///< radians that it turns its face
  WingBeat beat;
};

constexpr Flipper kFore{0.29, 0.17, -0.02, 0.52, 0.135, 0.25, 0.42, 0.10, 0.5, {0.05, 0.75, 0.35, 0.16}};
constexpr Flipper kHind{0.87, 0.11, -0.02, 0.24, 0.13, 0.95, 0.10, 0.05, 0.2, {-0.1, 0.16, 0.5, 0.2}};

Surface flipper(const Flipper& f, double phase) {
  constexpr double kThick = 0.17;  // of its chord
  Surface mesh;
  auto chord = [&](double t) {  // broadest at a third, a rounded tip
    return f.chord * (0.62 + 0.55 * std::sin(kPi * std::pow(t, 0.75)) - 0.40 * t) *
           std::sqrt(std::max(0.0, 1 - std::pow(t, 7)));
  };
  // Along the paddle's own axes: out along its span, and forward across it.
  auto plan = [&](double t, double turn) {
    double forward = 0.5 * chord(t) * std::cos(turn) - f.sweep * f.length * std::pow(t, 1.8),
           span = f.length * t;
    return glm::dvec2(f.along + span * std::sin(f.back) - forward * std::cos(f.back),
                      f.aside + span * std::cos(f.back) + forward * std::sin(f.back));
  };
  auto place = [&](double t, double turn) {
    glm::dvec2 at = plan(t, turn), beaten_at = beaten(f.beat, t, phase);
    double late = 2 * kPi * (phase - f.beat.lag * t), half = 0.5 * chord(t);
    double pitch = f.twist * t * std::cos(late);
    double thick = kThick * half * (1.1 - 0.6 * t) * std::sin(turn);
    double up = f.up + f.length * beaten_at.y + thick + half * std::cos(turn) * std::sin(pitch);
    double along = at.x - f.reach * f.length * t * std::sin(late);
    // Its span gets shorter aside by as much as it rises.
    double aside = f.aside + (at.y - f.aside) * (t > 0 ? beaten_at.x / t : 1);
    return swimmer_place(along, up, aside);
  };
  add_sides(mesh, 20, 8, place, [&](double t, bool above, double turn) {
    glm::dvec2 at = plan(t, turn);
    return plan_uv(at.x, at.y, above);
  });
  return mesh;
}

void add_shell(Surface& mesh) {
  constexpr double kDome = 0.165, kKeel = 0.075;  // height above and below the rim
  auto along = [](double t) { return kShellFrom + (kShellTo - kShellFrom) * t; };
  auto place = [&](double t, double turn) {
    double s = t * t * (1.5 - 0.5 * t), wide = shell_width(s), up = std::sin(turn);
    double dome = kDome * std::pow(std::sin(kPi * std::pow(s, 0.78)), 0.75);
    double keel = kKeel * std::pow(std::sin(kPi * std::min(1.0, 0.04 + 0.96 * s)), 0.45);
    double z = up > 0 ? dome * std::pow(up, 0.9) : -keel * std::pow(-up, 0.5);
    // The rim turns up over the neck and the hind flippers.
    double rim = 0.02 * (1 - s) - 0.03 * s + 0.012 * std::cos(2 * kPi * s);
    return swimmer_place(along(s), rim + z, wide * std::cos(turn));
  };
  add_sides(mesh, 36, 18, place, [&](double t, bool above, double turn) {
    double s = t * t * (1.5 - 0.5 * t);
    return plan_uv(along(s), shell_width(s) * std::cos(turn), above);
  });
}

void add_head(Surface& mesh) {
  constexpr double kWide = 0.066, kHigh = 0.064, kLong = 0.30;
  auto size = [](double t) {  // the beak, the skull, the neck
    double skull = std::sqrt(std::sin(0.5 * kPi * std::min(1.0, (t + 0.004) / 0.32)));
    return skull * (1 - 0.22 * smooth_step(0.42, 0.62, t));
  };
  auto wide = [&](double t, double turn) {
    return kWide * size(t) * std::cos(turn) * (0.72 + 0.28 * smooth_step(0.0, 0.4, t));
  };
  auto place = [&](double t, double turn) {
    double s = std::sin(turn), up = kHigh * size(t) * (s > 0 ? s : 0.85 * s);
    return swimmer_place(kLong * t, up - 0.02 * (1 - smooth_step(0.0, 0.25, t)), wide(t, turn));
  };
  add_sides(mesh, 16, 10, place,
            [&](double t, bool above, double turn) { return plan_uv(kLong * t, wide(t, turn), above); });
  for (double side : {-1.0, 1.0}) add_eye(mesh, 0.066, 0.012, 0.047 * side, 0.0115);
}

constexpr WingBeat kWing{0.06, 0.85, 1.1, 0.28};
constexpr double kDiscBody = 0.2;  // of half a manta's span, that its beat spares

/// The outline of a manta's disc from above: front and hind edge at a share of half its span.
glm::dvec2 disc_edges(double share) {
  double front = 0.035 + 0.20 * std::pow(share, 1.35) + 0.05 * smooth_step(0.7, 1.0, share),
         hind = 0.47 - 0.185 * std::pow(share, 0.6);
  return {front, std::max(hind, front)};
}

void add_disc(Surface& mesh, double phase) {
  constexpr double kThick = 0.052, kWingThick = 0.011;
  auto at = [](double t, double turn) {
    double share = std::abs(2 * t - 1);
    glm::dvec2 edges = disc_edges(share);
    return (edges.x + edges.y) / 2 - (edges.y - edges.x) / 2 * std::cos(turn);
  };
  auto place = [&](double t, double turn) {
    double share = std::abs(2 * t - 1), side = t < 0.5 ? -1 : 1;
    double wing = std::max(0.0, (share - kDiscBody) / (1 - kDiscBody));
    glm::dvec2 out = beaten(kWing, wing, phase);
    // Its body goes down as its wings go up.
    double body = -0.03 * std::sin(2 * kPi * (phase - 0.1));
    double thick =
        (kThick * std::exp(-std::pow(share / 0.27, 2)) + kWingThick * std::sqrt(std::max(0.0, 1 - share)));
    double profile = std::sin(turn) * (1 + 0.35 * std::cos(turn));  // thickest before its middle
    double up = 0.5 * (1 - kDiscBody) * out.y + body + thick * profile * (profile > 0 ? 1 : 0.75);
    return swimmer_place(at(t, turn), up,
                         0.5 * side * (std::min(share, kDiscBody) + (1 - kDiscBody) * out.x));
  };
  add_sides(mesh, 56, 10, place, [&](double t, bool above, double turn) {
    return plan_uv(at(t, turn), 0.5 * (2 * t - 1), above);
  });
}

/// The fins of the head, rolled up as it swims, a pair of horns.
Surface horn(double phase) {
  Surface mesh;
  double body = -0.03 * std::sin(2 * kPi * (phase - 0.1));
  auto place = [&](double t, double turn) {
    double thick = 0.022 * (1 - 0.62 * t), along = 0.06 - 0.135 * t;
    return swimmer_place(along, body - 0.018 * t * t + 1.3 * thick * std::sin(turn),
                         0.088 - 0.022 * t * t + 0.55 * thick * std::cos(turn));
  };
  add_sides(mesh, 8, 6, place, [](double t, bool above, double turn) {
    return plan_uv(0.06 - 0.135 * t, 0.12 + 0.01 * std::cos(turn), above);
  });
  add_eye(mesh, 0.062, body + 0.004, 0.106, 0.009);
  return mesh;
}

/// A tail like a whip, and the small fin at its root.
void add_tail(Surface& mesh, double phase) {
  constexpr double kFrom = 0.44, kTo = 0.92, kThick = 0.0055;
  double body = -0.03 * std::sin(2 * kPi * (phase - 0.1));
  auto up = [&](double t) { return body * (1 - 0.5 * t) + 0.02 * t * std::sin(2 * kPi * (phase - 0.4 * t)); };
  auto place = [&](double t, double turn) {
    double thick = kThick * (1 - 0.85 * t);
    return swimmer_place(kFrom + (kTo - kFrom) * t, up(t) + thick * std::sin(turn), thick * std::cos(turn));
  };
  add_sides(mesh, 14, 5, place,
            [](double t, bool, double) { return plan_uv(kFrom + (kTo - kFrom) * t, 0.02, true); });
  add_sheet(
      mesh, 4, 2,
      [&](double t, double r) {
        return swimmer_place(0.43 + 0.045 * t + 0.02 * r, up(0) + 0.008 + 0.032 * r * (1 - 0.5 * t), 0);
      },
      [](double t, double) { return plan_uv(0.43 + 0.045 * t, 0.02, true); });
}

}  // namespace

Surface turtle_surface(double phase) {
  Surface mesh;
  add_shell(mesh);
  add_head(mesh);
  add_both_sides(mesh, flipper(kFore, phase));
  add_both_sides(mesh, flipper(kHind, phase));
  set_joined_normals(mesh);
  return mesh;
}

Surface manta_surface(double phase) {
  Surface mesh;
  add_disc(mesh, phase);
  add_both_sides(mesh, horn(phase));
  add_tail(mesh, phase);
  set_joined_normals(mesh);
  return mesh;
}

}  // namespace frond
