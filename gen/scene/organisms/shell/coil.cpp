#include "organisms/shell/coil.h"

#include <algorithm>
#include <cmath>

#include "core/curve.h"

namespace frond {

namespace {

constexpr int kEdgeSteps = 2048;  // of the edge before it is cut into equal parts
constexpr int kLipRows = 5;

glm::dvec2 catmull_rom(const std::vector<Vec2>& points, double at) {
  std::size_t n = points.size(), i = static_cast<std::size_t>(at) % n;
  auto p = [&](std::size_t k) { return glm::dvec2(points[(i + k + n - 1) % n]); };
  Hermite w = hermite(at - std::floor(at));
  return w.start * p(1) + w.end * p(2) + 0.5 * w.start_slope * (p(2) - p(0)) +
         0.5 * w.end_slope * (p(3) - p(1));
}

/// The edge as a fine polygon against the clock, from its innermost place on.
std::vector<glm::dvec2> fine_edge(const ShellParams& params) {
  std::vector<glm::dvec2> fine;
  for (int i = 0; i < kEdgeSteps; ++i) {
    double share = static_cast<double>(i) / kEdgeSteps, turn = 2 * kPi * share - kPi;
    if (!params.edge.empty())
      fine.push_back(catmull_rom(params.edge, share * static_cast<double>(params.edge.size())));
    else
      fine.emplace_back(0.5 * (1 + params.distance) + 0.5 * (1 - params.distance) * std::cos(turn),
                        0.5 * (1 - params.distance) * params.aspect * std::sin(turn));
  }
  double area = 0, most = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    glm::dvec2 a = fine[i], b = fine[(i + 1) % fine.size()];
    area += a.x * b.y - a.y * b.x, most = std::max(most, a.x);
  }
  if (area < 0) std::ranges::reverse(fine);
  auto inner = std::ranges::min_element(fine, {}, [](glm::dvec2 p) { return p.x; });
  std::rotate(fine.begin(), inner, fine.end());
  for (glm::dvec2& p : fine) p /= most;
  return fine;
}

/// A round rib: 1 on it, -1 in its groove.
double rib_at(double phase, double broad) {
  return 1 - 2 * std::pow(0.5 - 0.5 * std::cos(2 * kPi * phase), broad);
}

/// Rises slowly with growth and breaks off.
double scute_at(double phase) {
  constexpr double kRising = 0.86, kBreaksOff = 0.14;  // shares of its length
  constexpr double kSlowly = 1.6;                      // power; 1 is even
  double t = phase - std::floor(phase);
  return t < kRising ? std::pow(t / kRising, kSlowly) : (1 - t) / kBreaksOff;
}

/// One line of growth, or of the wall behind the lip.
struct Row {
  double turn = 0;   // radians before the last line
  double raise = 0;  // along the edge's normal
  double ahead = 0;  // along growth
  bool outside = true;
};

class Walls {
 public:
  Walls(const ShellParams& params, const ShellEdge& edge, double grown, bool below)
      : params_(params), edge_(edge), grown_(grown), below_(below) {}

  Vec3 place(const ShellEdge::At& at, const Row& row) const {
    constexpr double kThinnest = 0.15, kThickens = 3;       // of the wall: at the hinge; with the way from it
    constexpr double kLipTurn = 0.5;                        // radians of growth that a flaring lip is long
    constexpr double kFlareFrom = 0.35, kFlareFull = 0.85;  // away from the axis
    double ribs = params_.ribs.height * at.crest, raise = row.raise, ahead = row.ahead;
    if (!row.outside) raise *= std::min(1.0, kThinnest + kThickens * at.away);
    if (row.outside) raise += relief(at, row);
    double lip = 1 - smooth_step(0.0, kLipTurn, row.turn - grown_);
    if (params_.coiled()) {
      raise += ribs + params_.flare * lip * smooth_step(kFlareFrom, kFlareFull, at.out);
    } else {
      ahead += below_ ? -ribs : ribs;
    }
    double size = std::exp(-params_.rate() * row.turn),
           turn = params_.coiled() ? row.turn : row.turn - grown_;
    double out = at.out + raise * at.normal[0];
    double up = at.up + raise * at.normal[1] - params_.translation * edge_.middle;
    double x = size * (out * std::cos(turn) + ahead * std::sin(turn)),
           z = size * (ahead * std::cos(turn) - out * std::sin(turn));
    if (params_.coiled()) return Vec3(x, size * up, z);
    return Vec3(x, below_ ? z : -z, size * up);
  }

