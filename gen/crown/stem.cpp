#include "crown/stem.h"

#include <algorithm>
#include <cmath>

#include "core/curve.h"

namespace frond {

namespace {

constexpr std::size_t kMostChains = 4096;  // of one stem with all its clones
const DVec3 kUp{0, 1, 0};

DQuat about_x(double angle) { return glm::angleAxis(angle, DVec3(1, 0, 0)); }
DQuat about_y(double angle) { return glm::angleAxis(angle, kUp); }
DVec3 heading(const DQuat& turn) { return turn * kUp; }
double vary(double mean, double spread, Seed seed) { return mean + spread * seed.range(-1, 1); }

class Tracer {
 public:
  explicit Tracer(const WeberPenn& tree) : tree_(tree) {}

  std::vector<Chain> trace(const Stem& stem) const {
    std::vector<Chain> chains;
    Chain first;
    first.at.push_back(stem.foot);
    extend(chains, std::move(first), stem, stem.turn, 0);
    return chains;
  }

 private:
  /// Leads a chain from its last point to the tip, and the clones that split off it. `give_back` is the angle
  /// that each segment turns back after splits.
  void extend(std::vector<Chain>& chains, Chain chain, const Stem& stem, DQuat turn, double give_back) const {
    const StemLevel& level = tree_.stem(stem.level);
    int res = level.curve_res;
    std::size_t mine = chains.size();
    chains.emplace_back();
    Seed seed = stem.seed.child("chain", mine);
    double start = stem.seed.child("splits").unit();
    for (int s = chain.first; s < res; ++s) {
      turn =
          bend(turn, level, stem, s, seed.child("bend", static_cast<std::uint64_t>(s))) * about_x(give_back);
      chain.turn.push_back(turn);
      chain.at.push_back(chain.at.back() + heading(turn) * (stem.length / res));
      int end = s + 1;
      int splits = static_cast<int>(std::floor(end * level.seg_splits + start)) -
                   static_cast<int>(std::floor(s * level.seg_splits + start));
      bool base = stem.level == 0 && end == 1 && tree_.base_splits > 0;
      if (base) splits = tree_.base_splits;
      if (end == res || splits <= 0 || chains.size() > kMostChains) continue;
      split(chains, static_cast<int>(mine), chain, stem, turn, give_back, end, splits, base,
            seed.child("split", static_cast<std::uint64_t>(s)));
    }
    chain.turn.push_back(turn);
    Chain& place = chains[mine];
    place = std::move(chain);
  }

  void split(std::vector<Chain>& chains, int mine, const Chain& chain, const Stem& stem, DQuat& turn,
             double& give_back, int end, int splits, bool base, Seed seed) const {
    const StemLevel& level = tree_.stem(stem.level);
    double slope = std::acos(std::clamp(heading(turn).y, -1.0, 1.0));
    double angle = std::max(vary(level.split_angle, level.split_angle_v, seed.child(0)) - slope, 0.0);
    double back = -angle / (level.curve_res - end);
    DQuat before = turn;
    double give_back_before = give_back;
    turn = before * about_x(angle);
    give_back += back;
    for (int i = 1; i <= splits; ++i) {
      Seed own = seed.child(static_cast<std::uint64_t>(i));
      double draw_of = own.child(0).unit();
      double yaw = radians(20 + 0.75 * (30 + std::abs(degrees(slope) - 90)) * draw_of * draw_of);
      if (own.child(1).unit() < 0.5) yaw = -yaw;
      if (base) yaw = 2 * kPi * i / (splits + 1);
      Chain clone;
      clone.first = end;
      clone.from = mine;
      clone.at.push_back(chain.at.back());
      extend(chains, std::move(clone), stem, about_y(yaw) * before * about_x(angle), give_back_before + back);
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
    DVec3 side = glm::cross(axis, kUp);
    double length = glm::length(side);
    if (length < 1e-6) return turn;
    double slope = std::acos(std::clamp(axis.y, -1.0, 1.0));
    double most = share > 0 ? slope : slope - kPi;
    double angle = share * slope;
    angle = share > 0 ? std::min(angle, most) : std::max(angle, most);
    return glm::angleAxis(angle, side / length) * turn;
  }

  const WeberPenn& tree_;
};

}  // namespace

DVec3 Chain::point(double s) const {
  double place_of = place(s);
  std::size_t i = std::min(static_cast<std::size_t>(place_of), at.size() - 2);
  Hermite w = hermite(place_of - static_cast<double>(i));
  DVec3 leave = i > 0 ? (at[i + 1] - at[i - 1]) * 0.5 : at[1] - at[0];
  DVec3 arrive = i + 2 < at.size() ? (at[i + 2] - at[i]) * 0.5 : at[i + 1] - at[i];
  return at[i] * w.start + leave * w.start_slope + at[i + 1] * w.end + arrive * w.end_slope;
}

DQuat Chain::frame(double s) const {
  double place_of = place(s);
  std::size_t i = std::min(static_cast<std::size_t>(place_of), at.size() - 2);
  return glm::slerp(turn[i], turn[i + 1], place_of - static_cast<double>(i));
}

std::vector<Chain> trace_stem(const WeberPenn& tree, const Stem& stem) { return Tracer(tree).trace(stem); }

}  // namespace frond
