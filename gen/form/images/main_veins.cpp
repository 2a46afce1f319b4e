#include "images/main_veins.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"

namespace frond {

namespace {

constexpr double kLobe = 0.05;  // prominence of a lobe that has a secondary of its own, by the largest radius
constexpr double kPalmateLobe = 0.13;  // of one that has a main vein, as a share of its radius
constexpr double kTooth = 0.008;       // of a tooth that a secondary may end in, likewise
constexpr double kEnd = 0.975;         // share of the way from the middle to the rim, where veins end
constexpr double kVeinEdge = 0.022;    // share of that way that they keep off the rim
constexpr float kPiece = 0.02f;        // length of the pieces of these veins
constexpr float kLowestSide = 0.03f;   // of the blade's length: the lowest secondaries, above the foot
constexpr float kBend = 0.09f;         // of its length, by which a secondary bends
constexpr float kShortest = 0.03f;     // of a secondary
constexpr float kApart = 0.018f;       // secondaries end where they would come closer to another

/// A main vein that others leave: its points from its foot to its end.
struct MainVein {
  std::vector<std::uint32_t> nodes;
  Vec2 from{0}, to{0};
};

/// A secondary.
struct Side {
  std::vector<std::uint32_t> nodes;
  bool cut = false;     ///< it ended before it was where it was to end
  bool arches = false;  ///< it goes on to the next above it
};

Vec2 on_bezier(Vec2 a, Vec2 b, Vec2 c, float t) { return glm::mix(glm::mix(a, b, t), glm::mix(b, c, t), t); }

class MainVeins {
 public:
  MainVeins(const LeafOutline& o, const Lamina& blade, VeinTree& tree)
      : v_(o.venation), blade_(blade), tree_(tree) {
    const double largest = *std::ranges::max_element(o.radii);
    for (const RimTip& tip : rim_tips(o, kTooth * largest)) teeth_.push_back(tip.angle);
    LeafOutline smooth = o;
    smooth.teeth = 0;
    lobes_ = rim_tips(smooth, kLobe * largest);
    tree_.add(blade.foot(), -1, 1);
  }

  void pinnate() {
    MainVein midrib = axis(0, blade_.at(0, kEnd));
    for (int side : {1, -1}) arches(secondaries(midrib, side));
  }

  void palmate() {
    MainVein midrib = axis(0, blade_.at(0, kEnd));
    std::vector<MainVein> all{midrib};
    std::vector<double> angles;
    for (const RimTip& lobe : lobes_)
      if (lobe.prominence >= kPalmateLobe * lobe.radius) angles.push_back(lobe.angle);
    // A round blade has main veins all round.
    if (angles.empty()) angles = {0.2 * kPi, 0.42 * kPi, 0.68 * kPi};
    for (double angle : angles)
      for (int side : {1, -1}) {
        Vec2 to = blade_.at(side * angle, kEnd);
        all.push_back(axis(leaving(midrib, to), to));
      }
    for (std::size_t i = 0; i < all.size(); ++i)
      for (int side : {1, -1}) ribs(all, i, side);
  }

  void parallel() {
    MainVein midrib = axis(0, blade_.at(0, kEnd));
    const auto rows = static_cast<int>((blade_.high() - blade_.foot().y) / kPiece);
    std::vector<float> half(static_cast<std::size_t>(rows) + 1, 0);
    for (int k = 0; k <= rows; ++k) half[k] = half_width(height_at(k, rows));
    // A narrow blade has room for fewer.
    const int n = std::clamp(static_cast<int>(*std::ranges::max_element(half) / 0.004f), 1, v_.secondaries);
    for (int side : {1, -1})
      for (int i = 1; i <= n; ++i) {
        double share = (i + seed_.child("line", 2 * i + (side > 0)).range(-0.12, 0.12)) / (n + 0.6);
        std::int32_t last = 0;
        for (int k = 1; k < rows; ++k) {
          // Where they would run closer than that, they have joined.
          if (half[k] < 0.003f * static_cast<float>(n)) continue;
          Vec2 p(static_cast<float>(side * share) * half[k], height_at(k, rows));
          if (blade_.holds(p, 1 - kEnd)) last = static_cast<std::int32_t>(tree_.add(p, last, 1));
        }
      }
  }

  void dichotomous() {
    // The rim that the foot sees, as directions from it: veins run to it straight and fork as it widens.
    double wide = 0;
    for (double a = 0; a < 2.6; a += 0.02) {
      Vec2 d(static_cast<float>(std::sin(a)), static_cast<float>(std::cos(a)));
      if (length_to_rim(blade_.foot(), d) > 0.12f) wide = a;
    }
    fork({0, -wide, 0, 0}), fork({0, 0, wide, 0});
  }

