#include "foliage/inflorescence.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "foliage/floret_crowd.h"
#include "foliage/stalk_frame.h"

namespace frond {

namespace {

/// A flower that is wanted: where its stalk begins and how.
struct Wanted {
  FloretRole role = FloretRole::flower;
  std::int32_t node = -1;
  Vec3 foot{0}, way{0, 1, 0};
  double stalk = 0, age = 1, stage = 1, scale = 1, nod = 0;
  std::uint16_t order = 0;
};

/// Lays one inflorescence.
class Layout {
 public:
  Layout(const Inflorescence& params, double later, Vec3 down, RoomOf room, Seed seed)
      : p_(params), later_(later), down_(down), room_(room), seed_(seed) {}

  LaidInflorescence lay() {
    switch (p_.type) {
      case InflorescenceType::raceme:
      case InflorescenceType::spike:
      case InflorescenceType::corymb:
        along_axis();
        break;
      case InflorescenceType::umbel:
        umbel(axis_to(1), frame_, p_.flowers, p_.angle, p_.pedicel, 0, 1, 1);
        involucre(tip_);
        break;
      case InflorescenceType::compound_umbel:
        compound_umbel();
        break;
      case InflorescenceType::panicle:
        panicle();
        break;
      case InflorescenceType::dichasium:
        dichasium();
        break;
      case InflorescenceType::scorpioid:
        scorpioid();
        break;
      case InflorescenceType::capitulum:
        capitulum();
        break;
      case InflorescenceType::spadix:
        spadix();
        break;
    }
    finish();
    return std::move(laid_);
  }

 private:
  std::int32_t add_node(Vec3 at, double radius, std::int32_t parent, std::uint16_t order) {
    laid_.nodes.push_back({at, std::max(radius, 1e-5), parent, order});
    return static_cast<std::int32_t>(laid_.nodes.size()) - 1;
  }

  /// Goes on along the axis to a share of its length, by short steps where it arches; `tip_` and `frame_`
  /// follow.
  std::int32_t axis_to(double share) {
    constexpr double kStep = 0.08;
    auto steps = p_.arch != 0 ? std::max(1, static_cast<int>(std::ceil((share - share_) / kStep))) : 1;
    double from = share_;
    for (int i = 1; i <= steps; ++i) {
      double to = from + (share - from) * i / steps, middle = p_.arch * 0.5 * (share_ + to),
             end = p_.arch * to;
      tip_ += Vec3(0, static_cast<float>(std::cos(middle)), -static_cast<float>(std::sin(middle))) *
              static_cast<float>((to - share_) * p_.length);
      frame_ = {Vec3(0, std::cos(end), -std::sin(end)), Vec3(0, std::sin(end), std::cos(end)), Vec3(1, 0, 0)};
      share_ = to;
      node_ = add_node(tip_, 0.5 * p_.stem * (1 - 0.6 * to), node_, 0);
    }
    return node_;
  }

  double stage_at(double age) const {
    return std::clamp(p_.stages(p_.basipetal ? 1 - age : age) + later_, 0.0, 2.0);
  }

  double tip_angle() const { return p_.tip_angle.value_or(0.4 * p_.angle); }

  void want(std::int32_t node, Vec3 foot, Vec3 way, double stalk, double age, std::uint16_t order,
            FloretRole role = FloretRole::flower) {
    Seed own = seed_.child("floret", wanted_.size());
    double stage = stage_at(age), grown = std::min(stage, 1.0);
    StalkFrame frame = frame_along(way, Vec3(0, 0, 1));
    way = frame.direction(p_.jitter * own.child(0).unit(), 2 * kPi * own.child(1).unit());
    Wanted w{role,
             node,
             foot,
             way,
             stalk * (0.4 + 0.6 * grown) * own.child(2).range(0.9, 1.1),
             age,
             stage,
             p_.least + (1 - p_.least) * grown,
             p_.nod * smooth_step(0.0, 1.0, grown),
             order};
    wanted_.push_back(w);
  }

