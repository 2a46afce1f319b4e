#include "grove/standing.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace frond {

namespace {

constexpr float kUnfold = 0.35f;  // years in which leaves unfold
constexpr float kWither = 0.5f;   // years in which they go
constexpr double kFallInAir = 6;  // m/s2; twigs are held up by the air
constexpr double kTipping = 1.1;  // radians a second
constexpr float kGone = 1e-4f;    // metres: what is thinner is not there

/// Where a broken piece has got to.
struct Piece {
  Vec3 pivot{0}, shift{0};
  Quat turn{1, 0, 0, 0};
  float share = 1;  ///< of its thickness, until it is gone

  Vec3 moved(Vec3 p) const { return pivot + shift + turn * (p - pivot); }
};

class Stander {
 public:
  Stander(const GrownTree& tree, const Species& species, double year, const Filming& filming)
      : t_(tree),
        s_(species),
        year_(static_cast<float>(year)),
        filming_(filming),
        history_(!tree.ring.empty()) {}

  Standing make() {
    std::size_t n = t_.size();
    assert(!history_ || t_.first_ring.size() == n + 1);
    assert(t_.parent.size() == n && t_.radius.size() == n && t_.leads.size() == n);
    index_.assign(n, GrownTree::kRoot);
    piece_.assign(n, -1);
    find_leading();
    for (std::size_t i = 0; i < n; ++i) add(i);
    return std::move(out_);
  }

 private:
  /// When each metamer ceases to bear the terminal bud of its axis.
  void find_leading() {
    led_until_.assign(t_.size(), -1);
    for (std::size_t i = t_.size(); i-- > 0;) {
      if (t_.leads[i]) led_until_[i] = GrownTree::kNever;
      std::int32_t p = t_.parent[i];
      if (p != GrownTree::kRoot && t_.order[p] == t_.order[i])
        led_until_[p] = std::max(led_until_[p], start(i));
    }
  }

  /// When an internode begins to grow: its shoot takes its year, one internode after the other.
  float start(std::size_t i) const {
    std::int32_t p = t_.parent[i];
    if (p == GrownTree::kRoot) return t_.born[i];
    return std::max(t_.born[p], std::ceil(t_.born[i]) - 1);
  }

  float radius(std::size_t i) const {
    if (!history_) return t_.radius[i];
    std::uint32_t first = t_.first_ring[i], count = t_.first_ring[i + 1] - first;
    if (count == 0) return t_.radius[i];  // the foot of a tree that never grew
    float from = start(i), ringed = std::max(std::ceil(t_.born[i]), from + 0.01f);
    auto area = [&](std::uint32_t k) { return t_.ring[first + k] * t_.ring[first + k]; };
    if (year_ <= ringed) return std::sqrt(area(0) * std::clamp((year_ - from) / (ringed - from), 0.0f, 1.0f));
    float past = year_ - ringed;
    auto k = static_cast<std::uint32_t>(past);
    if (k + 1 >= count) return t_.ring[first + count - 1];
    return std::sqrt(area(k) + (area(k + 1) - area(k)) * (past - static_cast<float>(k)));
  }

  float leaves(std::size_t i) const {
    if (t_.parent[i] == GrownTree::kRoot) return 0;
    float end = std::max(t_.born[i] + static_cast<float>(s_.leaf_years), led_until_[i]);
    auto leafy = static_cast<float>(filming_.leafy / std::max(filming_.seconds_a_year, 1e-6));
    if (t_.died[i] != t_.uprooting.time || end < t_.died[i]) leafy = 0;
    end = std::min(end, t_.died[i]) + leafy;
    return smooth_step(0.0f, kUnfold, year_ - t_.born[i]) *
           (1 - smooth_step(0.0f, std::max(kWither, leafy), year_ - end));
  }

  /// The year by which what has broken off is on its way.
  double fallen_by() const { return year_ + filming_.overtime / std::max(filming_.seconds_a_year, 1e-6); }

  /// A piece that broke at metamer i, on its way down.
  std::int32_t fall(std::size_t i) {
    assert(t_.parent[i] != GrownTree::kRoot && "a tree does not break at its foot");
    auto p = static_cast<std::size_t>(t_.parent[i]);
    double time = (year_ - t_.fell[i]) * filming_.seconds_a_year + filming_.overtime;
    Piece piece;
    piece.pivot = t_.tip[p];
    Vec3 offset = t_.tip[i] - t_.tip[p];
    Vec3 level(offset.x, 0, offset.z);
    Vec3 out = glm::length(level) > 1e-5f ? glm::normalize(level) : Vec3(1, 0, 0);
    double high = std::max(0.0, static_cast<double>(t_.tip[p].y - t_.tip[0].y) - 0.05);
    double landing = std::sqrt(2 * high / kFallInAir), down = std::min(time, landing);
    // It comes loose slowly, tips over outward, and comes clear of the stem.
    double angle = kTipping * down * down / (down + 0.5);
    piece.turn = glm::angleAxis(static_cast<float>(std::min(angle, 1.3)), Vec3(out.z, 0, -out.x));
    double gone = std::max(0.0, time - landing) / std::max(filming_.lie, 0.01);
    piece.shift =
        Vec3(0, -kFallInAir / 2 * down * down - 0.1 * gone, 0) + out * static_cast<float>(0.25 * down);
    piece.share = static_cast<float>(1 - smooth_step(0.0, 1.0, gone));
    pieces_.push_back(piece);
    return static_cast<std::int32_t>(pieces_.size()) - 1;
  }

  void add(std::size_t i) {
    std::int32_t p = t_.parent[i];
    bool foot = p == GrownTree::kRoot;
    if (!foot && index_[p] == GrownTree::kRoot) return;
    if (history_ && (foot ? start(i) > year_ : start(i) >= year_)) return;
    if (!foot && t_.fell[i] <= fallen_by()) {
      // A twig that fell before the branch that bore it goes its own way.
      bool with_parent = t_.fell[p] == t_.fell[i] && piece_[p] >= 0;
      piece_[i] = with_parent ? piece_[p] : fall(i);
    }
    float r = radius(i), leafy = leaves(i);
    Vec3 tip = t_.tip[i], side = t_.side[i], base = foot ? tip : t_.tip[p];
    if (history_ && year_ < t_.born[i] && !foot) {
      float from = start(i), grown = t_.born[i] > from ? (year_ - from) / (t_.born[i] - from) : 1.0f;
      tip = base + (tip - base) * grown;
    }
    if (piece_[i] >= 0) {
      const Piece& piece = pieces_[static_cast<std::size_t>(piece_[i])];
      r *= piece.share, leafy *= piece.share;
      tip = piece.moved(tip), base = piece.moved(base), side = piece.turn * side;
      if (r < kGone) return;
    }
    index_[i] = static_cast<std::int32_t>(out_.size());
    out_.source.push_back(static_cast<std::uint32_t>(i));
    out_.tip.push_back(tip);
    out_.side.push_back(side);
    out_.parent.push_back(foot ? GrownTree::kRoot : index_[p]);
    out_.foot.push_back(base);
    out_.radius.push_back(std::max(r, kGone));
    out_.leaves.push_back(leafy);
  }

  const GrownTree& t_;
  const Species& s_;
  float year_;
  const Filming& filming_;
  bool history_;
  std::vector<std::int32_t> index_, piece_;
  std::vector<float> led_until_;
  std::vector<Piece> pieces_;
  Standing out_;
};

}  // namespace

Standing standing(const GrownTree& tree, const Species& species, double year, const Filming& filming) {
  return Stander(tree, species, year, filming).make();
}

}  // namespace frond
