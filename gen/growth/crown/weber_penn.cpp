#include "crown/weber_penn.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "crown/aside.h"
#include "crown/stem.h"

namespace frond {

namespace {

constexpr std::size_t kMostLeaves = 10'000'000;
constexpr double kShortest = 0.0005;  // metres, of a stem

/// What children of a stem count on as they are placed one after the other.
struct Whorl {
  double turned = 0;
  int side = 1;

  double next(double rotate, double rotate_v, Seed seed) {
    if (rotate < 0) {
      side = -side;
      return side * vary(-rotate / 2, rotate_v, seed);
    }
    return turned += vary(rotate, rotate_v, seed);
  }
};

class Grower {
 public:
  explicit Grower(const WeberPenn& tree, Seed seed) : tree_(tree), seed_(seed) {
    scale_ = std::max(vary(tree.scale, tree.scale_v, seed.child("scale")), 1e-3);
    axes_ = axes_of(tree.guides);
    if (!axes_.empty() && axes_[0].at.size() < 2) axes_.clear();
    tall_ = std::max(vary(tree.z_scale, tree.z_scale_v, seed.child("tall")), 0.01);
    if (!axes_.empty()) tall_ = 1;  // it is as high as it is led
    if (tree.detour)
      stretched_ = [this, up = Vec3(1, tall_, 1)](Vec3 from, Vec3 to,
                                                  float clearance) -> std::optional<Vec3> {
        std::optional<Vec3> way = tree_.detour(from * up, to * up, clearance);
        return way && *way != to * up ? *way / up : way ? std::optional(to) : way;
      };
  }

  Result<Crown> grow() {
    Whorl whorl;
    for (int i = 0; i < tree_.trunks && !full_; ++i) add_trunk(i, whorl);
    if (full_)
      return error_at(
          "", "the tree has more than {} nodes or {} leaves; fewer branches, splits, segments or leaves",
          kMostNodes, kMostLeaves);
    for (Vec3& p : crown_.skeleton.position) p.y *= static_cast<float>(tall_);
    for (LeafSite& l : crown_.leaves) l.position.y *= static_cast<float>(tall_);
    settle();
    return std::move(crown_);
  }

 private:
  void add_trunk(int i, Whorl& whorl) {
    const StemLevel& level = tree_.stem(0);
    // The first has the addresses that it has when it stands alone.
    Seed seed = i == 0 ? seed_ : seed_.child("trunk", static_cast<std::uint64_t>(i));
    Stem trunk;
    trunk.seed = seed.child("trunk");
    trunk.length = std::max(vary(level.length, level.length_v, seed.child("length")) * scale_, 1e-3);
    trunk.radius = trunk.length * tree_.ratio *
                   std::max(vary(tree_.trunk_scale, tree_.trunk_scale_v, seed.child("radius")), 0.01);
    double round = whorl.next(level.rotate, level.rotate_v, seed.child("rotate"));
    double down = vary(level.down_angle, level.down_angle_v, seed.child("down"));
    trunk.turn = about_y(trunk.seed.child("turn").range(0, 2 * kPi)) * about_y(round) * about_x(down);
    double far = tree_.trunk_spread * seed.child("far").unit(),
           toward = seed.child("toward").range(0, 2 * kPi);
    trunk.foot = DVec3(far * std::cos(toward), 0, far * std::sin(toward));
    if (i == 0 && !axes_.empty()) {
      trunk.radius *= axes_[0].length() / trunk.length;
      scale_ = trunk.length = axes_[0].length();
      trunk.foot = DVec3(0);
    }
    bare_ = std::min(tree_.base_size * scale_, trunk.length);
    add_stem(trunk);
  }

  bool inside(DVec3 p) const {
    double ratio = (scale_ - p.y) / std::max(scale_ - bare_, 1e-9);
    return std::hypot(p.x, p.z) / scale_ <
           tree_.pruning.width * shape_ratio(CrownShape::envelope, ratio, tree_.pruning);
  }

  bool inside(const std::vector<StemChain>& chains) const {
    for (const StemChain& chain : chains)
      for (std::size_t i = 1; i < chain.at.size(); ++i)
        if (!inside(chain.at[i])) return false;
    return true;
  }

