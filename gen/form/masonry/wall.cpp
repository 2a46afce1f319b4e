#include "masonry/wall.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "masonry/wall_parts.h"

namespace frond {

namespace {

/// A rectangle of the wall's face that bricks leave free.
struct Region {
  double left, right, low, high;
  bool open;  ///< nothing is there; else a stone
};

/// A brick of one course, from joint to joint.
struct Run {
  double left, right;
};

// Sizes are in metres and by eye.

constexpr double kBeside = 0.01;     // from a brick's end, where a neighbour is looked for
constexpr double kMeets = 0.05;      // width of what must lie below a brick to bear it
constexpr double kFallen = 0.3;      // share of bricks that are gone where a ruin ends
constexpr double kCopingOut = 0.03;  // by which the coping is wider than the wall

/// A stone over or under an opening: how far it goes into the wall on either side, and stands out of it.
struct DressedStone {
  double bearing, front, back;
};
constexpr DressedStone kLintel{0.14, 0.012, 0.012}, kSill{0.06, 0.055, 0.01};

/// How unevenly bricks lie at wear 1, at most.
struct Unevenness {
  double off, lean;  ///< metres out of the face, radians
};
constexpr Unevenness kUnevenWall{0.0035, radians(0.9)}, kUnevenCoping{0.006, radians(1.3)};

class WallMason {
 public:
  WallMason(const WallShape& shape, Seed seed) : s_(shape), seed_(seed) {
    course_ = s_.brick.y + s_.joint;
    courses_ = std::max(1, static_cast<int>(std::lround(s_.height / course_)));
    constexpr double kMayLack = 0.2;  // of a brick's depth
    int fits = static_cast<int>((s_.thickness + s_.joint) / (s_.brick.z + s_.joint) + kMayLack);
    leaves_ = std::max(1, fits);
    depth_ = (s_.thickness - (leaves_ - 1) * s_.joint) / leaves_;
  }

  Wall build() {
    for (const WallOpening& opening : s_.openings) frame(opening);
    std::vector<std::vector<Run>> rows;
    for (int row = 0; row < courses_; ++row) {
      rows.push_back(lay_course(row));
      if (row > 0 && s_.ruin > 0)
        std::erase_if(rows.back(),
                      [&](const Run& brick) { return !borne(brick, row, rows[rows.size() - 2]); });
    }
    FaceGrid grid = face_grid(rows);
    wall_.hull = extruded(grid, s_.thickness / 2, 0);
    wall_.mortar = extruded(grid, s_.thickness / 2 - s_.recess, s_.recess);
    for (int row = 0; row < courses_; ++row)
      for (const Run& run : rows[row]) place_brick(grid, row, run);
    for (const WallBlock& block : wall_.blocks)
      if (block.part == WallPart::stone) append_box(wall_.hull, block.middle, block.size);
    if (s_.coping && s_.ruin <= 0) lay_coping();
    return std::move(wall_);
  }

 private:
  double snapped(double height) const { return std::round(height / course_) * course_; }

  /// The stones and the joinery of an opening.
  void frame(const WallOpening& o) {
    double end = s_.width / 2, top = courses_ * course_;
    double left = std::clamp(o.at - o.width / 2, -end, end),
           right = std::clamp(o.at + o.width / 2, -end, end);
    double low = o.kind == WallHole::door ? 0 : std::clamp(snapped(o.sill), 0.0, top);
    double high = std::clamp(snapped(low + o.height), 0.0, top);
    if (right - left < 0.05 || high - low < course_) return;
    double bearing = kLintel.bearing, lintel = std::min(top, high + 2 * course_);
    // Where a ruin no longer reaches over an opening, it is a gap.
    bool fallen = std::min(standing(left - bearing), standing(right + bearing)) < lintel + course_;
    regions_.push_back({left, right, low, fallen ? top : high, true});
    if (fallen) return;
    if (lintel > high) add_stone(left - bearing, right + bearing, high, lintel, kLintel);
    if (o.kind != WallHole::door && low > course_)
      add_stone(left - kSill.bearing, right + kSill.bearing, low - course_, low, kSill);
    if (o.kind != WallHole::gap)
      append_joinery(wall_.blocks, {left, right, low, high, s_.thickness, o.kind == WallHole::door});
  }

