#include "crown/stem.h"

#include <cmath>

#include "core/curve.h"

namespace frond {

namespace {

class Tracer {
 public:
  Tracer(const WeberPenn& tree, const Stem& stem, double& left, const Detour& detour)
      : tree_(tree), stem_(stem), left_(left), detour_(detour) {}

  std::vector<StemChain> trace() {
    StemChain first;
    first.at.push_back(stem_.foot);
    extend(std::move(first), {stem_.turn});
    if (points_ > kMostNodes) return {};
    return std::move(chains_);
  }

 private:
  /// What a split changes.
  struct Course {
    DQuat turn;
    double give_back = 0;  // angle by which each segment turns back
    double share = 1;      // of the stems that an unsplit stem would bear
  };

  /// Leads a chain from its last point to the tip, and the clones that split off it.
  void extend(StemChain chain, Course course) {
    const StemLevel& level = tree_.stem(stem_.level);
    int res = level.curve_res;
    points_ += static_cast<std::size_t>(res - chain.first);
    if (points_ > kMostNodes) return;
    std::size_t mine = chains_.size();
    chains_.emplace_back();
    Seed seed = stem_.seed.child("chain", mine);
    for (int s = chain.first; s < res && points_ <= kMostNodes; ++s) {
      course.turn = bend(course.turn, level, stem_, s, seed.child("bend", s)) * about_x(course.give_back);
      if (detour_) course.turn = aside(chain.at.back(), course.turn, (s + 0.5) / res);
      chain.turn.push_back(course.turn);
      chain.share.push_back(course.share);
      chain.at.push_back(chain.at.back() + heading(course.turn) * (stem_.length / res));
      int end = s + 1;
      bool base = stem_.level == 0 && end == 1 && tree_.base_splits > 0;
      int splits = end == res ? 0 : base ? tree_.base_splits : splits_here(level);
      if (splits > 0) split(static_cast<int>(mine), chain, course, end, splits, base, seed.child("split", s));
    }
    chain.turn.push_back(course.turn);
    chains_[mine] = std::move(chain);
  }

  /// Whole clones at the end of a segment; what is left over counts on at the next, of whatever stem (the
  /// error diffusion of the paper).
  int splits_here(const StemLevel& level) {
    double due = level.seg_splits + left_;
    int splits = std::max(static_cast<int>(std::floor(due + 0.5)), 0);
    left_ = due - splits;
    return splits;
  }

  void split(int mine, const StemChain& chain, Course& course, int end, int splits, bool base, Seed seed) {
    const StemLevel& level = tree_.stem(stem_.level);
    DQuat before = course.turn;
    double slope = std::acos(std::clamp(heading(before).y, -1.0, 1.0));
    double angle = std::max(vary(level.split_angle, level.split_angle_v, seed.child(0)) - slope, 0.0);
    course.turn = before * about_x(angle);
    course.give_back -= angle / (level.curve_res - end);
    course.share /= splits + 1;
    for (int i = 1; i <= splits; ++i) {
      Seed own = seed.child(i);
      double draw_of = own.child(0).unit();
      double yaw = radians(20 + 0.75 * (30 + std::abs(degrees(slope) - 90)) * draw_of * draw_of);
      if (own.child(1).unit() < 0.5) yaw = -yaw;
      if (base) yaw = 2 * kPi * i / (splits + 1);
      StemChain clone;
      clone.first = end;
      clone.from = mine;
      clone.at.push_back(chain.at.back());
      Course apart = course;
      apart.turn = about_y(yaw) * before * about_x(angle);
      extend(std::move(clone), apart);
    }
  }

  DQuat bend(DQuat turn, const StemLevel& level, const Stem& stem, int s, Seed seed) const {
    int res = level.curve_res;
    double angle = level.curve / res;
    if (level.curve_back != 0)
      angle = (s < (res + 1) / 2 ? level.curve : level.curve_back) / std::max(res / 2.0, 1.0);
    if (level.curve_v < 0) {
      // A helix: always by the same slope off the stem's axis, once round it.
      turn = s == 0 ? turn * about_x(-level.curve_v)
                    : glm::angleAxis(2 * kPi / res, heading(stem.turn)) * turn * about_x(angle);
    } else {
      turn = turn * about_x(angle);
      if (level.curve_v > 0 && s > 0) {
        DQuat roll = about_y(seed.child(0).range(0, 2 * kPi));
        turn = turn * roll * about_x(level.curve_v / res * seed.child(1).range(-1, 1)) * glm::inverse(roll);
      }
    }
    if (stem.level >= 2 && tree_.attraction_up != 0) turn = lift(turn, tree_.attraction_up / res);
    return glm::normalize(turn);
  }