  Surface body() const {
    Surface s;
    int laid = 0;
    auto lay = [&](const Row& row, float u_inside) {
      auto count = static_cast<float>(edge_.at.size() - 1);
      float v = 1 - static_cast<float>((row.turn - (row.outside ? 0 : grown_)) / last());
      for (std::size_t i = 0; i < edge_.at.size(); ++i) {
        s.position.push_back(place(edge_.at[i], row));
        s.uv.push_back(
            {row.outside ? kShellOutside * (0.003f + 0.994f * static_cast<float>(i) / count) : u_inside, v});
      }
      ++laid;
    };
    // Lines lie the denser the larger they are.
    int behind = rows_behind(), along = std::max(24, rows() - behind);
    double rate = params_.rate() / 2, least = std::exp(-rate * last());
    for (int j = 0; j <= along; ++j) {
      double share = static_cast<double>(j) / along;
      lay({std::max(grown_, -std::log(least + (1 - least) * share) / rate)}, 0);
    }
    constexpr double kLipBack = 0.35;  // thicknesses of the wall that a valve's margin is cut back inside
    constexpr double kDeepestInside = 0.96;  // of all growth
    constexpr double kDenserAtLip = 1.5;     // power; 1 is even
    double wall = params_.wall, back = kLipBack * wall;
    for (int j = 1; j <= kLipRows; ++j) {
      double round = kPi * j / kLipRows;
      double ahead = params_.coiled() ? 0.5 * wall * std::sin(round) : -back * j / kLipRows;
      lay({grown_, -0.5 * wall * (1 - std::cos(round)), ahead, false}, kShellInside);
    }
    double from = params_.coiled() ? 0 : back,
           depth = std::min(2 * kPi * params_.hollow, kDeepestInside * last() - grown_);
    for (int j = 1; j <= behind; ++j) {
      double share = static_cast<double>(j) / behind;
      lay({grown_ + from + std::max(0.0, depth - from) * std::pow(share, kDenserAtLip), -wall, 0, false},
          kShellInside);
    }
    close(s, laid);
    return s;
  }

 private:
  double last() const { return 2 * kPi * params_.whorls; }
  int rows() const { return static_cast<int>(params_.detail / (2.0 * static_cast<double>(edge_.at.size()))); }
  /// The number of rows of the inside.
  int rows_behind() const { return std::clamp(rows() / 3, 12, params_.coiled() ? 48 : 72); }

  /// The height of costae, which stand across growth, and of scutes on the ribs.
  double relief(const ShellEdge::At& at, const Row& row) const {
    double grown = params_.coiled() ? -row.turn / (2 * kPi) : std::exp(-params_.rate() * row.turn);
    double raise = 0;
    if (params_.costae.count > 0)
      raise += params_.costae.height *
               std::pow(0.5 + 0.5 * std::cos(2 * kPi * grown * params_.costae.count), params_.costae.sharp);
    if (params_.scutes.count > 0) {
      double crest = below_ ? -at.crest : at.crest;
      raise += params_.scutes.height * scute_at(grown * params_.scutes.count) *
               std::pow(std::max(0.0, crest), 1.5);
    }
    // Margins close: nothing stands on them.
    constexpr double kMargin = 0.03;  // radians of growth
    double behind = params_.coiled() ? 1 : smooth_step(0.0, kMargin, row.turn - grown_);
    return raise * at.away * behind;
  }