  void bract_at(std::int32_t node, Vec3 at, Vec3 heading, Vec3 up, double scale) {
    if (p_.bract.empty()) return;
    laid_.florets.push_back({FloretRole::bract, at, heading, frame_along(heading, up).front, scale, 1, node});
  }

  /// The azimuth of flower `k` of node `i`, drawn to the side that the axis arches to.
  double azimuth_of(int i, int k) const {
    double half_turn = p_.whorl > 1 ? kPi / p_.whorl * i : p_.divergence * i;
    double azimuth = half_turn + 2 * kPi * k / p_.whorl;
    return kPi + std::remainder(azimuth - kPi, 2 * kPi) * (1 - 0.85 * p_.sided);
  }

  void along_axis() {
    int nodes = (p_.flowers + p_.whorl - 1) / p_.whorl, made = 0;
    for (int i = 0; i < nodes; ++i) {
      double share = nodes > 1 ? static_cast<double>(i) / (nodes - 1) : 0;
      // Nodes are closer to each other toward the tip, where they are younger.
      axis_to(p_.bare + (1 - p_.bare) * (1.6 * share - 0.6 * share * share));
      double age = 1 - share, angle = tip_angle() + (p_.angle - tip_angle()) * smooth_step(0.0, 0.8, age);
      for (int k = 0; k < p_.whorl && made < p_.flowers; ++k, ++made) {
        double azimuth = azimuth_of(i, k), stalk = p_.type == InflorescenceType::spike ? 0.0005 : p_.pedicel;
        if (p_.type == InflorescenceType::corymb) {
          // All end at one height: the lower the node, the longer the stalk.
          double up = std::max((1 - share_) * p_.length + p_.pedicel, p_.pedicel);
          angle = p_.angle * (0.15 + 0.85 * age);
          stalk = up / std::max(std::cos(angle), 0.2);
        }
        want(node_, tip_, frame_.direction(angle, azimuth), stalk, age, 1);
        bract_at(node_, tip_, frame_.direction(angle + radians(12.0), azimuth), frame_.along,
                 0.5 + 0.5 * age);
      }
    }
  }

  /// Stalks from one place, spread evenly over the cap of that half angle; the outer ones are the older.
  void umbel(std::int32_t node, const StalkFrame& frame, int count, double angle, double stalk,
             double youngest, double oldest, std::uint16_t order) {
    Vec3 foot = node >= 0 ? laid_.nodes[static_cast<std::size_t>(node)].at : Vec3(0);
    for (int i = 0; i < count; ++i) {
      double out = (i + 0.5) / count, tilt = std::acos(1 - out * (1 - std::cos(angle)));
      want(node, foot, frame.direction(tilt, kGoldenAngle * i), stalk, youngest + (oldest - youngest) * out,
           order);
    }
  }

  void involucre(Vec3 at) {
    for (int i = 0; i < p_.involucre; ++i)
      bract_at(node_, at, frame_.direction(radians(75.0), 2 * kPi * i / p_.involucre), frame_.along, 1);
  }

  void compound_umbel() {
    axis_to(1);
    involucre(tip_);
    std::int32_t hub = node_;
    int left = p_.flowers;
    for (int i = 0; i < p_.branches; ++i) {
      double out = (i + 0.5) / p_.branches, tilt = std::acos(1 - out * (1 - std::cos(p_.angle)));
      tilt += p_.jitter * seed_.child("branch", static_cast<std::uint64_t>(i)).range(-0.7, 0.7);
      Vec3 way = frame_.direction(tilt, kGoldenAngle * i);
      // The outer ones are longer, so that the whole is flat rather than a ball.
      double length = p_.branch * (0.75 + 0.25 * out) / std::max(std::cos(0.6 * tilt), 0.4) *
                      std::max(std::cos(0.6 * p_.angle), 0.4);
      Vec3 bend = glm::normalize(way + frame_.along * 0.25f);
      auto half = static_cast<float>(0.5 * length);
      std::int32_t middle = add_node(tip_ + way * half, 0.2 * p_.stem, hub, 1);
      std::int32_t end = add_node(tip_ + way * half + bend * half, 0.17 * p_.stem, middle, 1);
      int count = left / (p_.branches - i);
      left -= count;
      umbel(end, frame_along(bend, frame_.front), count, p_.tip_angle.value_or(radians(55.0)), p_.pedicel,
            0.5 * out, 0.5 + 0.5 * out, 2);
    }
  }