  /// Shortens a stem until it fits its envelope; false where none of it is left.
  bool prune(Stem& stem) {
    if (tree_.pruning.ratio <= 0 || stem.level == 0) return true;
    double whole = stem.length;
    auto set_length = [&](double length) {
      stem.radius *= std::pow(length / stem.length, tree_.ratio_power);
      stem.share *= length / stem.length;
      stem.length = length;
    };
    auto fits_in = [&] {
      double left = left_of(stem);
      return inside(trace_stem(tree_, stem, left, stretched_));
    };
    for (int i = 0; i < 40 && !fits_in(); ++i) set_length(stem.length * 0.9);
    bool fits = fits_in();
    double least = fits ? stem.length : 0;
    double final_length = whole * (1 - tree_.pruning.ratio) + least * tree_.pruning.ratio;
    if (final_length < 0.02 * whole) return false;
    set_length(final_length);
    return true;
  }

  double& left_of(const Stem& stem) { return left_[std::min(stem.level, 3)]; }

  double radius_at(const Stem& stem, double z) const {
    double r = taper_radius(tree_.stem(stem.level).taper, stem.radius, stem.length, z);
    return stem.level == 0 ? r * flare_factor(tree_.flare, z) : r;
  }

  void add_stem(const Stem& stem) {
    assert(stem.length > 0 && stem.radius >= 0 && stem.level < tree_.levels);
    assert(stem.below >= Skeleton::kRoot && stem.below < static_cast<std::int32_t>(crown_.skeleton.size()));
    if (full_) return;
    bool led = stem.level == 0 && stem.below == Skeleton::kRoot && crown_.skeleton.size() == 0;
    std::vector<StemChain> chains = led && !axes_.empty()
                                        ? guided_trunk(tree_, axes_)
                                        : trace_stem(tree_, stem, left_of(stem), stretched_);
    full_ = full_ || chains.empty();
    std::vector<std::vector<std::int32_t>> node_at(chains.size());  // of each chain at the ends of segments
    bool last = stem.level + 1 >= tree_.levels;
    for (std::size_t c = 0; c < chains.size(); ++c) {
      StemChain& chain = chains[c];
      if (chain.at.size() < 2) continue;
      std::int32_t below = stem.below;
      if (chain.from >= 0) {
        const StemChain& from = chains[chain.from];
        below = node_at[chain.from][chain.first - from.first];
      }
      std::vector<double> places = last ? std::vector<double>{} : places_of_children(stem, chain);
      std::vector<std::int32_t> child_nodes = add_chain(stem, chain, below, places, node_at[c]);
      if (full_) return;
      Seed seed = stem.seed.child("children", c);
      if (last)
        bear_leaves(stem, chain, child_nodes, seed);
      else
        bear_stems(stem, chain, places, child_nodes, seed);
    }
  }

  /// Segments of a chain between two splits, which bear equally densely.
  struct Stretch {
    double from, to, share;
    double before;  // weight of those below
    double weight() const { return (to - from) * share; }
  };

  static std::vector<Stretch> stretches_of(const StemChain& chain, double from, int res) {
    std::vector<Stretch> all;
    for (auto s = static_cast<int>(from); s < res; ++s) {
      double share = chain.share[s - chain.first];
      if (!all.empty() && all.back().share == share)
        all.back().to = s + 1;
      else
        all.push_back({std::max<double>(from, s), s + 1.0, share,
                       all.empty() ? 0 : all.back().before + all.back().weight()});
    }
    return all;
  }

  /// Where the stems of the next level stand on a chain, in segments from the stem's foot.
  std::vector<double> places_of_children(const Stem& stem, const StemChain& chain) const {
    const StemLevel& own = tree_.stem(stem.level);
    double count = std::max(stem_count(tree_, stem.level, stem.share, stem.offset), 0.0);
    int res = own.curve_res;
    double low = stem.level == 0 ? bare_ / stem.length * res : 0;
    double from = std::max(low, static_cast<double>(chain.first));
    if (res - low <= 1e-9 || from >= res) return {};
    std::vector<Stretch> stretches = stretches_of(chain, from, res);
    double weight = stretches.back().before + stretches.back().weight();
    const Curve& density = tree_.stem(stem.level + 1).branches_along;
    const double mean = mean_along(density, low / res, 1);
    if (mean <= 0) return {};
    count *= mean_along(density, from / res, 1) / mean;
    int n = static_cast<int>(count * (weight / (res - low)) + stem.seed.child("count", chain.first).unit());
    double dist = tree_.stem(stem.level + 1).branch_dist;
    std::vector<double> places;
    std::size_t at = 0;
    for (int i = 0; i < n; ++i) {
      double due = weight * (i + 0.5) / n;
      while (at + 1 < stretches.size() && due > stretches[at + 1].before) ++at;
      double even = stretches[at].from + (due - stretches[at].before) / stretches[at].share;
      if (!is_even(density))
        even = res * place_by_density(density, from / res, 1, (even - from) / (res - from));
      double whorl = std::max(dist, 1.0);
      double begin = from + std::floor((even - from) / whorl) * whorl;
      double s = dist > 1 ? begin : begin + (even - begin) * dist;
      places.push_back(std::clamp(s, from, res - 0.02));
    }
    return places;
  }

