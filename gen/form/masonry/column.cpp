#include "masonry/column.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/noise.h"

namespace frond {

namespace {

constexpr int kBetweenFlutes = 8;  // points a flute
constexpr int kLeastSides = 64;    // points round the column
constexpr double kHollow = 0.8;    // of the way from flute to flute; the rest is a flat fillet

/// One level of the column.
struct Ring {
  double y, radius;
  double square = 0;  // 0 round .. 1 a square that touches the circle
  double flute = 0;   // 0 smooth .. 1 fluted
};

/// How far in from the circle a fluted shaft lies at a share 0..1 of the way from fillet to fillet.
double flute_at(double share) {
  double t = (share - 0.5) / (kHollow / 2);
  return std::abs(t) < 1 ? std::sqrt(1 - t * t) : 0;
}

/// Heights of mouldings are shares of the base's or the capital's, radii multiples of the shaft's beside
/// them; by eye where no source is named.
class Turner {
 public:
  explicit Turner(const ColumnShape& shape) : s_(shape), r_(shape.radius) {}

  std::vector<Ring> profile() {
    base();
    shaft();
    if (s_.broken <= 0) capital();
    return std::move(rings_);
  }

  double base_height() const { return r_; }  // Vitruvius: half of the thickness of the column
  double capital_height() const { return r_; }

 private:
  void ring(double y, double radius, double square = 0) { rings_.push_back({y, radius, square, 0}); }

  /// A half circle from y to y + height that bulges (or with a negative depth hollows) by `depth`.
  void roll(double y, double height, double radius, double depth, int steps) {
    for (int i = 0; i <= steps; ++i) {
      double a = kPi * i / steps;
      ring(y + height * (1 - std::cos(a)) / 2, radius + depth * std::sin(a));
    }
  }

  void base() {
    double h = base_height();
    ring(0, 1.36 * r_, 1), ring(0.30 * h, 1.36 * r_, 1);   // the plinth
    roll(0.30 * h, 0.26 * h, 1.22 * r_, 0.13 * r_, 10);    // the lower roll
    ring(0.56 * h, 1.20 * r_), ring(0.59 * h, 1.20 * r_);  // a fillet
    roll(0.59 * h, 0.17 * h, 1.16 * r_, -0.07 * r_, 8);    // the hollow
    ring(0.76 * h, 1.13 * r_), ring(0.79 * h, 1.13 * r_);  // a fillet
    roll(0.79 * h, 0.14 * h, 1.10 * r_, 0.07 * r_, 8);     // the upper roll
    ring(0.93 * h, 1.09 * r_), ring(0.96 * h, 1.09 * r_);  // a fillet
  }

  double shaft_top() const { return s_.height - capital_height(); }

  void shaft() {
    constexpr double kLeastStump = 0.2;                  // radii of a broken shaft above its base
    constexpr double kFootHigh = 0.10, kFootOut = 0.07;  // radii: the apophyge
    constexpr double kPlainEnd = 0.12;                   // radii without flutes at either end
    constexpr double kFluteDome = 0.16;                  // radii: length of the domes of flutes
    constexpr double kStep = 0.05;                       // metres from ring to ring, about
    constexpr double kThinning = 1.4;                    // above 1: it thins mostly in its upper part
    constexpr double kBulgeEnd = 0.87;                   // share of the length up to which it bulges
    constexpr double kBulgePace = 1.15;                  // its inverse, about
    double low = base_height(), high = shaft_top(), length = high - low;
    double end = s_.broken > 0 ? std::max(low + kLeastStump * r_, s_.height * (1 - s_.broken)) : high;
    // The apophyge: the shaft grows out of its base and into its neck in a quarter circle.
    for (int i = 0; i <= 4; ++i) {
      double a = kPi / 2 * i / 4;
      ring(low + kFootHigh * r_ * std::sin(a) - 0.0001 * (i == 0), r_ * (1 + kFootOut * (1 - std::sin(a))));
    }
    int count = std::clamp(static_cast<int>(length / kStep), 24, 120);
    for (int i = 0; i <= count; ++i) {
      double t = static_cast<double>(i) / count, y = low + kPlainEnd * r_ + (length - 2 * kPlainEnd * r_) * t;
      if (y > end) break;
      double swell = s_.entasis * std::sin(kPi * std::min(1.0, t * kBulgePace)) * (t < kBulgeEnd ? 1 : 0);
      double radius = r_ * (1 + (s_.taper - 1) * std::pow(t, kThinning) + swell);
      // Flutes begin and end in half domes.
      double near = std::min(y - low - kPlainEnd * r_, high - kPlainEnd * r_ - y) / (kFluteDome * r_);
      double dome = near >= 1 ? 1 : std::sqrt(std::max(0.0, 1 - (1 - near) * (1 - near)));
      rings_.push_back({y, radius, 0, dome});
    }
  }