 private:
  float height_at(int row, int rows) const {
    return std::lerp(blade_.foot().y, blade_.at(0, kEnd).y,
                     static_cast<float>(row) / static_cast<float>(rows));
  }

  float half_width(float y) const {
    float low = 0, high = blade_.wide();
    for (int k = 0; k < 20; ++k) (blade_.holds({0.5f * (low + high), y}) ? low : high) = 0.5f * (low + high);
    return low;
  }

  float length_to_rim(Vec2 from, Vec2 direction) const {
    constexpr float kStep = 0.008f, kFrom = 0.03f;  // the foot lies on the rim itself
    float length = kFrom;
    if (!blade_.holds(from + kFrom * direction, 1 - kEnd)) return 0;
    while (length < 3 && blade_.holds(from + (length + kStep) * direction, 1 - kEnd)) length += kStep;
    return length;
  }

  /// A straight vein from a point of the tree.
  MainVein axis(std::uint32_t first, Vec2 to) {
    MainVein a{{first}, tree_.veins().point[first], to};
    const int pieces = std::max(2, static_cast<int>(glm::distance(a.from, to) / kPiece));
    for (int k = 1; k <= pieces; ++k) {
      Vec2 p = glm::mix(a.from, to, static_cast<float>(k) / static_cast<float>(pieces));
      a.nodes.push_back(tree_.add(p, static_cast<std::int32_t>(a.nodes.back()), 1));
    }
    return a;
  }

  /// Whether a straight vein lies in the blade.
  bool clear_way(Vec2 from, Vec2 to) const {
    constexpr int kSteps = 24;
    for (int k = 1; k <= kSteps; ++k)
      if (!blade_.holds(glm::mix(from, to, static_cast<float>(k) / kSteps), kVeinEdge)) return false;
    return true;
  }

  /// The first point of a midrib from which the straight way to a lobe lies in the blade.
  std::uint32_t leaving(const MainVein& midrib, Vec2 lobe) const {
    for (std::uint32_t i : midrib.nodes) {
      Vec2 at = tree_.veins().point[i];
      if (at.y > blade_.middle().y) break;
      if (blade_.holds_way(at, lobe)) return i;
    }
    std::uint32_t best = midrib.nodes[0];
    for (std::uint32_t i : midrib.nodes)
      if (tree_.veins().point[i].y <= blade_.middle().y + kPiece) best = i;
    return best;
  }

  /// The node of an axis that is nearest to a share of it.
  static std::size_t node_at(const MainVein& a, double share) {
    auto last = static_cast<double>(a.nodes.size() - 1);
    return static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * last));
  }

  /// The tooth of one half that is nearest to a place on the rim, if one is near.
  std::optional<Vec2> tooth_at(Vec2 rim, float reach) const {
    std::optional<Vec2> best;
    for (double angle : teeth_) {
      Vec2 tip = blade_.at(rim.x < 0 ? -angle : angle, kEnd);
      if (float d = glm::distance(tip, rim); d < reach) reach = d, best = tip;
    }
    return best;
  }

  /// A vein that leaves a point of another one, whose direction is `forward`, a little backward and bends
  /// forward. It ends before others, and where the blade does.
  Side side_vein(std::uint32_t from, Vec2 forward, Vec2 to) {
    Side side;
    Vec2 start = tree_.veins().point[from];
    const float length = glm::distance(start, to);
    const int pieces = std::max(2, static_cast<int>(length / kPiece));
    Vec2 bend = glm::mix(start, to, 0.5f) - kBend * length * forward;
    auto at = [&](int k) {
      return on_bezier(start, bend, to, static_cast<float>(k) / static_cast<float>(pieces));
    };
    for (int k = 1; k <= pieces; ++k)
      if (!blade_.holds(at(k), kVeinEdge)) bend = glm::mix(start, to, 0.5f);
    const auto before = static_cast<std::uint32_t>(tree_.veins().size());
    const float apart = std::min(kApart, 0.45f / static_cast<float>(v_.secondaries));
    std::uint32_t last = from;
    for (int k = 1; k <= pieces; ++k) {
      Vec2 p = at(k);
      bool crowded = glm::distance(p, start) > 3 * apart && tree_.nearest(p, apart, before);
      if (crowded || !blade_.holds(p, kVeinEdge)) {
        side.cut = true;
        break;
      }
      last = tree_.add(p, static_cast<std::int32_t>(last), 2);
      side.nodes.push_back(last);
    }
    return side;
  }

