#include "masonry/wall_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/noise.h"
#include "geometry/crease.h"

namespace frond {

bool FaceGrid::cell(std::ptrdiff_t column, std::ptrdiff_t row) const {
  auto columns = static_cast<std::ptrdiff_t>(x.size()) - 1, rows = static_cast<std::ptrdiff_t>(y.size()) - 1;
  if (column < 0 || row < 0 || column >= columns || row >= rows) return false;
  return solid[static_cast<std::size_t>(row * columns + column)];
}

bool FaceGrid::at(double along, double height) const {
  auto index = [](const std::vector<double>& lines, double value) {
    return std::upper_bound(lines.begin(), lines.end(), value) - lines.begin() - 1;
  };
  return cell(index(x, along), index(y, height));
}

Surface extruded(const FaceGrid& grid, double half, double inset) {
  Surface s;
  std::map<std::tuple<std::ptrdiff_t, std::ptrdiff_t, int>, std::uint32_t> known;
  auto columns = static_cast<std::ptrdiff_t>(grid.x.size()) - 1;
  auto rows = static_cast<std::ptrdiff_t>(grid.y.size()) - 1;
  auto vertex = [&](std::ptrdiff_t i, std::ptrdiff_t j, int side) {
    auto [place, fresh] = known.try_emplace({i, j, side}, static_cast<std::uint32_t>(s.position.size()));
    if (fresh) {
      // Toward the solid cells round the corner.
      int a = grid.cell(i - 1, j - 1), b = grid.cell(i, j - 1), c = grid.cell(i - 1, j), d = grid.cell(i, j);
      double right = std::clamp(b + d - a - c, -1, 1), up = std::clamp(c + d - a - b, -1, 1);
      s.position.emplace_back(grid.x[static_cast<std::size_t>(i)] + inset * right,
                              grid.y[static_cast<std::size_t>(j)] + inset * up, side ? half : -half);
    }
    return place->second;
  };
  auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    s.triangle.push_back({a, b, c});
    s.triangle.push_back({a, c, d});
  };
  for (std::ptrdiff_t j = 0; j < rows; ++j) {
    for (std::ptrdiff_t i = 0; i < columns; ++i) {
      if (!grid.cell(i, j)) continue;
      auto v = [&](int di, int dj, int side) { return vertex(i + di, j + dj, side); };
      quad(v(0, 0, 1), v(1, 0, 1), v(1, 1, 1), v(0, 1, 1));
      quad(v(1, 0, 0), v(0, 0, 0), v(0, 1, 0), v(1, 1, 0));
      if (!grid.cell(i - 1, j)) quad(v(0, 0, 0), v(0, 0, 1), v(0, 1, 1), v(0, 1, 0));
      if (!grid.cell(i + 1, j)) quad(v(1, 0, 1), v(1, 0, 0), v(1, 1, 0), v(1, 1, 1));
      if (!grid.cell(i, j - 1)) quad(v(0, 0, 0), v(1, 0, 0), v(1, 0, 1), v(0, 0, 1));
      if (!grid.cell(i, j + 1)) quad(v(0, 1, 1), v(1, 1, 1), v(1, 1, 0), v(0, 1, 0));
    }
  }
  set_normals(s);
  return s;
}

void append_box(Surface& to, Vec3 middle, Vec3 size) {
  FaceGrid one{{-0.5 * size.x, 0.5 * size.x}, {-0.5 * size.y, 0.5 * size.y}, {true}};
  Surface box = extruded(one, 0.5 * size.z, 0);
  for (Vec3& p : box.position) p += middle;
  append(to, box);
}

namespace {

class Joiner {
 public:
  Joiner(std::vector<WallBlock>& blocks, const Joinery& hole) : blocks_(blocks), hole_(hole) {
    z_ = hole.thickness / 2 - std::min(0.11, 0.55 * hole.thickness);
  }

  void add(WallPart part, double left, double right, double low, double high, double z, double deep) {
    if (right <= left || high <= low) return;
    WallBlock block{part};
    block.middle = Vec3((left + right) / 2, (low + high) / 2, z_ + z);
    block.size = Vec3(right - left, high - low, deep);
    blocks_.push_back(block);
  }

  /// Four members round the hole.
  void frame(double wide, double deep) {
    auto [l, r, low, high, thickness, door] = hole_;
    add(WallPart::wood, l, l + wide, low, high, 0, deep);
    add(WallPart::wood, r - wide, r, low, high, 0, deep);
    add(WallPart::wood, l + wide, r - wide, high - wide, high, 0, deep);
    if (!door) add(WallPart::wood, l + wide, r - wide, low, low + wide, 0, deep);
  }

  /// A pane with its own frame and bars.
  void sash(double l, double r, double low, double high) {
    double wide = 0.04, bar = 0.022;
    add(WallPart::wood, l, l + wide, low, high, 0.008, 0.042);
    add(WallPart::wood, r - wide, r, low, high, 0.008, 0.042);
    add(WallPart::wood, l + wide, r - wide, high - wide, high, 0.008, 0.042);
    add(WallPart::wood, l + wide, r - wide, low, low + 1.4 * wide, 0.008, 0.042);
    double x0 = l + wide, x1 = r - wide, y0 = low + 1.4 * wide, y1 = high - wide;
    add(WallPart::pane, x0 - 0.004, x1 + 0.004, y0 - 0.004, y1 + 0.004, 0, 0.006);
    int rows = std::max(1, static_cast<int>(std::lround((y1 - y0) / 0.42)));
    int columns = std::max(1, static_cast<int>(std::lround((x1 - x0) / 0.46)));
    for (int i = 1; i < rows; ++i) {
      double y = y0 + (y1 - y0) * i / rows;
      add(WallPart::wood, x0, x1, y - bar / 2, y + bar / 2, 0.006, 0.03);
    }
    for (int i = 1; i < columns; ++i) {
      double x = x0 + (x1 - x0) * i / columns;
      add(WallPart::wood, x - bar / 2, x + bar / 2, y0, y1, 0.005, 0.03);
    }
  }