  void capital() {
    double low = shaft_top(), h = capital_height(), r = r_ * s_.taper;
    // The upper apophyge and the astragal.
    for (int i = 0; i <= 4; ++i) {
      double a = kPi / 2 * i / 4;
      ring(low - 0.10 * r + 0.10 * r * (1 - std::cos(a)), r * (1 + 0.05 * std::sin(a)));
    }
    roll(low + 0.01 * h, 0.10 * h, 1.05 * r, 0.05 * r, 6);
    ring(low + 0.11 * h, 1.0 * r), ring(low + 0.34 * h, 1.0 * r);    // the necking
    ring(low + 0.34 * h, 1.05 * r), ring(low + 0.39 * h, 1.05 * r);  // a fillet
    // The echinus, and the slab with its moulding.
    for (int i = 0; i <= 8; ++i) {
      double a = kPi / 2 * i / 8;
      ring(low + 0.39 * h + 0.27 * h * (1 - std::cos(a)), r * (1.06 + 0.26 * std::sin(a)));
    }
    ring(low + 0.68 * h, 1.32 * r, 0), ring(low + 0.68 * h, 1.36 * r, 1);
    ring(low + 0.92 * h, 1.36 * r, 1), ring(low + 0.92 * h, 1.42 * r, 1), ring(low + h, 1.42 * r, 1);
  }

  const ColumnShape& s_;
  double r_;
  std::vector<Ring> rings_;
};

/// How much farther than the circle a square that touches it lies in a direction; its corners lie at odd
/// multiples of 45 degrees.
double square_at(double angle) { return 1 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle))); }

}  // namespace

Surface column_surface(const ColumnShape& shape) {
  std::vector<Ring> rings = Turner(shape).profile();
  int flutes = shape.flutes > 0 ? shape.flutes : 8;
  // The corners of the squares must be among the points of a ring.
  int sides = flutes * kBetweenFlutes;
  while (sides % 8 != 0 || sides < kLeastSides) sides += flutes * kBetweenFlutes;
  // A break rises so much for each metre along x and z, and is rough by a share of the radius.
  constexpr double kBreakX = 0.5, kBreakZ = 0.25, kRough = 0.10;
  constexpr float kLumps = 9.0f;  // a metre, about
  Surface s;
  double foot = rings.back().y - shape.radius;
  for (const Ring& ring : rings) {
    for (int k = 0; k < sides; ++k) {
      double angle = -2 * kPi * k / sides;
      double share = std::fmod(static_cast<double>(k) * flutes / sides + 0.5, 1.0);
      double hollow =
          shape.flutes > 0 ? ring.flute * shape.flute_depth * flute_at(share) * kHollow * kPi / flutes : 0;
      double radius = ring.radius * (1 - hollow) * (1 + ring.square * (square_at(angle) - 1));
      Vec3 at(radius * std::cos(angle), ring.y, radius * std::sin(angle));
      if (shape.broken > 0 && ring.y > foot) {
        double slant =
            kBreakX * at.x + kBreakZ * at.z + kRough * shape.radius * fractal_noise(at * kLumps, 3);
        at.y += static_cast<float>(slant * smooth_step(foot, rings.back().y, ring.y));
      }
      s.position.push_back(at);
    }
  }
  auto n = static_cast<std::uint32_t>(sides), rows = static_cast<std::uint32_t>(rings.size());
  for (std::uint32_t r = 0; r + 1 < rows; ++r)
    for (std::uint32_t k = 0; k < n; ++k) {
      std::uint32_t a = r * n + k, b = r * n + (k + 1) % n;
      add_quad(s, a, b, b + n, a + n);
    }
  for (bool top : {false, true}) {
    std::uint32_t first = top ? (rows - 1) * n : 0, middle = static_cast<std::uint32_t>(s.position.size());
    Vec3 sum(0);
    for (std::uint32_t k = 0; k < n; ++k) sum += s.position[first + k];
    s.position.push_back(sum / static_cast<float>(n));
    for (std::uint32_t k = 0; k < n; ++k) {
      std::uint32_t a = first + k, b = first + (k + 1) % n;
      if (top)
        s.triangle.push_back({a, b, middle});
      else
        s.triangle.push_back({b, a, middle});
    }
  }
  // Levels that lie on each other leave triangles without an area.
  std::erase_if(s.triangle, [&](const std::array<std::uint32_t, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  });
  set_normals(s);
  return s;
}

}  // namespace frond
