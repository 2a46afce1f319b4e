#include "masonry/wall_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/noise.h"

namespace frond {

bool FaceGrid::cell(std::ptrdiff_t column, std::ptrdiff_t row) const {
  auto columns = static_cast<std::ptrdiff_t>(x.size()) - 1, rows = static_cast<std::ptrdiff_t>(y.size()) - 1;
  if (column < 0 || row < 0 || column >= columns || row >= rows) return false;
  return solid[row * columns + column];
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
      s.position.emplace_back(grid.x[i] + inset * right, grid.y[j] + inset * up, side ? half : -half);
    }
    return place->second;
  };
  for (std::ptrdiff_t j = 0; j < rows; ++j) {
    for (std::ptrdiff_t i = 0; i < columns; ++i) {
      if (!grid.cell(i, j)) continue;
      auto v = [&](int di, int dj, int side) { return vertex(i + di, j + dj, side); };
      add_quad(s, v(0, 0, 1), v(1, 0, 1), v(1, 1, 1), v(0, 1, 1));
      add_quad(s, v(1, 0, 0), v(0, 0, 0), v(0, 1, 0), v(1, 1, 0));
      if (!grid.cell(i - 1, j)) add_quad(s, v(0, 0, 0), v(0, 0, 1), v(0, 1, 1), v(0, 1, 0));
      if (!grid.cell(i + 1, j)) add_quad(s, v(1, 0, 1), v(1, 0, 0), v(1, 1, 0), v(1, 1, 1));
      if (!grid.cell(i, j - 1)) add_quad(s, v(0, 0, 0), v(1, 0, 0), v(1, 0, 1), v(0, 0, 1));
      if (!grid.cell(i, j + 1)) add_quad(s, v(0, 1, 1), v(1, 1, 1), v(1, 1, 0), v(0, 1, 0));
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

/// Timber of windows and doors. Its sizes are in metres and by eye.
class Joiner {
 public:
  Joiner(std::vector<WallBlock>& blocks, const Joinery& hole) : blocks_(blocks), hole_(hole) {
    constexpr double kReveal = 0.11, kMostReveal = 0.55;  // behind the wall's face; at most, of its thickness
    z_ = hole.thickness / 2 - std::min(kReveal, kMostReveal * hole.thickness);
  }

  void add(WallPart part, double left, double right, double low, double high, double z, double deep) {
    if (right <= left || high <= low) return;
    WallBlock block{part};
    block.middle = Vec3((left + right) / 2, (low + high) / 2, z_ + z);
    block.size = Vec3(right - left, high - low, deep);
    blocks_.push_back(block);
  }

  /// Members round an opening, of which the lowest, `foot` wide, is left out where that is 0.
  void members(double l, double r, double low, double high, double wide, double foot, double z, double deep) {
    add(WallPart::wood, l, l + wide, low, high, z, deep);
    add(WallPart::wood, r - wide, r, low, high, z, deep);
    add(WallPart::wood, l + wide, r - wide, high - wide, high, z, deep);
    add(WallPart::wood, l + wide, r - wide, low, low + foot, z, deep);
  }

  void frame(double wide, double deep) {
    members(hole_.left, hole_.right, hole_.low, hole_.high, wide, hole_.door ? 0 : wide, 0, deep);
  }

  /// A pane with its own frame and bars.
  void sash(double l, double r, double low, double high) {
    constexpr double kWide = 0.04, kFootWide = 1.4 * kWide;  // of its members, and of the lowest
    constexpr double kProud = 0.008, kDeep = 0.042;          // before the plane of the pane; through it
    constexpr double kBar = 0.022, kBarDeep = 0.03;
    constexpr double kGlass = 0.006, kLetIn = 0.004;      // thickness; how far it reaches into the members
    constexpr double kPaneHigh = 0.42, kPaneWide = 0.46;  // between bars, about
    members(l, r, low, high, kWide, kFootWide, kProud, kDeep);
    double x0 = l + kWide, x1 = r - kWide, y0 = low + kFootWide, y1 = high - kWide;
    add(WallPart::pane, x0 - kLetIn, x1 + kLetIn, y0 - kLetIn, y1 + kLetIn, 0, kGlass);
    int rows = std::max(1, static_cast<int>(std::lround((y1 - y0) / kPaneHigh)));
    int columns = std::max(1, static_cast<int>(std::lround((x1 - x0) / kPaneWide)));
    // Level bars are a millimetre before upright ones.
    for (int i = 1; i < rows; ++i) {
      double y = y0 + (y1 - y0) * i / rows;
      add(WallPart::wood, x0, x1, y - kBar / 2, y + kBar / 2, 0.006, kBarDeep);
    }
    for (int i = 1; i < columns; ++i) {
      double x = x0 + (x1 - x0) * i / columns;
      add(WallPart::wood, x - kBar / 2, x + kBar / 2, y0, y1, 0.005, kBarDeep);
    }
  }

  void window() {
    constexpr double kWide = 0.055, kDeep = 0.075;  // of the frame
    constexpr double kWidestSash = 0.7, kBetween = 0.004;
    frame(kWide, kDeep);
    double l = hole_.left + kWide, r = hole_.right - kWide, low = hole_.low + kWide,
           high = hole_.high - kWide;
    if (r - l > kWidestSash) {
      double middle = (l + r) / 2;
      sash(l, middle - kBetween / 2, low, high);
      sash(middle + kBetween / 2, r, low, high);
    } else {
      sash(l, r, low, high);
    }
  }

  void door() {
    constexpr double kWide = 0.07, kDeep = 0.09;  // of the frame
    constexpr double kAboveGround = 0.012;
    constexpr double kPlank = 0.13, kThick = 0.035, kBetween = 0.004;  // of planks, side by side
    constexpr double kUneven = 0.0015;  // how far planks lie before and behind the middle, in turn
    constexpr double kLedge = 0.11, kLedgeDeep = 0.03, kFromEdge = 0.02;  // of the bars across them
    frame(kWide, kDeep);
    double l = hole_.left + kWide, r = hole_.right - kWide;
    double low = hole_.low + kAboveGround, high = hole_.high - kWide;
    int planks = std::max(2, static_cast<int>(std::lround((r - l) / kPlank)));
    for (int i = 0; i < planks; ++i) {
      double from = l + (r - l) * i / planks, to = l + (r - l) * (i + 1) / planks;
      add(WallPart::wood, from + kBetween / 2, to - kBetween / 2, low, high, i % 2 ? kUneven : -kUneven,
          kThick);
    }
    for (double share : {0.12, 0.86}) {  // of the door's height
      double y = low + share * (high - low);
      add(WallPart::wood, l + kFromEdge, r - kFromEdge, y - kLedge / 2, y + kLedge / 2, 0.03, kLedgeDeep);
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
  // Metres, where nothing else is said; by eye.
  constexpr float kMostRound = 0.22f;                         // radius of edges: at most, of the least side
  constexpr float kNewRound = 0.0025f, kWornRound = 0.0045f;  // radius of edges: new, and by wear
  constexpr float kChip = 0.0035f, kDent = 0.0012f;           // depths: of broken edges by wear, and of dents
  constexpr float kChips = 38.0f, kDents = 55.0f;             // number a metre, about
  constexpr float kMesh = 0.03f;                              // from point to point
  constexpr float kBend = 0.4f;  // of the radius: the first line of points beside an edge
  Vec3 half = 0.5f * size;
  float least = std::min({size.x, size.y, size.z});
  float round = std::min(kMostRound * least, kNewRound + kWornRound * static_cast<float>(wear));
  auto lines = [&](float h) {
    int inner = std::clamp(static_cast<int>(std::lround(2 * h / kMesh)), 2, 9);
    std::vector<float> at{-h, -h + kBend * round};
    for (int i = 0; i <= inner; ++i)
      at.push_back((h - round) * (2 * static_cast<float>(i) / static_cast<float>(inner) - 1));
    at.push_back(h - kBend * round), at.push_back(h);
    return at;
  };
  std::vector<float> xs = lines(half.x), ys = lines(half.y), zs = lines(half.z);
  float shift = static_cast<float>(seed.child("shift").range(-99, 99));
  float chip = kChip * static_cast<float>(wear), dent = kDent * static_cast<float>(0.3 + wear);

  Surface s;
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, std::uint32_t> known;
  auto vertex = [&](std::size_t i, std::size_t j, std::size_t k) {
    auto [place, fresh] = known.try_emplace({i, j, k}, static_cast<std::uint32_t>(s.position.size()));
    if (fresh) {
      Vec3 p(xs[i], ys[j], zs[k]), core = glm::clamp(p, -(half - round), half - round), out = p - core;
      Vec3 direction = glm::normalize(out);
      // Edges and corners are rounded, more where something has struck them.
      float edge = (std::abs(out.x) > 0) + (std::abs(out.y) > 0) + (std::abs(out.z) > 0) > 1 ? 1.0f : 0.0f;
      float struck = static_cast<float>(std::max(0.0, fractal_noise(p * kChips + shift, 2)));
      float reach = round + dent * static_cast<float>(noise(p * kDents - shift)) - edge * chip * struck;
      s.position.push_back((core + direction * reach) / size);
    }
    return place->second;
  };
  auto face = [&](auto corner, std::size_t nu, std::size_t nv) {
    for (std::size_t u = 0; u + 1 < nu; ++u)
      for (std::size_t v = 0; v + 1 < nv; ++v) {
        std::uint32_t a = corner(u, v), b = corner(u + 1, v), c = corner(u + 1, v + 1), d = corner(u, v + 1);
        add_quad(s, a, b, c, d);
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
