#include "land/terrain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/noise.h"
#include "core/parallel.h"
#include "land/hills.h"

namespace frond {

namespace {

constexpr double kFinest = 0.75;   // metres from line to line in the sown square
constexpr int kInner = 215;        // lines at most across it
constexpr int kOuter = 43;         // lines beyond it, on each side
constexpr double kHorizon = 1200;  // metres, at least

/// The lines of the grid: even across the sown square, beyond it each gap wider than the last by one factor.
std::vector<float> grid_lines(double size) {
  int gaps = std::clamp(static_cast<int>(std::ceil(size / kFinest)), 2, kInner - 1);
  double step = size / gaps, beyond = std::max(kHorizon, 2 * size) - size / 2;
  // The factor by halving: the gaps' sum rises with it.
  double low = 1, high = 3;
  for (int i = 0; i < 60; ++i) {
    double factor = (low + high) / 2, sum = 0, gap = step;
    for (int k = 0; k < kOuter; ++k) sum += gap *= factor;
    (sum < beyond ? low : high) = factor;
  }
  std::vector<float> line;
  for (int i = 0; i <= gaps; ++i) line.push_back(static_cast<float>(i * step - size / 2));
  double at = size / 2, gap = step;
  for (int k = 0; k < kOuter; ++k) {
    at += gap *= high;
    line.push_back(static_cast<float>(at));
    line.insert(line.begin(), static_cast<float>(-at));
  }
  return line;
}

/// The hills of a terrain.
struct Hills {
  const TerrainShape& shape;
  Seed seed;
  double low = 0, scale = 1;

  /// As noise gives it, without what lines `spacing` metres apart cannot show.
  double raw(Vec2 at, double spacing) const {
    return eroded_hill_noise(at, shape.hill_size, shape.rough, shape.erosion, spacing, seed);
  }

  /// Finds what makes the lowest 0 and the highest `hills`, `spacing` metres being between lines.
  void level(double spacing) {
    constexpr int kSamples = 96;
    double side = std::max(shape.size, 2 * shape.hill_size), high = -1e9;
    low = 1e9;
    std::vector<std::array<double, 2>> ends(kSamples + 1);
    parallel_for(ends.size(), [&](std::size_t row) {
      ends[row] = {1e9, -1e9};
      for (int column = 0; column <= kSamples; ++column) {
        Vec2 at((static_cast<double>(column) / kSamples - 0.5) * side,
                (static_cast<double>(row) / kSamples - 0.5) * side);
        double h = raw(at, spacing);
        ends[row] = {std::min(ends[row][0], h), std::max(ends[row][1], h)};
      }
    });
    for (auto [least, most] : ends) low = std::min(low, least), high = std::max(high, most);
    scale = shape.hills / std::max(high - low, 1e-6);
  }

  double operator()(Vec2 at, double spacing) const {
    double height = (raw(at, spacing) - low) * scale;
    // Far off hills are larger, so that they show above the near ones; mountains are large enough.
    double out = std::max(std::abs(at.x), std::abs(at.y)) - shape.size / 2;
    if (out <= 0 || shape.erosion > 0) return height;
    double far = smooth_step(0.0, 600.0, out);
    Vec3 p(at.x / (6 * shape.hill_size), seed.child("far").range(0, 99), at.y / (6 * shape.hill_size));
    return height + far * shape.hills * (0.6 + 1.8 * noise(p));
  }
};

/// How the path lies in the land: along it as the hills rise, a little smoothed, and level across.
struct PathBed {
  const Plot& plot;
  double level, shoulder;  // metres from the middle, and on from there
  double blur;
  std::vector<Vec3> bed;  // places along the middle

  PathBed(const Plot& path, double width, double spacing, const Hills& hills)
      : plot(path),
        // A triangle that touches the path lies flat as a whole.
        level(width / 2 + 1.5 * spacing + 0.15),
        shoulder(std::max(4.0, 2 * width)),
        blur(std::max(3.0, width)) {
    const std::vector<Vec2>& line = plot.path();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      int pieces = std::max(1, static_cast<int>(glm::distance(line[i], line[i + 1])));
      for (int k = 0; k < pieces; ++k) {
        Vec2 at = line[i] + (line[i + 1] - line[i]) * (static_cast<float>(k) / static_cast<float>(pieces));
        bed.emplace_back(at.x, hills(at, std::max(spacing, 2.0)), at.y);
      }
    }
    for (int i = 0; i < 3; ++i) smooth_along();
  }