  /// The secondaries on one side of a midrib, from its foot to its tip.
  std::vector<Side> secondaries(const MainVein& midrib, int side) {
    struct Plan {
      double share;
      std::optional<Vec2> lobe;
    };
    std::vector<Plan> plans;
    const float low = midrib.from.y, length = midrib.to.y - low;
    const double gap = 0.94 / v_.secondaries;
    double lowest = kLowestSide;
    for (std::size_t i = lobes_.size(); i-- > 0;) {  // from the foot
      Vec2 to = blade_.at(side * lobes_[i].angle, kEnd);
      double share = (to.y - std::abs(to.x) / std::tan(v_.angle) - low) / length;
      share = std::clamp(share, lowest, 0.94);
      // Toward the middle of the blade, from where all of the rim is visible, but not past those below.
      const double middle = std::max<double>(share, (blade_.middle().y - low) / length);
      for (int k = 0; k <= 10; ++k) {
        double s = std::lerp(share, middle, 0.1 * k);
        if (!clear_way(glm::mix(midrib.from, midrib.to, static_cast<float>(s)), to)) continue;
        plans.push_back({s, to});
        lowest = std::min(s + 0.4 * gap, 0.94);
        break;
      }
    }
    const std::size_t lobed = plans.size();
    for (int i = 0; i < v_.secondaries; ++i) {
      double shift = side > 0 ? 0.25 : -0.2;
      double share = kLowestSide + gap * (i + 0.35 + (i > 0 ? shift : 0) + 0.2 * jitter(i, side));
      bool taken = false;
      for (std::size_t k = 0; k < lobed; ++k) taken = taken || std::abs(plans[k].share - share) < 0.62 * gap;
      if (!taken && share < 0.95) plans.push_back({share, std::nullopt});
    }
    std::ranges::stable_sort(plans, {}, &Plan::share);
    std::vector<Side> made;
    // Those to lobes first, then what room they leave.
    for (bool lobe : {true, false})
      for (const Plan& p : plans)
        if (p.lobe.has_value() == lobe) made.push_back(secondary(midrib, side, p.share, p.lobe));
    std::ranges::stable_sort(made, {}, [&](const Side& s) {
      return s.nodes.empty() ? -1.0f : tree_.veins().point[s.nodes.front()].y;
    });
    return made;
  }

  double jitter(int i, int side) const {
    return seed_.child("side", 2 * static_cast<std::uint64_t>(i) + (side > 0)).range(-1, 1);
  }

  Side secondary(const MainVein& midrib, int side, double share, std::optional<Vec2> lobe) {
    std::uint32_t from = midrib.nodes[node_at(midrib, share)];
    Vec2 at = tree_.veins().point[from];
    const Vec2 forward(0, 1);
    if (lobe) return side_vein(from, forward, *lobe);
    // The lower ones leave at a wider angle.
    const double angle = v_.angle * (1.12 - 0.35 * share);
    Vec2 away(static_cast<float>(side * std::sin(angle)), static_cast<float>(std::cos(angle)));
    const float way = length_to_rim(at, away);
    if (way < kShortest) return {};
    Vec2 end = at + away * way;
    if (auto tooth = tooth_at(end, 0.06f)) return side_vein(from, forward, *tooth);
    if (v_.to_rim || !v_.loops) return side_vein(from, forward, end);
    Vec2 off = end - at;
    Vec2 arch = at + off * 0.86f + Vec2(0, 0.10f * std::abs(off.x));
    Side made = side_vein(from, forward, arch);
    made.arches = !made.cut;
    return made;
  }

