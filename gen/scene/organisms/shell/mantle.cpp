#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "organisms/shell/coil.h"

namespace frond {

namespace {

constexpr int kMantleAlong = 220, kMantleAcross = 56;
constexpr double kMantleEnds = 0.10;  // share of the edge at each side of the hinge that it leaves free

double bump(double x, double width) { return std::exp(-(x / width) * (x / width)); }

// Where water comes in by the wide part of the slit, and where it leaves by a tube: shares of the slit's
// length.
constexpr double kInlet = 0.66, kInletWidth = 0.07, kOutlet = 0.36;

/// The height of the tissue over the margins, `across` from the slit 0 to the edge 1, and its undulation. Its
/// numbers are by eye.
double swelling(const MantleParams& mantle, double along, double across, bool far) {
  constexpr double kWavesAlong = 30, kRipplesAlong = 75;                    // on the whole length
  constexpr double kTubeRadius = 0.22, kTubeWall = 0.11, kTubeHole = 0.13;  // of the way across, about
  constexpr double kTubeHeight = 0.55, kTubeDepth = 0.9;                    // in heights of the swelling
  double inlet = bump(along - kInlet, kInletWidth);
  double pillow = std::sin(kPi * std::min(0.97, 0.16 + 0.66 * across)) - 0.35;
  double waves = noise(Vec3(along * kWavesAlong, far ? 7.3f : 2.1f, 0)) +
                 0.5 * noise(Vec3(along * kRipplesAlong, far ? 3.3f : 9.1f, 4));
  double slit = (0.8 + 0.6 * inlet) * bump(across, 0.07 + 0.16 * inlet);  // deeper and wider at the inlet
  double ring = std::hypot((along - kOutlet) * 9, across * 0.9);
  double tube = kTubeHeight * bump(ring - kTubeRadius, kTubeWall) - kTubeDepth * bump(ring, kTubeHole);
  return mantle.swell * (1.2 * pillow - slit + tube) +
         mantle.ruffle * 2 * waves * smooth_step(0.25, 0.9, across);
}

/// Gives a sheet of kMantleAlong + 1 rows its lower side, and closes it round the border.
void close_mantle(Surface& top, const std::vector<Vec3>& under) {
  constexpr std::uint32_t kRow = kMantleAcross + 1;
  auto count = static_cast<std::uint32_t>(under.size());
  top.position.insert(top.position.end(), under.begin(), under.end());
  std::vector<Vec2> uv = top.uv;
  top.uv.insert(top.uv.end(), uv.begin(), uv.end());
  std::vector<std::uint32_t> border;  // round the upper side
  for (std::uint32_t b = 0; b + 1 < kRow; ++b) border.push_back(b);
  for (std::uint32_t a = 0; a < kMantleAlong; ++a) border.push_back(a * kRow + kRow - 1);
  for (std::uint32_t b = kRow; b-- > 1;) border.push_back(kMantleAlong * kRow + b);
  for (std::uint32_t a = kMantleAlong; a > 0; --a) border.push_back(a * kRow);
  auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    top.triangle.push_back({a, b, c}), top.triangle.push_back({a, c, d});
  };
  for (std::uint32_t a = 0; a < kMantleAlong; ++a)
    for (std::uint32_t b = 0; b + 1 < kRow; ++b) {
      std::uint32_t i = a * kRow + b;
      quad(i, i + 1, i + 1 + kRow, i + kRow);
      quad(count + i, count + i + kRow, count + i + kRow + 1, count + i + 1);
    }
  for (std::size_t k = 0; k < border.size(); ++k) {
    std::uint32_t a = border[k], b = border[(k + 1) % border.size()];
    quad(b, a, a + count, b + count);
  }
}

}  // namespace

Surface shell_mantle(const ShellParams& params, const ShellEdge& edge, double grown, double gape,
                     float hinge) {
  constexpr double kLipFrom = 0.80, kOverhangFrom = 0.55;     // of the way across
  constexpr double kOverhang = 0.04, kLipDrop = 0.07;         // of the shell's size
  constexpr double kMantleThick = 0.05, kThinnerLip = 0.035;  // of it, too
  constexpr double kBlunt = 0.35;  // power: below 1 the swelling is soon full behind its ends
  const MantleParams& mantle = *params.mantle;
  double size = std::exp(-params.rate() * grown);
  auto opened = [&](Vec3 at, double by) {
    float c = static_cast<float>(std::cos(by)), s = static_cast<float>(std::sin(by)), x = at.x - hinge;
    return Vec3(hinge + c * x - s * at.y, s * x + c * at.y, at.z);
  };
  Surface top;
  std::vector<Vec3> under;
  for (int a = 0; a <= kMantleAlong; ++a) {
    double along = static_cast<double>(a) / kMantleAlong;
    double at = (kMantleEnds + (1 - 2 * kMantleEnds) * along) * static_cast<double>(edge.at.size() - 1);
    auto i = static_cast<std::size_t>(at);
    auto part = static_cast<float>(at - static_cast<double>(i));
    auto margin = [&](bool below) {
      return opened(glm::mix(shell_margin(params, edge, edge.at[i], grown, below),
                             shell_margin(params, edge, edge.at[i + 1], grown, below), part),
                    (below ? -0.5 : 0.5) * gape);
    };
    Vec3 high = margin(false), low = margin(true), middle = 0.5f * (high + low), half = 0.5f * (high - low);
    Vec3 out = glm::normalize(Vec3(edge.at[i].normal[0], 0, edge.at[i].normal[1]));
    out = glm::normalize(out + Vec3(0.5f, 0, 0));  // rather away from the hinge
    Vec3 aside = glm::normalize(half + Vec3(0, 1e-4f * static_cast<float>(size), 0));
    auto wide = static_cast<double>(glm::length(half));
    double full = std::pow(std::max(0.0, std::sin(kPi * along)), kBlunt) * std::min(1.0, 3 * wide / size);
    for (int b = 0; b <= kMantleAcross; ++b) {
      double side = 2.0 * b / kMantleAcross - 1, across = std::abs(side);
      double lip = smooth_step(kLipFrom, 1.0, across), raised = swelling(mantle, along, across, side > 0);
      // It lies on the margins and hangs a little over them.
      double over = across * wide +
                    size * (0.9 * params.wall + kOverhang) * smooth_step(kOverhangFrom, 1.0, across) * full;
      double up = size * full * (raised * (1 - 0.5 * lip) + 0.4 * params.wall - kLipDrop * lip * lip);
      Vec3 p = middle + aside * static_cast<float>(side < 0 ? -over : over) + out * static_cast<float>(up);
      top.position.push_back(p);
      top.uv.push_back({static_cast<float>(along), static_cast<float>(0.002 + 0.996 * (side + 1) / 2)});
      double thick = size * (kMantleThick - kThinnerLip * lip) * std::max(0.2, full);
      under.push_back(p - out * static_cast<float>(thick) -
                      aside * static_cast<float>((side < 0 ? -1 : 1) * 0.3 * thick * lip));
    }
  }
  close_mantle(top, under);
  set_normals(top);
  return top;
}

}  // namespace frond