  void panicle() {
    int left = p_.flowers;
    double shares = 0.575 * p_.branches, weight = 0;  // sum of the branches' lengths, and of those so far
    for (int i = 0; i < p_.branches; ++i) {
      double share = p_.branches > 1 ? static_cast<double>(i) / (p_.branches - 1) : 0;
      axis_to(p_.bare + (1 - p_.bare) * share);
      std::int32_t from = node_;
      double length = p_.branch * (1 - 0.85 * share), angle = p_.angle + (tip_angle() - p_.angle) * share;
      weight += (1 - 0.85 * share) / shares;
      int count =
          i + 1 == p_.branches
              ? left
              : std::clamp(static_cast<int>(std::lround(p_.flowers * weight)) - (p_.flowers - left), 0, left);
      left -= count;
      StalkFrame branch = frame_along(frame_.direction(angle, azimuth_of(i, 0)), frame_.along);
      bract_at(from, tip_, branch.along, frame_.along, 1 - 0.6 * share);
      Vec3 at = tip_;
      for (int k = 0; k < count; ++k) {
        double out = (k + 1.0) / count;
        auto step = static_cast<float>((k == 0 ? 0.35 : 0.65 / std::max(count - 1, 1)) * length);
        at += branch.along * step;
        branch = frame_along(
            glm::normalize(branch.along +
                           frame_.along * (0.12f * step / std::max(static_cast<float>(length), 1e-9f))),
            branch.front);
        from = add_node(at, 0.3 * p_.stem * (1 - 0.5 * out), from, 1);
        bool last = k + 1 == count;
        Vec3 way = last ? branch.along : branch.direction(radians(45.0), kGoldenAngle * k);
        want(from, at, way, p_.pedicel, 0.5 * (1 - share) + 0.5 * (1 - out), 2);
      }
    }
  }

  void dichasium() {
    struct Fork {
      std::int32_t node;
      StalkFrame frame;
      double length;
      int depth;
    };
    axis_to(1);
    std::vector<Fork> forks{{node_, frame_, p_.branch, 0}};
    int depths = std::max(1, static_cast<int>(std::ceil(std::log2(p_.flowers + 1.0))));
    for (std::size_t i = 0; i < forks.size() && static_cast<int>(i) < p_.flowers; ++i) {
      Fork fork = forks[i];
      Vec3 at = laid_.nodes[static_cast<std::size_t>(fork.node)].at;
      auto order = static_cast<std::uint16_t>(fork.depth + 1);
      double age = depths > 1 ? 1 - static_cast<double>(fork.depth) / (depths - 1) : 1;
      want(fork.node, at, fork.frame.along, p_.pedicel, std::max(age, 0.0), order);
      for (int side : {0, 1}) {
        // Each pair stands crosswise to the one before.
        double azimuth = kPi * side + (fork.depth % 2 == 0 ? kPi / 2 : 0);
        Vec3 way = fork.frame.direction(p_.angle, azimuth);
        if (forks.size() >= static_cast<std::size_t>(p_.flowers)) break;
        bract_at(fork.node, at, fork.frame.direction(p_.angle + radians(15.0), azimuth), fork.frame.along,
                 1 - 0.12 * fork.depth);
        double radius = 0.35 * p_.stem * std::pow(0.85, fork.depth);
        std::int32_t end = add_node(at + way * static_cast<float>(fork.length), radius, fork.node, order);
        forks.push_back({end, frame_along(glm::normalize(way + fork.frame.along * 0.15f), fork.frame.front),
                         0.72 * fork.length, fork.depth + 1});
      }
    }
  }