  /// Secondaries that do not end at the rim arch to the next above them (brochidodromous).
  void arches(const std::vector<Side>& sides) {
    if (!v_.loops) return;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      if (!sides[i].arches || sides[i].nodes.size() < 3) continue;
      const std::vector<std::uint32_t>& next = sides[i + 1].nodes;
      if (next.size() < 3) continue;
      const std::uint32_t end = sides[i].nodes.back(), to = next[next.size() * 4 / 5];
      Vec2 a = tree_.veins().point[end], b = tree_.veins().point[to];
      Vec2 off = a - blade_.middle(), on = b - blade_.middle();
      Vec2 bend = blade_.middle() + 0.56f * (off + on);
      const int pieces = std::max(2, static_cast<int>(glm::distance(a, b) / kPiece));
      std::uint32_t last = end;
      bool whole = true;
      for (int k = 1; k < pieces && whole; ++k) {
        Vec2 p = on_bezier(a, bend, b, static_cast<float>(k) / static_cast<float>(pieces));
        whole = blade_.holds(p, 1 - kEnd);
        if (whole) last = tree_.add(p, static_cast<std::int32_t>(last), 2);
      }
      if (whole) tree_.join(last, to);
    }
  }

  /// The side veins of a main vein to a lobe. They end where another main vein is nearer.
  void ribs(const std::vector<MainVein>& all, std::size_t index, int side) {
    const MainVein& own = all[index];
    const Vec2 along = glm::normalize(own.to - own.from);
    const float length = glm::distance(own.from, own.to);
    const int count = std::max(2, static_cast<int>(std::lround(static_cast<float>(v_.secondaries) * length /
                                                               (1 - blade_.foot().y))));
    std::vector<Side> made;
    for (int i = 0; i < count; ++i) {
      double share = (i + 0.7 + (side > 0 ? 0.2 : -0.15)) / (count + 0.4);
      std::uint32_t from = own.nodes[node_at(own, share)];
      Vec2 at = tree_.veins().point[from];
      double turn = side * v_.angle * (1.05 - 0.3 * share);
      auto c = static_cast<float>(std::cos(turn)), s = static_cast<float>(std::sin(turn));
      Vec2 away(along.x * c + along.y * s, along.y * c - along.x * s);
      float way = 0;
      bool rim = false;
      while (!rim && nearer_to(all, index, at + (way + 0.01f) * away)) {
        rim = !blade_.holds(at + (way + 0.01f) * away, 1 - kEnd);
        if (!rim) way += 0.01f;
      }
      if (way < 0.02f) continue;
      Vec2 end = at + way * away;
      std::optional<Vec2> tooth = rim ? tooth_at(end, 0.05f) : std::nullopt;
      Vec2 to = tooth ? *tooth : rim && !v_.to_rim ? end - 0.12f * way * (away - along) : end;
      Side vein = side_vein(from, along, to);
      vein.arches = rim && !tooth && !v_.to_rim && !vein.cut;
      made.push_back(std::move(vein));
    }
    arches(made);
  }

  static float distance_to(const MainVein& a, Vec2 p) {
    Vec2 d = a.to - a.from;
    float t = std::clamp(glm::dot(p - a.from, d) / glm::dot(d, d), 0.0f, 1.0f);
    return glm::distance(p, a.from + t * d);
  }

  static bool nearer_to(const std::vector<MainVein>& all, std::size_t own, Vec2 p) {
    float d = distance_to(all[own], p);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (i != own && distance_to(all[i], p) < d) return false;
    return true;
  }

  /// A vein of a fan: the directions from the foot that it feeds, and how far it has come.
  struct Ray {
    std::uint32_t node;
    double low, high;
    float length;
  };

  void fork(Ray ray) {
    const float least = 0.42f / static_cast<float>(v_.secondaries) / static_cast<float>(v_.density);
    double toward = 0.5 * (ray.low + ray.high);
    // It bends from the direction that it has to the one that it takes.
    Vec2 foot = blade_.foot(), at = tree_.veins().point[ray.node] - foot;
    double has = ray.length > 0 ? std::atan2(at.x, at.y) : toward;
    double lot = seed_.child("fork", static_cast<std::uint64_t>(1e6 * (toward + 4))).range(0.75, 1.35);
    for (;;) {
      ray.length += kPiece;
      has += 0.3 * (toward - has);
      Vec2 p = foot + ray.length * Vec2(static_cast<float>(std::sin(has)), static_cast<float>(std::cos(has)));
      if (!blade_.holds(p, 1 - kEnd) && (ray.length > 3 * kPiece || !blade_.holds(p))) return;
      ray.node = tree_.add(p, static_cast<std::int32_t>(ray.node), 1);
      if (ray.length * static_cast<float>(ray.high - ray.low) < least * static_cast<float>(lot)) continue;
      fork({ray.node, ray.low, toward, ray.length});
      fork({ray.node, toward, ray.high, ray.length});
      return;
    }
  }

  const Venation& v_;
  const Lamina& blade_;
  VeinTree& tree_;
  Seed seed_{0};  // of what makes them a little irregular
  std::vector<double> teeth_;
  std::vector<RimTip> lobes_;
};

}  // namespace

void lay_main_veins(const LeafOutline& outline, const Lamina& blade, VeinTree& veins) {
  MainVeins main(outline, blade, veins);
  switch (outline.venation.pattern) {
    case VeinPattern::pinnate:
      return main.pinnate();
    case VeinPattern::palmate:
      return main.palmate();
    case VeinPattern::parallel:
      return main.parallel();
    case VeinPattern::dichotomous:
      return main.dichotomous();
  }
}

}  // namespace frond