  /// Turned toward the vertical by a share of its slope; down where the share is negative.
  static DQuat lift(DQuat turn, double share) {
    DVec3 axis = heading(turn);
    DVec3 side = glm::cross(axis, DVec3(0, 1, 0));
    double length = glm::length(side);
    if (length < 1e-6) return turn;
    double slope = std::acos(std::clamp(axis.y, -1.0, 1.0));
    double most = share > 0 ? slope : slope - kPi;
    double angle = share * slope;
    angle = share > 0 ? std::min(angle, most) : std::max(angle, most);
    return glm::angleAxis(angle, side / length) * turn;
  }

  /// The heading of a segment from a point, at a share of the stem's length, turned along what is in its way.
  DQuat aside(DVec3 from, DQuat turn, double share) const {
    DVec3 ahead = heading(turn) * (stem_.length / tree_.stem(stem_.level).curve_res);
    double radius = taper_radius(tree_.stem(stem_.level).taper, stem_.radius, stem_.length, share);
    Vec3 to(from + ahead);
    std::optional<Vec3> way = detour_(Vec3(from), to, static_cast<float>(radius) + kBarkGap);
    if (!way || *way == to) return turn;
    return glm::normalize(DQuat(glm::normalize(ahead), glm::normalize(DVec3(*way) - from)) * turn);
  }

  const WeberPenn& tree_;
  const Stem& stem_;
  std::vector<StemChain> chains_;
  std::size_t points_ = 0;
  double& left_;
  const Detour& detour_;
};

}  // namespace

DVec3 StemChain::point(double s) const {
  double place_of = place(s);
  std::size_t i = std::min(static_cast<std::size_t>(place_of), at.size() - 2);
  Hermite w = hermite(place_of - static_cast<double>(i));
  DVec3 leave = i > 0 ? (at[i + 1] - at[i - 1]) * 0.5 : at[1] - at[0];
  DVec3 arrive = i + 2 < at.size() ? (at[i + 2] - at[i]) * 0.5 : at[i + 1] - at[i];
  return at[i] * w.start + leave * w.start_slope + at[i + 1] * w.end + arrive * w.end_slope;
}

DQuat StemChain::frame(double s) const {
  double place_of = place(s);
  std::size_t i = std::min(static_cast<std::size_t>(place_of), at.size() - 2);
  return glm::slerp(turn[i], turn[i + 1], place_of - static_cast<double>(i));
}

std::vector<StemChain> trace_stem(const WeberPenn& tree, const Stem& stem, double& left,
                                  const Detour& detour) {
  return Tracer(tree, stem, left, detour).trace();
}

namespace {

/// Points at the ends of the segments of a chain, and its frames, without a twist from one to the next.
void lay_along(const GuideAxis& axis, int segments, DQuat turn, StemChain& chain) {
  double length = axis.length();
  for (int k = 0; k <= segments; ++k) chain.at.emplace_back(axis.point(length * k / segments));
  for (int k = 0; k < segments; ++k) {
    auto s = static_cast<std::size_t>(k);
    DVec3 way = chain.at[s + 1] - chain.at[s];
    if (glm::length(way) > 1e-9) turn = DQuat(heading(turn), way) * turn;
    chain.turn.push_back(turn);
  }
  chain.turn.push_back(turn);
}

}  // namespace

std::vector<StemChain> guided_trunk(const WeberPenn& tree, const std::vector<GuideAxis>& axes) {
  int res = tree.stem(0).curve_res;
  std::vector<StemChain> chains;
  std::vector<int> number(axes.size(), -1);  // of the chain of each axis
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const GuideAxis& axis = axes[a];
    if (axis.at.size() < 2) continue;
    StemChain chain;
    DQuat turn(1, 0, 0, 0);
    double share = 1;
    if (a > 0) {
      const GuideAxis& from = axes[static_cast<std::size_t>(axis.off)];
      chain.from = number[static_cast<std::size_t>(axis.off)];
      if (chain.from < 0) continue;
      StemChain& parent = chains[static_cast<std::size_t>(chain.from)];
      double along = (axis.from - from.from) / from.length() * (res - parent.first);
      if (parent.first + 1 > res - 1) continue;  // too short to fork
      chain.first =
          std::clamp(parent.first + static_cast<int>(std::lround(along)), parent.first + 1, res - 1);
      auto fork = static_cast<std::size_t>(chain.first - parent.first);
      // Both bear half of what one would.
      for (std::size_t s = fork; s < parent.share.size(); ++s) parent.share[s] /= 2;
      share = parent.share[fork];
      turn = parent.turn[fork];
      chain.at = {parent.at[fork]};
    }
    StemChain laid = chain;
    laid.at.clear();
    lay_along(axis, res - chain.first, turn, laid);
    if (!chain.at.empty()) laid.at[0] = chain.at[0];
    laid.share.assign(static_cast<std::size_t>(res - chain.first), share);
    number[a] = static_cast<int>(chains.size());
    chains.push_back(std::move(laid));
  }
  return chains;
}

}  // namespace frond