  /// A stone through the wall, proud of its front and back.
  void add_stone(double left, double right, double low, double high, const DressedStone& kind) {
    left = std::max(left, -s_.width / 2), right = std::min(right, s_.width / 2);
    regions_.push_back({left, right, low, high, false});
    double gap = 0.3 * s_.joint, z = (kind.front - kind.back) / 2;
    WallBlock stone{WallPart::stone};
    stone.middle = Vec3((left + right) / 2, (low + high) / 2, z);
    stone.size = Vec3(right - left - gap, high - low - gap, s_.thickness + kind.front + kind.back);
    wall_.blocks.push_back(stone);
  }

  /// How high the ruin still stands there.
  double standing(double x) const {
    constexpr double kHeap = 1.3;                // from high to high, about
    constexpr double kMean = 0.5, kMore = 0.75;  // of what is lost at most
    if (s_.ruin <= 0) return 1e9;
    float shift = static_cast<float>(seed_.child("ruin").range(-99, 99));
    double rough = fractal_noise(Vec3(static_cast<float>(x / kHeap) + shift, 0, shift), 3);
    double lost = std::clamp(kMean + kMore * rough, 0.0, 1.0);
    return s_.height * (1 - s_.ruin * lost);
  }

  /// What regions leave of the wall's length at a height.
  std::vector<Run> free_runs(double height) const {
    std::vector<Run> free{{-s_.width / 2, s_.width / 2}};
    for (const Region& r : regions_) {
      if (height < r.low || height > r.high) continue;
      std::vector<Run> left;
      for (const Run& run : free) {
        if (r.left > run.left) left.push_back({run.left, std::min(run.right, r.left)});
        if (r.right < run.right) left.push_back({std::max(run.left, r.right), run.right});
      }
      free = std::move(left);
    }
    return free;
  }

  /// Cuts a course into bricks between the regions that are free of them.
  std::vector<Run> lay_course(int row) const {
    double middle = (row + 0.5) * course_, module = s_.brick.x + s_.joint;
    std::vector<Run> bricks;
    double offset = -s_.width / 2 + (row % 2 ? module / 2 : 0);
    for (const Run& run : free_runs(middle)) {
      // Joints fall on the bond; a piece shorter than a quarter brick stays on its neighbour.
      double from = run.left, least = module / 4 - 1e-6;
      for (long k = static_cast<long>(std::floor((run.left - offset) / module)) + 1;; ++k) {
        double joint = offset + static_cast<double>(k) * module;
        if (joint >= run.right - least) break;
        if (joint - from < least) continue;
        bricks.push_back({from, joint});
        from = joint;
      }
      if (run.right - from > s_.joint) bricks.push_back({from, run.right});
    }
    std::erase_if(bricks, [&](const Run& b) {
      double x = (b.left + b.right) / 2;
      return middle > standing(x) || (s_.ruin > 0 && middle + course_ > standing(x) &&
                                      brick_seed(row, b).child("gone").unit() < kFallen);
    });
    return bricks;
  }

  /// Whether a brick lies on another one or on a stone.
  bool borne(const Run& brick, int row, const std::vector<Run>& below) const {
    auto under = [&](double left, double right) {
      return std::min(right, brick.right) - std::max(left, brick.left) > kMeets;
    };
    return std::ranges::any_of(below, [&](const Run& b) { return under(b.left, b.right); }) ||
           std::ranges::any_of(regions_, [&](const Region& r) {
             return !r.open && std::abs(r.high - row * course_) < 1e-6 && under(r.left, r.right);
           });
  }

  /// By its place to the millimetre.
  Seed brick_seed(int row, const Run& b) const {
    return seed_.child("course", row).child(std::llround((b.left + s_.width) * 1000));
  }

  /// Which parts of the wall's face are solid, cut along all joints.
  FaceGrid face_grid(const std::vector<std::vector<Run>>& rows) const {
    FaceGrid grid;
    for (const auto& row : rows)
      for (const Run& run : row) grid.x.push_back(run.left), grid.x.push_back(run.right);
    for (const Region& r : regions_) grid.x.push_back(r.left), grid.x.push_back(r.right);
    std::sort(grid.x.begin(), grid.x.end());
    grid.x.erase(std::unique(grid.x.begin(), grid.x.end(), [](double a, double b) { return b - a < 1e-4; }),
                 grid.x.end());
    for (int row = 0; row <= courses_; ++row) grid.y.push_back(row * course_);
    for (int row = 0; row < courses_; ++row) {
      double y = (row + 0.5) * course_;
      for (std::size_t i = 0; i + 1 < grid.x.size(); ++i) {
        double x = (grid.x[i] + grid.x[i + 1]) / 2;
        auto holds = [&](double left, double right) { return x > left && x < right; };
        const auto& bricks = rows[row];
        bool solid = std::ranges::any_of(bricks, [&](const Run& b) { return holds(b.left, b.right); });
        bool open = false;
        for (const Region& r : regions_) {
          if (y < r.low || y > r.high || !holds(r.left, r.right)) continue;
          open = open || r.open;
          solid = true;
        }
        grid.solid.push_back(solid && !open);
      }
    }
    return grid;
  }