  /// Adds the nodes of a chain: at its segments' ends, between them and at `places`. Returns the node at each
  /// place, or those along the chain where none are asked for.
  std::vector<std::int32_t> add_chain(const Stem& stem, const StemChain& chain, std::int32_t below,
                                      const std::vector<double>& places, std::vector<std::int32_t>& ends) {
    int res = tree_.stem(stem.level).curve_res, pieces = tree_.smoothing;
    std::vector<double> stops;
    for (int k = 0; k <= (res - chain.first) * pieces; ++k)
      stops.push_back(chain.first + static_cast<double>(k) / pieces);
    stops.insert(stops.end(), places.begin(), places.end());
    std::sort(stops.begin(), stops.end());
    double near = 0.02 / pieces;
    stops.erase(std::unique(stops.begin(), stops.end(), [&](double a, double b) { return b - a < near; }),
                stops.end());
    if (crown_.skeleton.size() + stops.size() > kMostNodes) {
      full_ = true;
      return {};
    }
    std::vector<std::int32_t> nodes;
    ends.assign(static_cast<std::size_t>(res - chain.first) + 1, below);
    for (double s : stops) {
      bool foot = s - chain.first < near;
      // A branch begins at the node of its parent that stands at its place; only the trunk has a first node.
      if (!foot || below == Skeleton::kRoot) {
        auto radius = static_cast<float>(std::max(radius_at(stem, s / res), kLeast));
        below =
            crown_.skeleton.add(Vec3(chain.point(s)), radius, below, static_cast<std::uint16_t>(stem.level));
      }
      nodes.push_back(below);
      double whole = std::round(s);
      if (std::abs(s - whole) < near) ends[static_cast<std::size_t>(whole) - chain.first] = below;
    }
    if (places.empty()) return nodes;
    std::vector<std::int32_t> at;
    for (double place : places) {
      auto it = std::upper_bound(stops.begin(), stops.end(), place + near);
      at.push_back(nodes[std::max<std::ptrdiff_t>(it - stops.begin() - 1, 0)]);
    }
    return at;
  }

  void bear_stems(const Stem& stem, const StemChain& chain, const std::vector<double>& places,
                  const std::vector<std::int32_t>& nodes, Seed seed) {
    const StemLevel& next = tree_.stem(stem.level + 1);
    int res = tree_.stem(stem.level).curve_res;
    Whorl whorl{seed.child("first").range(0, 2 * kPi)};
    double crown_length = std::max(stem.length - bare_, 1e-9);
    for (std::size_t i = 0; i < places.size() && !full_; ++i) {
      Stem child;
      child.seed = seed.child(i);
      child.level = stem.level + 1;
      child.offset = places[i] / res;
      double along = child.offset * stem.length;
      double most = std::max(vary(next.length, next.length_v, child.seed.child("length")), 0.0);
      double from_top = stem.level == 0 ? (stem.length - along) / crown_length : 0;
      if (stem.level == 0) {
        child.share = shape_ratio(tree_.shape, from_top, tree_.pruning, tree_.cone_top);
        child.length = stem.length * most * child.share;
      } else {
        child.length = most * (stem.length - 0.6 * along);
        child.share = most > 0 ? child.length / stem.length / most : 0;
      }
      const double longer = factor_along(next.length_along, child.offset);
      child.length *= longer, child.share *= longer;
      if (child.length < kShortest) continue;
      child.radius = std::min(stem.radius * std::pow(child.length / stem.length, tree_.ratio_power) *
                                  factor_along(next.radius_along, child.offset),
                              radius_at(stem, child.offset));
      child.below = nodes[i];
      child.foot = chain.point(places[i]);
      double down = next.down_angle_v >= 0
                        ? vary(next.down_angle, next.down_angle_v, child.seed.child("down"))
                        : down_by_height(next, stem, along);
      down *= factor_along(next.angle_along, child.offset);
      double round = whorl.next(next.rotate, next.rotate_v, child.seed.child("rotate"));
      child.turn = glm::normalize(chain.frame(places[i]) * about_y(round) * about_x(down));
      if (prune(child)) add_stem(child);
    }
  }