  /// Triangles from row to row, with a point before the first and behind the last.
  void close(Surface& s, int rows) const {
    auto wide = static_cast<std::uint32_t>(edge_.at.size());
    auto middle = [&](std::uint32_t row) {
      Vec3 sum(0);
      for (std::uint32_t i = 1; i < wide; ++i) sum += s.position[row * wide + i];
      return sum / static_cast<float>(wide - 1);
    };
    auto count = static_cast<std::uint32_t>(rows), first = count * wide;
    Vec3 tip = middle(0), end = middle(count - 1);
    Vec2 tip_uv = s.uv[wide / 2], end_uv = s.uv[first - 1];
    s.position.push_back(tip), s.position.push_back(end);
    s.uv.push_back(tip_uv), s.uv.push_back(end_uv);
    for (std::uint32_t i = 0; i + 1 < wide; ++i) {
      s.triangle.push_back({first, i + 1, i});
      for (std::uint32_t at = i; at + wide < first; at += wide) {
        s.triangle.push_back({at, at + 1, at + wide});
        s.triangle.push_back({at + 1, at + wide + 1, at + wide});
      }
      s.triangle.push_back({first - wide + i, first - wide + i + 1, first + 1});
    }
    if (below_)
      for (auto& t : s.triangle) std::swap(t[1], t[2]);
    set_normals(s);
    for (std::uint32_t at = 0; at < first; at += wide)  // no seam is to be seen
      s.normal[at] = s.normal[at + wide - 1] = glm::normalize(s.normal[at] + s.normal[at + wide - 1]);
  }

  const ShellParams& params_;
  const ShellEdge& edge_;
  double grown_;
  bool below_;
};

}  // namespace

double ShellParams::rate() const { return std::log(expansion) / (2 * kPi); }

ShellEdge shell_edge(const ShellParams& params) {
  std::vector<glm::dvec2> fine = fine_edge(params);
  std::vector<double> run{0};
  for (std::size_t i = 0; i < fine.size(); ++i)
    run.push_back(run.back() + glm::distance(fine[i], fine[(i + 1) % fine.size()]));
  int parts = std::max(72, (params.coiled() ? 6 : 8) * params.ribs.count);
  double farthest = 0;
  for (glm::dvec2 p : fine) farthest = std::max(farthest, glm::length(p));
  ShellEdge edge;
  edge.middle = 0.5 * (fine[0].x + 1);
  std::size_t step = 0;
  for (int i = 0; i < parts; ++i) {
    double share = static_cast<double>(i) / parts;
    while (run[step + 1] < share * run.back()) ++step;
    glm::dvec2 a = fine[step], b = fine[(step + 1) % fine.size()];
    double between = (share * run.back() - run[step]) / std::max(1e-12, run[step + 1] - run[step]);
    glm::dvec2 p = glm::mix(a, b, between), side = glm::normalize(b - a);
    ShellEdge::At at{p.x, p.y, {side.y, -side.x}};
    // Ribs of a valve run out from its hinge at equal angles.
    double phase = params.coiled() ? share : std::atan2(p.y, p.x) / kPi + 0.5;
    if (!params.coiled()) at.away = glm::length(p) / farthest;
    if (params.ribs.count > 0)
      at.crest =
          rib_at(params.ribs.count * phase + 0.5 * (params.ribs.count % 2), params.ribs.broad) * at.away;
    edge.at.push_back(at);
  }
  edge.at.push_back(edge.at.front());
  return edge;
}

double lines_a_cell(const ShellParams& params) {
  ShellEdge edge = shell_edge(params);
  double around = 0;
  for (std::size_t i = 0; i + 1 < edge.at.size(); ++i)
    around += std::hypot(edge.at[i + 1].out - edge.at[i].out, edge.at[i + 1].up - edge.at[i].up);
  double along = 2 * kPi * params.whorls * std::hypot(1, params.rate());
  return along * (params.coiled() ? 0.8 : 0.5) / around;
}

Surface shell_wall(const ShellParams& params, const ShellEdge& edge, double grown, bool below) {
  return Walls(params, edge, grown, below).body();
}

Vec3 shell_margin(const ShellParams& params, const ShellEdge& edge, const ShellEdge::At& at, double grown,
                  bool below) {
  return Walls(params, edge, grown, below).place(at, {grown});
}

}  // namespace frond