  /// The bricks of all leaves of the wall at one place; those within show only at ends and tops.
  void place_brick(const FaceGrid& grid, int row, const Run& run) {
    constexpr double kLower = 0.05;  // share of its height that a brick loses by wear, at most
    bool outside = !grid.at((run.left + run.right) / 2, (row + 1.5) * course_) ||
                   !grid.at(run.left - kBeside, (row + 0.5) * course_) ||
                   !grid.at(run.right + kBeside, (row + 0.5) * course_);
    for (int leaf = 0; leaf < leaves_; ++leaf) {
      if (leaf != 0 && leaf != leaves_ - 1 && !outside) continue;
      Seed own = brick_seed(row, run).child("leaf", leaf);
      bool at_left = !grid.at(run.left - kBeside, (row + 0.5) * course_);
      bool at_right = !grid.at(run.right + kBeside, (row + 0.5) * course_);
      double left = run.left + (at_left ? 0 : s_.joint / 2),
             right = run.right - (at_right ? 0 : s_.joint / 2);
      double z = s_.thickness / 2 - depth_ / 2 - leaf * (depth_ + s_.joint);
      double off = s_.wear * own.child(0).range(-kUnevenWall.off, kUnevenWall.off);
      WallBlock brick;
      brick.middle = Vec3((left + right) / 2, row * course_ + (s_.joint + s_.brick.y) / 2 + s_.joint / 4,
                          z + (leaf == leaves_ - 1 && leaves_ > 1 ? -off : off));
      brick.size = Vec3(right - left, s_.brick.y * (1 - kLower * s_.wear * own.child(1).unit()), depth_);
      float lean = static_cast<float>(s_.wear * kUnevenWall.lean);
      brick.turn = glm::angleAxis(lean * static_cast<float>(own.child(2).range(-1, 1)), Vec3(0, 1, 0)) *
                   glm::angleAxis(lean * static_cast<float>(own.child(3).range(-1, 1)), Vec3(0, 0, 1));
      wall_.blocks.push_back(brick);
    }
  }

  /// The top course: bricks on edge, a little wider than the wall.
  void lay_coping() {
    double y = courses_ * course_, high = s_.brick.z, deep = s_.thickness + kCopingOut;
    for (const Run& run : free_runs(y - 1e-6)) {
      double length = run.right - run.left, middle = (run.left + run.right) / 2;
      int count = std::max(1, static_cast<int>(std::lround(length / course_)));
      double step = length / count;
      for (int i = 0; i < count; ++i) {
        double x = run.left + (i + 0.5) * step;
        Seed own = seed_.child("coping", std::llround((x + s_.width) * 1000));
        float lean = static_cast<float>(s_.wear * kUnevenCoping.lean * own.child(1).range(-1, 1));
        Vec3 at(x, y + (s_.joint + high) / 2,
                s_.wear * own.child(0).range(-kUnevenCoping.off, kUnevenCoping.off));
        wall_.blocks.push_back(
            {WallPart::brick, at, Vec3(step - s_.joint, high, deep), glm::angleAxis(lean, Vec3(0, 0, 1))});
      }
      append_box(wall_.hull, Vec3(middle, y + (high + s_.joint) / 2, 0), Vec3(length, high + s_.joint, deep));
      Vec3 bed(length - 2 * s_.recess, high + s_.joint - s_.recess, deep - 2 * s_.recess);
      append_box(wall_.mortar, Vec3(middle, y + bed.y / 2, 0), bed);
    }
  }

  const WallShape& s_;
  Seed seed_;
  double course_ = 0, depth_ = 0;
  int courses_ = 0, leaves_ = 1;
  std::vector<Region> regions_;
  Wall wall_;
};

}  // namespace

Wall build_wall(const WallShape& shape, Seed seed) { return WallMason(shape, seed).build(); }

}  // namespace frond