  /// The axis is straight at its foot and coils toward its tip, where the buds are.
  void scorpioid() {
    constexpr double kCoil = 1.6 * kPi;  // of the tip
    axis_to(p_.bare);
    double angle = 0, step = (1 - p_.bare) * p_.length / std::max(p_.flowers, 1);
    for (int i = 0; i < p_.flowers; ++i) {
      double share = (i + 1.0) / p_.flowers, age = 1 - share;
      // What has bloomed has uncoiled.
      double coiled = smooth_step(0.0, 1.0, share) * std::clamp(1.5 - later_ - p_.stages(age), 0.1, 1.0);
      angle += kCoil / p_.flowers * 2 * coiled;
      Vec3 along(0, static_cast<float>(std::cos(angle)), -static_cast<float>(std::sin(angle)));
      frame_ = {along, Vec3(0, -along.z, along.y), Vec3(1, 0, 0)};
      tip_ += along * static_cast<float>(step * (1 - 0.55 * share));
      node_ = add_node(tip_, 0.5 * p_.stem * (1 - 0.6 * share), node_, 0);
      want(node_, tip_, frame_.direction(p_.angle, (i % 2 == 0 ? 0.5 : -0.5) * radians(80.0)), p_.pedicel,
           age, 1);
    }
  }

  /// Florets in Vogel's spiral (1979) on a dome; the distance between neighbours is nowhere below 1.6 of its
  /// unit.
  void capitulum() {
    constexpr double kNearest = 1.6;
    axis_to(1);
    double radius = 0.5 * p_.width, unit = radius / std::sqrt(std::max(p_.flowers, 1)),
           high = p_.dome * radius;
    for (int i = 0; i < p_.flowers; ++i) {
      double out = std::sqrt((i + 0.5) / p_.flowers), age = out, stage = stage_at(age);
      Vec3 heading = frame_.direction(std::atan(2 * p_.dome * out), kGoldenAngle * i);
      Vec3 at = tip_ + frame_.direction(kPi / 2, kGoldenAngle * i) * static_cast<float>(radius * out) +
                frame_.along * static_cast<float>(high * (1 - out * out));
      sessile(FloretRole::flower, at, heading, stage, kNearest * unit);
    }
    for (int i = 0; i < p_.rays && !p_.ray.empty(); ++i) {
      Seed own = seed_.child("ray", static_cast<std::uint64_t>(i));
      double azimuth = 2 * kPi * i / p_.rays, lean = p_.angle + p_.jitter * own.range(-1, 1);
      Vec3 heading = frame_.direction(lean, azimuth + 0.5 * p_.jitter * own.child(1).range(-1, 1));
      Vec3 at = tip_ + frame_.direction(kPi / 2, azimuth) * static_cast<float>(radius * 0.97) -
                frame_.along * static_cast<float>(i % 2 == 0 ? 0.0 : 0.02 * radius);
      laid_.florets.push_back({FloretRole::ray, at, heading, frame_along(heading, frame_.along).front, 1,
                               std::clamp(1 + later_, 0.0, 2.0), node_});
    }
    for (int i = 0; i < p_.involucre && !p_.bract.empty(); ++i) {
      double azimuth = kGoldenAngle * i, lower = static_cast<double>(i) / std::max(p_.involucre, 1);
      Vec3 at = tip_ + frame_.direction(kPi / 2, azimuth) * static_cast<float>(radius * (1 - 0.5 * lower)) -
                frame_.along * static_cast<float>(radius * 0.3 * lower);
      bract_at(node_, at, frame_.direction(radians(70.0 - 20.0 * lower), azimuth), frame_.along,
               1 - 0.3 * lower);
    }
  }