  void window() {
    double wide = 0.055;
    frame(wide, 0.075);
    double l = hole_.left + wide, r = hole_.right - wide, low = hole_.low + wide, high = hole_.high - wide;
    if (r - l > 0.7) {
      double middle = (l + r) / 2;
      sash(l, middle - 0.002, low, high);
      sash(middle + 0.002, r, low, high);
    } else {
      sash(l, r, low, high);
    }
  }

  void door() {
    double wide = 0.07;
    frame(wide, 0.09);
    double l = hole_.left + wide, r = hole_.right - wide, low = hole_.low + 0.012, high = hole_.high - wide;
    int planks = std::max(2, static_cast<int>(std::lround((r - l) / 0.13)));
    for (int i = 0; i < planks; ++i) {
      double from = l + (r - l) * i / planks, to = l + (r - l) * (i + 1) / planks;
      add(WallPart::wood, from + 0.002, to - 0.002, low, high, i % 2 ? 0.0015 : -0.0015, 0.035);
    }
    for (double share : {0.12, 0.86}) {
      double y = low + share * (high - low);
      add(WallPart::wood, l + 0.02, r - 0.02, y - 0.055, y + 0.055, 0.03, 0.03);
    }
  }

 private:
  std::vector<WallBlock>& blocks_;
  const Joinery& hole_;
  double z_;  // of the plane that it stands in
};

}  // namespace

void append_joinery(std::vector<WallBlock>& blocks, const Joinery& hole) {
  Joiner joiner(blocks, hole);
  if (hole.door)
    joiner.door();
  else
    joiner.window();
}

Surface worn_block(Vec3 size, double wear, Seed seed) {
  Vec3 half = 0.5f * size;
  float least = std::min({size.x, size.y, size.z});
  float round = std::min(0.22f * least, 0.0025f + 0.0045f * static_cast<float>(wear));
  auto lines = [&](float h) {
    int inner = std::clamp(static_cast<int>(std::lround(2 * h / 0.03f)), 2, 9);
    std::vector<float> at{-h, -h + 0.4f * round};
    for (int i = 0; i <= inner; ++i)
      at.push_back((h - round) * (2 * static_cast<float>(i) / static_cast<float>(inner) - 1));
    at.push_back(h - 0.4f * round), at.push_back(h);
    return at;
  };
  std::vector<float> xs = lines(half.x), ys = lines(half.y), zs = lines(half.z);
  float shift = static_cast<float>(seed.child("shift").range(-99, 99));
  float chip = 0.0035f * static_cast<float>(wear), dent = 0.0012f * static_cast<float>(0.3 + wear);

  Surface s;
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, std::uint32_t> known;
  auto vertex = [&](std::size_t i, std::size_t j, std::size_t k) {
    auto [place, fresh] = known.try_emplace({i, j, k}, static_cast<std::uint32_t>(s.position.size()));
    if (fresh) {
      Vec3 p(xs[i], ys[j], zs[k]), core = glm::clamp(p, -(half - round), half - round), out = p - core;
      Vec3 direction = glm::normalize(out);
      // Edges and corners are rounded, more where something has struck them.
      float edge = (std::abs(out.x) > 0) + (std::abs(out.y) > 0) + (std::abs(out.z) > 0) > 1 ? 1.0f : 0.0f;
      float struck = static_cast<float>(std::max(0.0, fractal_noise(p * 38.0f + shift, 2)));
      float reach = round + dent * static_cast<float>(noise(p * 55.0f - shift)) - edge * chip * struck;
      s.position.push_back((core + direction * reach) / size);
    }
    return place->second;
  };
  auto face = [&](auto corner, std::size_t nu, std::size_t nv) {
    for (std::size_t u = 0; u + 1 < nu; ++u)
      for (std::size_t v = 0; v + 1 < nv; ++v) {
        std::uint32_t a = corner(u, v), b = corner(u + 1, v), c = corner(u + 1, v + 1), d = corner(u, v + 1);
        s.triangle.push_back({a, b, c});
        s.triangle.push_back({a, c, d});
      }
  };
  std::size_t nx = xs.size(), ny = ys.size(), nz = zs.size();
  face([&](auto u, auto v) { return vertex(u, v, nz - 1); }, nx, ny);
  face([&](auto u, auto v) { return vertex(v, u, 0); }, ny, nx);
  face([&](auto u, auto v) { return vertex(nx - 1, u, v); }, ny, nz);
  face([&](auto u, auto v) { return vertex(0, v, u); }, nz, ny);
  face([&](auto u, auto v) { return vertex(v, ny - 1, u); }, nz, nx);
  face([&](auto u, auto v) { return vertex(u, 0, v); }, nx, nz);

  // Normals as they are at the block's true size.
  Surface sized = s;
  for (Vec3& p : sized.position) p *= size;
  set_normals(sized);
  for (std::size_t i = 0; i < s.position.size(); ++i)
    sized.normal[i] = glm::normalize(sized.normal[i] * size);
  s.normal = std::move(sized.normal);
  return s;
}

}  // namespace frond
