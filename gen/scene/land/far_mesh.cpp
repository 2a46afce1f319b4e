#include "land/far_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "core/parallel.h"

namespace frond {

namespace {

constexpr double kRow = 0.008;       // of the distance, from row to row
constexpr double kRayPixels = 2.4;   // from ray to ray
constexpr double kOutOfView = 0.06;  // radians from ray to ray where no camera looks
constexpr double kPerPixel = 0.45;   // vertices for each pixel, at most
constexpr double kOverlap = 0.995;   // of the radius of the near ground: where rows begin below it
constexpr float kSunk = 0.3f;        // metres that they lie below it there
constexpr double kHiddenBy = 4;      // pixels by which what is hidden lies behind a crest
constexpr double kCanopy = 13;       // metres, mean height of a wood

struct FarVertex {
  Vec3 at{0}, normal{0, 1, 0};
  Vec2 uv{0.5f, 0};  // as on a mountain: how hollow it is, its cover
  FarCover cover = FarCover::meadow;
  bool across = false, hidden = false;
  bool canopy = false;  // raised to the crowns of a wood
};

/// Directions of rays and distances of rows.
struct FarGrid {
  std::vector<double> ray, row;

  FarGrid(const FarLand& land, const FarView& view) {
    double radius = land.edge().radius, reach = std::max(land.shape().reach, 1.5 * radius);
    double wide = view.to - view.from, logs = std::log(reach / radius);
    double step = kRayPixels * view.pixel * (1 - 0.5 * std::min(view.aside / radius, 0.9));
    double count = wide / step * logs / kRow;
    double coarse = std::sqrt(std::max(1.0, count / (kPerPixel * view.pixels)));
    auto rows = std::max(8, static_cast<int>(logs / (kRow * coarse)));
    auto rays = std::max(8, static_cast<int>(wide / (step * coarse)));
    row.push_back(radius * kOverlap);
    for (int i = 0; i <= rows; ++i) row.push_back(radius * std::exp(logs * i / rows));
    for (int i = 0; i <= rays; ++i) ray.push_back(view.from + wide * i / rays);
    auto rest = static_cast<int>((2 * kPi - wide) / (kOutOfView * coarse));
    for (int i = 1; i < rest; ++i) ray.push_back(view.to + (2 * kPi - wide) * i / rest);
  }

  Vec2 at(std::size_t column, std::size_t line) const {
    return Vec2(std::cos(ray[column]), std::sin(ray[column])) * static_cast<float>(row[line]);
  }
  double gap(std::size_t line) const { return row[line] - row[line > 0 ? line - 1 : 0]; }
};

/// Heights of the land at all vertices, ray by ray.
std::vector<double> far_heights(const FarLand& land, const FarGrid& grid) {
  std::size_t rows = grid.row.size();
  std::vector<double> height(grid.ray.size() * rows);
  parallel_for(grid.ray.size(), [&](std::size_t column) {
    for (std::size_t line = 0; line < rows; ++line)
      height[column * rows + line] = land.height(grid.at(column, line), grid.gap(line));
  });
  return height;
}

/// Rise over run of a vertex, by those beside it.
Vec2 far_slope(const FarGrid& grid, const std::vector<double>& height, std::size_t column, std::size_t line) {
  std::size_t rows = grid.row.size(), rays = grid.ray.size();
  std::size_t inner = line > 0 ? line - 1 : 0, outer = std::min(line + 1, rows - 1);
  std::size_t before = (column + rays - 1) % rays, after = (column + 1) % rays;
  double turn = grid.ray[after] - grid.ray[before];
  if (turn <= 0) turn += 2 * kPi;
  double out =
      (height[column * rows + outer] - height[column * rows + inner]) / (grid.row[outer] - grid.row[inner]);
  double round = (height[after * rows + line] - height[before * rows + line]) / (turn * grid.row[line]);
  double cosine = std::cos(grid.ray[column]), sine = std::sin(grid.ray[column]);
  return Vec2(out * cosine - round * sine, out * sine + round * cosine);
}

/// Rise over run by which the land about a vertex is higher, twice a row away.
double far_hollow(const FarGrid& grid, const std::vector<double>& height, std::size_t column,
                  std::size_t line) {
  std::size_t rows = grid.row.size(), rays = grid.ray.size();
  std::size_t inner = line > 2 ? line - 2 : 0, outer = std::min(line + 2, rows - 1);
  double reach = std::max(grid.row[outer] - grid.row[line], 1.0);
  double turn = std::max(grid.ray[(column + 1) % rays] - grid.ray[column], 1e-3);
  auto aside = std::clamp<std::size_t>(static_cast<std::size_t>(reach / (turn * grid.row[line]) + 0.5), 1, 8);
  std::size_t before = (column + rays - aside) % rays, after = (column + aside) % rays;
  double around = height[column * rows + inner] + height[column * rows + outer] +
                  height[before * rows + line] + height[after * rows + line];
  return (around / 4 - height[column * rows + line]) / reach;
}

/// Metres that a canopy rises above the ground at a place `inside` metres from its border, along which single
/// trees stand before it.
double canopy_height(Vec2 at, double inside, double spacing, Seed seed) {
  auto level = static_cast<float>(seed.child("canopy").range(0, 99));
  // Crowns where they show, stands of one age where they do not.
  double crowns = noise(Vec3(at.x / 8, level, at.y / 8)) * (1 - smooth_step(8.0, 40.0, spacing));
  double stands = noise(Vec3(at.x / 90, level + 7, at.y / 90));
  return kCanopy * (1 + 0.18 * crowns + 0.16 * stands) * smooth_step(9.0, 24.0, inside);
}

FarVertex far_vertex(const FarLand& land, const MountainPlace& place, double spacing, Seed seed) {
  FarVertex v;
  auto [at, height, slope, hollow] = place;
  bool near = land.edge().outside(at) < 0;
  Parcel parcel = land.parcel(at);
  v.cover = land.cover(at, parcel, height, slope);
  v.across = parcel.across;
  v.normal = glm::normalize(Vec3(-slope.x, 1, -slope.y));
  if (near) height -= static_cast<double>(kSunk);
  double inside = 0, canopy = 0;  // metres into a wood; the share of its height
  if (v.cover == FarCover::wood) {
    // A wood that goes on behind the border has no edge there.
    Parcel beyond = land.parcel(parcel.next);
    inside = land.wooded(beyond) ? 1e3 : parcel.edge, canopy = 1;
  } else if (v.cover == FarCover::mountain) {
    double cover = mountain_cover_at(land.shape().lines(), place);
    v.uv = Vec2(std::clamp(0.5 + 0.5 * hollow, 0.0, 1.0), cover);
    inside = 1e3, canopy = 1 - smooth_step(0.02, 0.14, cover);
  }
  if (canopy > 0) {
    // The near ground is open, so a wood at its edge is seen from the side there.
    inside = std::min(inside, land.edge().outside(at));
    // Trees become small toward their line.
    double size = 1 - smooth_step(land.shape().tree_line - 400, land.shape().tree_line + 100, height);
    Vec3 bumps = noise3(Vec3(at.x, 0, at.y) / 9.0f);
    v.normal = glm::normalize(v.normal + static_cast<float>(0.45 * canopy) * Vec3(bumps.x, 0, bumps.z));
    double crowns = canopy * size * canopy_height(at, inside, spacing, seed);
    v.canopy = v.cover == FarCover::wood && crowns > 1;
    height += crowns;
  }
  v.at = Vec3(at.x, height, at.y);
  return v;
}

/// Along a ray: what lies behind a higher crest as seen from the highest camera.
void hide(std::vector<FarVertex>& ray, const FarView& view) {
  double crest = -1e9;
  for (FarVertex& v : ray) {
    double away = std::max<double>(1, glm::length(Vec2(v.at.x, v.at.z)));
    double up = (static_cast<double>(v.at.y) - view.eye) / away;
    v.hidden = away > 4 * view.aside && up < crest - kHiddenBy * view.pixel;
    crest = std::max(crest, up);
  }
}

/// Puts triangles into the part of their cover, each vertex of it once.
class FarParts {
 public:
  explicit FarParts(std::size_t vertices)
      : index_(2 * kFarCovers, std::vector<std::uint32_t>(vertices, UINT32_MAX)) {
    for (int i = 0; i < 2 * kFarCovers; ++i) parts_.push_back({static_cast<FarCover>(i / 2), i % 2 == 1, {}});
  }