  /// Florets in a spiral of even steps up a cylinder, as close to each other as they are round it.
  void spadix() {
    axis_to(p_.bare);
    double round = kPi * p_.width, high = (1 - p_.bare) * p_.length,
           each = std::sqrt(round * high / std::max(p_.flowers, 1));
    for (int i = 0; i < p_.flowers; ++i) {
      double share = (i + 0.5) / p_.flowers, taper = std::sqrt(std::max(1 - std::pow(share, 6), 0.05));
      axis_to(p_.bare + (1 - p_.bare) * share);
      laid_.nodes.back().radius = std::max(0.5 * p_.width * taper - 0.1 * each, 0.5 * p_.stem);
      Vec3 heading = frame_.direction(
          radians(90.0) - (radians(90.0) - p_.angle) * smooth_step(0.75, 1.0, share), kGoldenAngle * i);
      Vec3 at =
          tip_ + frame_.direction(kPi / 2, kGoldenAngle * i) * static_cast<float>(0.5 * p_.width * taper);
      sessile(FloretRole::flower, at, heading, stage_at(1 - share), 0.75 * each * taper);
    }
    if (!p_.bract.empty()) bract_at(0, laid_.nodes[0].at, Vec3(0, 1, 0), Vec3(0, 0, 1), 1);
  }

  /// A floret without a stalk, no wider than there is room.
  void sessile(FloretRole role, Vec3 at, Vec3 heading, double stage, double room) {
    double grown = std::min(stage, 1.0), scale = p_.least + (1 - p_.least) * grown,
           radius = room_(role, stage).radius * scale;
    if (2 * radius > room) scale *= room / (2 * radius);
    laid_.florets.push_back(
        {role, at, heading, frame_along(heading, frame_.along).front, scale, stage, node_});
  }

  /// What is wanted makes room; then the stalks are drawn.
  void finish() {
    std::vector<CrowdFloret> crowd;
    for (const Wanted& w : wanted_) {
      OrganRoom room = room_(w.role, w.stage);
      crowd.push_back({w.foot,
                       w.way,
                       w.way,
                       w.stalk,
                       w.nod,
                       {room.from * w.scale, room.to * w.scale, room.radius * w.scale}});
    }
    make_room(crowd, down_);
    for (std::size_t i = 0; i < crowd.size(); ++i) {
      const CrowdFloret& f = crowd[i];
      const Wanted& w = wanted_[i];
      std::int32_t node = w.node;
      double thick = std::max(0.16 * p_.stem, 0.0002);
      if (f.stalk > 0.001) {
        // It leaves the axis as it would without neighbours, and bends to where there is room.
        Vec3 middle = f.foot + direction_or(f.way + f.rest, f.way) * static_cast<float>(0.5 * f.stalk);
        node = add_node(middle, thick, node, w.order);
        node = add_node(f.tip(), thick, node, w.order);
      }
      Vec3 heading = heading_of(f, down_), up = -down_;
      // What looks straight up or down has its upper side to the axis.
      if (std::abs(glm::dot(heading, up)) > 0.97f)
        up = frame_along(heading, -f.way + 0.3f * frame_.along).front;
      laid_.florets.push_back(
          {w.role, f.tip(), heading, frame_along(heading, up).front, w.scale, w.stage, node});
    }
  }

  const Inflorescence& p_;
  double later_;
  Vec3 down_;
  RoomOf room_;
  Seed seed_;
  LaidInflorescence laid_;
  std::vector<Wanted> wanted_;
  // Where the axis has come to.
  double share_ = 0;
  Vec3 tip_{0};
  StalkFrame frame_;
  std::int32_t node_ = -1;
};

}  // namespace

LaidInflorescence lay_inflorescence(const Inflorescence& params, double later, Vec3 down, RoomOf room,
                                    Seed seed) {
  return Layout(params, later, down, room, seed).lay();
}

}  // namespace frond