  double down_by_height(const StemLevel& level, const Stem& parent, double along) const {
    double bare = parent.level == 0 ? bare_ : 0;
    double ratio = (parent.length - along) / std::max(parent.length - bare, 1e-9);
    double rise = shape_ratio(CrownShape::conical, ratio, {}, tree_.cone_top);
    return level.down_angle + level.down_angle_v * (1 - 2 * rise);
  }

  void bear_leaves(const Stem& stem, const StemChain& chain, const std::vector<std::int32_t>& nodes,
                   Seed seed) {
    if (tree_.leaves == 0 || nodes.empty()) return;
    const StemLevel& next = tree_.stem(stem.level + 1);
    int res = tree_.stem(stem.level).curve_res;
    double share = static_cast<double>(res - chain.first) / res;
    double wanted = std::abs(tree_.leaves) * tree_.leaf_quality *
                    shape_ratio(tree_.leaf_distribution, stem.offset, tree_.pruning, tree_.cone_top);
    bool fan = tree_.leaves < 0;
    int count = static_cast<int>(fan ? wanted + 0.5 : wanted * share + seed.child("count").unit());
    full_ = full_ || crown_.leaves.size() + static_cast<std::size_t>(count) > kMostLeaves;
    if (full_) return;
    auto size = static_cast<float>(1 / std::sqrt(tree_.leaf_quality));
    Whorl whorl{seed.child("first").range(0, 2 * kPi)};
    for (int i = 0; i < count; ++i) {
      Seed own = seed.child(static_cast<std::uint64_t>(i));
      double s = fan ? res : chain.first + (res - chain.first) * (i + 0.5) / count;
      // The first node is that of the parent.
      auto at = static_cast<std::size_t>(chain.place(s) * tree_.smoothing + 0.5);
      at = std::min(std::max<std::size_t>(at, 1), nodes.size() - 1);
      double down = next.down_angle_v < 0 && !fan
                        ? down_by_height(next, stem, s / res * stem.length)
                        : vary(next.down_angle, std::abs(next.down_angle_v), own.child(0));
      down *= factor_along(next.angle_along, s / res);
      DQuat turn = chain.frame(s);
      if (fan) {
        double spread = vary(std::abs(next.rotate) * (i - (count - 1) / 2.0), next.rotate_v, own.child(1));
        turn = turn * glm::angleAxis(spread / count, DVec3(0, 0, 1)) * about_x(down);
      } else {
        double round = whorl.next(next.rotate, next.rotate_v, own.child(1));
        turn = turn * about_y(round) * about_x(down) * about_y(kPi);
      }
      DVec3 foot = chain.point(s) + heading(turn) * (fan ? 0 : 0.5 * radius_at(stem, s / res));
      turn = face_light(turn, foot);
      foot += heading(turn) * (std::min(tree_.leaf_stem_length, 0.0) * tree_.leaf_scale * size);
      crown_.leaves.push_back({Vec3(foot), Quat(glm::normalize(turn)), size, nodes[at]});
    }
  }

  /// A leaf's face turned outward and up by leaf_bend.
  DQuat face_light(DQuat turn, DVec3 at) const {
    if (tree_.leaf_bend == 0) return turn;
    DVec3 face = turn * DVec3(0, 0, 1);
    DVec3 light = glm::normalize(DVec3(at.x, 0.6 * scale_, at.z));
    DVec3 axis = glm::cross(face, light);
    double length = glm::length(axis);
    if (length < 1e-6) return turn;
    double angle = std::atan2(length, glm::dot(face, light));
    return glm::angleAxis(angle * tree_.leaf_bend, axis / length) * turn;
  }

  /// Orders the branches and sets what follows from the places of the nodes.
  void settle() {
    Skeleton& s = crown_.skeleton;
    std::vector<std::int32_t> order = order_branches(s);
    for (LeafSite& leaf : crown_.leaves) leaf.node = order[leaf.node];
    if (tree_.detour) bend_aside(crown_, tree_.detour);
    set_distances(s);
    set_tip_distances(s);
    set_births(s);
  }

  static constexpr double kLeast = 0.0004;  // metres

  const WeberPenn& tree_;
  Seed seed_;
  Detour stretched_;             // of the tree before its height is changed
  std::vector<GuideAxis> axes_;  // along which the first trunk is led
  double scale_ = 1, bare_ = 0, tall_ = 1;
  Crown crown_;
  bool full_ = false;
  std::array<double, kStemLevels> left_{};  // of splits, by level
};

}  // namespace

Result<Crown> grow_weber_penn(const WeberPenn& tree, Seed seed) { return Grower(tree, seed).grow(); }

}  // namespace frond