  /// A triangle with the cover of one of the vertices, or of a canopy that it comes down from.
  void add(const std::vector<FarVertex>& all, std::size_t of, std::array<std::size_t, 3> corners) {
    auto raised = std::ranges::find_if(corners, [&](std::size_t corner) { return all[corner].canopy; });
    const FarVertex& first = all[raised == corners.end() ? of : *raised];
    auto which = static_cast<std::size_t>(2 * static_cast<int>(first.cover) + first.across);
    Surface& s = parts_[which].surface;
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& number = index_[which][corners[k]];
      if (number == UINT32_MAX) {
        number = static_cast<std::uint32_t>(s.position.size());
        s.position.push_back(all[corners[k]].at);
        s.normal.push_back(all[corners[k]].normal);
        if (first.cover == FarCover::mountain) s.uv.push_back(all[corners[k]].uv);
      }
      triangle[k] = number;
    }
    s.triangle.push_back(triangle);
  }

  std::vector<FarPart> finish() && {
    std::erase_if(parts_, [](const FarPart& part) { return part.surface.triangle.empty(); });
    return std::move(parts_);
  }

 private:
  std::vector<FarPart> parts_;
  std::vector<std::vector<std::uint32_t>> index_;
};

}  // namespace

bool FarView::holds(Vec2 at) const {
  double turn = std::atan2(static_cast<double>(at.y), static_cast<double>(at.x));
  while (turn < from) turn += 2 * kPi;
  return turn <= to;
}

std::vector<FarPart> far_mesh(const FarLand& land, const FarView& view, Seed seed) {
  FarGrid grid(land, view);
  std::size_t rays = grid.ray.size(), rows = grid.row.size();
  std::vector<double> height = far_heights(land, grid);
  std::vector<FarVertex> all(rays * rows);
  parallel_for(rays, [&](std::size_t column) {
    std::vector<FarVertex> ray;
    for (std::size_t line = 0; line < rows; ++line)
      ray.push_back(
          far_vertex(land,
                     {grid.at(column, line), height[column * rows + line],
                      far_slope(grid, height, column, line), far_hollow(grid, height, column, line)},
                     grid.gap(line), seed));
    hide(ray, view);
    std::ranges::move(ray, all.begin() + static_cast<std::ptrdiff_t>(column * rows));
  });
  FarParts parts(all.size());
  for (std::size_t column = 0; column < rays; ++column) {
    std::size_t next = (column + 1) % rays;
    for (std::size_t line = 0; line + 1 < rows; ++line) {
      std::size_t a = column * rows + line, b = a + 1, c = next * rows + line, d = c + 1;
      if (all[a].hidden && all[b].hidden && all[c].hidden && all[d].hidden) continue;
      parts.add(all, a, {a, c, b});
      parts.add(all, a, {d, b, c});
    }
  }
  return std::move(parts).finish();
}

}  // namespace frond