  /// Each the mean of those up to 5 m away: three times is about a bell curve.
  void smooth_along() {
    std::vector<Vec3> before = bed;
    std::ptrdiff_t count = std::ssize(bed);
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      std::ptrdiff_t reach = std::min({std::ptrdiff_t{5}, i, count - 1 - i});
      double sum = 0;
      for (std::ptrdiff_t k = i - reach; k <= i + reach; ++k) sum += before[static_cast<std::size_t>(k)].y;
      bed[static_cast<std::size_t>(i)].y = static_cast<float>(sum / static_cast<double>(2 * reach + 1));
    }
  }

  double operator()(Vec2 at, double land) const {
    if (bed.empty()) return land;
    double away = plot.path_middle_distance(at);
    if (away >= level + shoulder) return land;
    // The mean of what is near, rather than the nearest: inside a bend that jumps.
    double sum = 0, weights = 0;
    for (const Vec3& p : bed) {
      double d = glm::distance(Vec2(p.x, p.z), at);
      double weight = std::exp((away * away - d * d) / (blur * blur));
      sum += weight * p.y;
      weights += weight;
    }
    // Where the samples lie apart none may be near.
    double height = weights > 1e-12 ? sum / weights : land;
    return height + (land - height) * smooth_step(level, level + shoulder, away);
  }
};

}  // namespace

Terrain::Terrain(const TerrainShape& shape, Seed seed)
    : plot_(PondShape{}, shape.path, seed.child("path")), line_(grid_lines(shape.size)) {
  std::size_t lines = line_.size();
  auto gap = [&](std::size_t i) {
    std::size_t next = std::min(i + 1, lines - 1);
    return static_cast<double>(line_[next] - line_[next - 1]);
  };
  double finest = gap(lines / 2);
  Hills hills{shape, seed.child("hills")};
  hills.level(finest);
  PathBed path(plot_, shape.path.width, finest, hills);
  auto without_stream = [&](Vec2 at, double spacing) { return path(at, hills(at, spacing)); };
  stream_ = StreamCourse(
      shape.stream, shape.size, [&](Vec2 at) { return without_stream(at, std::max(finest, 2.0)); },
      seed.child("stream"));
  height_.resize(lines * lines);
  parallel_for(lines, [&](std::size_t row) {
    for (std::size_t column = 0; column < lines; ++column) {
      Vec2 at(line_[column], line_[row]);
      height_[vertex(column, row)] = static_cast<float>(
          stream_.ground(at, without_stream(at, std::max({finest, gap(column), gap(row)}))));
    }
  });
  auto middle = static_cast<float>(height(0, 0));
  for (float& h : height_) h -= middle;
  stream_.raise(-middle);
}

Vec3 Terrain::normal(std::size_t column, std::size_t row) const {
  auto ends = [&](std::size_t i) { return std::pair(i > 0 ? i - 1 : 0, std::min(i + 1, line_.size() - 1)); };
  auto [left, right] = ends(column);
  auto [back, front] = ends(row);
  float x = (height_[vertex(right, row)] - height_[vertex(left, row)]) / (line_[right] - line_[left]);
  float z = (height_[vertex(column, front)] - height_[vertex(column, back)]) / (line_[front] - line_[back]);
  return glm::normalize(Vec3(-x, 1, -z));
}

double Terrain::height(double x, double z) const {
  // In which cell a place lies, and how far along it.
  auto find = [&](double value) {
    double held = std::clamp<double>(value, line_.front(), line_.back());
    auto after = std::upper_bound(line_.begin() + 1, line_.end() - 1, static_cast<float>(held));
    auto i = static_cast<std::size_t>(after - line_.begin()) - 1;
    return std::pair(i, std::clamp((held - line_[i]) / (line_[i + 1] - line_[i]), 0.0, 1.0));
  };
  auto [column, s] = find(x);
  auto [row, t] = find(z);
  std::size_t here = vertex(column, row), front = here + line_.size();
  double a = height_[here], b = height_[here + 1], c = height_[front], d = height_[front + 1];
  // Over the triangle that the place lies in.
  return s + t <= 1 ? a + (b - a) * s + (c - a) * t : d + (c - d) * (1 - s) + (b - d) * (1 - t);
}

Surface Terrain::surface() const {
  Surface surface;
  std::size_t lines = line_.size();
  for (std::size_t row = 0; row < lines; ++row)
    for (std::size_t column = 0; column < lines; ++column) {
      surface.position.emplace_back(line_[column], height_[vertex(column, row)], line_[row]);
      surface.normal.push_back(normal(column, row));
    }
  for (std::size_t row = 0; row + 1 < lines; ++row)
    for (std::size_t column = 0; column + 1 < lines; ++column) {
      auto a = static_cast<std::uint32_t>(vertex(column, row)), b = a + 1,
           c = a + static_cast<std::uint32_t>(lines), d = c + 1;
      surface.triangle.push_back({a, c, b});
      surface.triangle.push_back({b, c, d});
    }
  return surface;
}

}  // namespace frond
