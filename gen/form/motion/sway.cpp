#include "motion/sway.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/loop.h"
#include "model/drag.h"
#include "motion/motion.h"

namespace frond {

namespace {

// Standing trees are softer than clear pieces of their wood: knots, and roots that yield. So much of it is
// left that conifers swing as fast as Moore and Maguire (2004) have measured.
constexpr double kStanding = 0.45;
constexpr double kWoodDamping = 0.05;  // of wood and roots, as a share of the critical one
constexpr int kFirstTurns = 6;         // of Stodola's iteration
constexpr int kSecondTurns = 16;
constexpr double kTremble = 2.3;        // swings of a leaf a second
constexpr double kTrembleAngle = 0.03;  // radians for each metre a second of wind
constexpr double kMostTremble = 0.45;   // radians
constexpr float kGusty = 1.5f;          // how much more leaves tremble in a gust

/// A segment as a beam.
struct Beam {
  float length = 0;            // metres
  float flex = 0;              // length / (E I): radians for each N m
  float mass = 0, area = 0;    // of all above its lower end; square metres of drag
  float moment = 0, drag = 0;  // at its middle, of its limb: kg m, and m3 of drag
  float righting = 0;          // of what hangs: the turn by its weight for each radian that it is tilted
};

class SwayMaker {
 public:
  SwayMaker(const Model& model, Sway& out)
      : rest_(model.skeleton), out_(out), n_(rest_.size()), beam_(n_), mass_(n_), area_(n_) {
    assert(rest_.order.size() == n_ && rest_.to_tip.size() == n_);
    find_limbs();
    weigh(leaf_areas(model));
    bend();
    if (!out_.limbs.empty()) find_second();
    answer();
  }

 private:
  bool same_limb(std::size_t i) const {
    std::int32_t p = rest_.parent[i];
    return p != Skeleton::kRoot && rest_.order[p] == rest_.order[i];
  }

  void find_limbs() {
    out_.limb.resize(n_);
    std::int32_t rows = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      std::int32_t p = rest_.parent[i];
      if (same_limb(i)) {
        out_.limb[i] = out_.limb[p];
        continue;
      }
      out_.limb[i] = static_cast<std::int32_t>(out_.limbs.size());
      bool own = p == Skeleton::kRoot || rest_.order[i] <= kSwayOrders;
      out_.limbs.push_back({static_cast<std::int32_t>(i), {}, own ? rows++ : out_.limbs[out_.limb[p]].gusts});
    }
    rows_ = static_cast<std::size_t>(rows);
  }

  /// Masses, drag and moments, from the tips down. Masses of segments count half at either end.
  void weigh(const std::vector<float>& leaves) {
    const auto pi = static_cast<float>(kPi), density = static_cast<float>(out_.wood.density);
    const auto stiffness = static_cast<float>(kStanding * out_.wood.stiffness);
    std::vector<float> moment(n_), drag(n_);  // at the lower end of each
    for (std::size_t i = n_; i-- > 0;) {
      std::int32_t p = rest_.parent[i];
      Beam& b = beam_[i];
      Vec3 along = p == Skeleton::kRoot ? Vec3(0) : rest_.position[i] - rest_.position[p];
      float r = rest_.radius[i];
      b.length = glm::length(along);
      b.flex = b.length / (stiffness * pi / 4 * r * r * r * r);
      float mass = density * pi * r * r * b.length + static_cast<float>(out_.wood.leaf_mass) * leaves[i];
      float faster = wind_at(rest_.position[i].y - along.y / 2 - rest_.position[0].y, 1);
      float area = faster * faster *
                   (kBareDrag * 2 * r * glm::length(glm::cross(along, out_.wind->along)) +
                    kLeafDrag * kSunlit * leaves[i]);
      b.moment = moment[i] + b.mass * b.length / 2 + mass * b.length / 8;
      b.drag = drag[i] + b.area * b.length / 2 + area * b.length / 8;
      moment[i] += (b.mass + mass / 2) * b.length, drag[i] += (b.area + area / 2) * b.length;
      b.mass += mass, b.area += area;
      mass_[i] += mass / 2, area_[i] += area / 2;
      if (p == Skeleton::kRoot) continue;
      beam_[p].mass += b.mass, beam_[p].area += b.area;
      mass_[p] += same_limb(i) ? mass / 2 : b.mass, area_[p] += same_limb(i) ? area / 2 : b.area;
      if (same_limb(i)) moment[p] += moment[i], drag[p] += drag[i];
    }
  }

  /// How each limb bends under the wind, and under its own weight turned across it: its first mode, nearly.
  void bend() {
    struct Sums {
      double work = 0, inertia = 0, drag = 0;
    };
    std::vector<float> tilt(n_), slope(n_);
    std::vector<Sums> sums(out_.limbs.size());
    y_.assign(n_, 0);
    out_.give.assign(n_, 0);
    for (std::size_t i = 0; i < n_; ++i) {
      std::int32_t p = rest_.parent[i];
      if (p == Skeleton::kRoot) continue;
      Beam& b = beam_[i];
      bool same = same_limb(i);
      float down = std::max(rest_.position[p].y - rest_.position[i].y, 0.0f);
      float sag = b.moment * b.flex * static_cast<float>(kGravity);
      b.righting = b.length > 0 ? sag * down / b.length : 0;
      float tilt_p = same ? tilt[p] : 0, slope_p = same ? slope[p] : 0, y_p = same ? y_[p] : 0;
      tilt[i] = (tilt_p + b.drag * b.flex) / (1 + b.righting);
      slope[i] = (slope_p + sag) / (1 + b.righting);
      out_.give[i] = tilt[i] - tilt_p;
      y_[i] = y_p + b.length * (slope_p + slope[i]) / 2;
      Sums& of = sums[out_.limb[i]];
      double y = y_[i];
      of.work += kGravity * mass_[i] * y, of.inertia += mass_[i] * y * y, of.drag += area_[i] * y * y;
    }
    for (std::size_t k = 0; k < sums.size(); ++k)
      out_.limbs[k].mode = mode_of(sums[k].work, sums[k].inertia, sums[k].drag);
  }

  /// The mode of a shape: rate^2 = work / inertia. The air damps it the more, the more drag it has.
  Mode mode_of(double work, double inertia, double drag) const {
    if (inertia <= 0 || work <= 0) return {1e4, 1};
    double rate = std::sqrt(work / inertia), wind = out_.wind->speed;
    double push = wind > 0 ? drag_power(wind) * drag_pressure(wind) / wind : 0;
    return {rate, std::min(kWoodDamping + push * drag / (2 * rate * inertia), 1.0)};
  }

  /// The stem under the forces of its swing: `y` becomes how far it is bent by them, `slope` its slopes.
  void load_stem(std::vector<double>& y, std::vector<double>& slope) const {
    std::vector<double> shear(n_), moment(n_);
    for (std::size_t k = stem_.size(); k-- > 0;) {
      std::size_t i = stem_[k];
      shear[i] += mass_[i] * y[i];
      moment[i] += shear[i] * beam_[i].length;
      if (!same_limb(i)) continue;
      auto p = static_cast<std::size_t>(rest_.parent[i]);
      shear[p] += shear[i], moment[p] += moment[i];
    }
    for (std::size_t i : stem_) {
      if (!same_limb(i)) y[i] = slope[i] = 0;
      if (!same_limb(i)) continue;
      auto p = static_cast<std::size_t>(rest_.parent[i]);
      double length = beam_[i].length;
      slope[i] = slope[p] + (moment[i] - shear[i] * length / 2) * beam_[i].flex;
      slope[i] /= 1 + beam_[i].righting;
      y[i] = y[p] + length * (slope[p] + slope[i]) / 2;
    }
  }

  /// One turn of Stodola's iteration: the rate squared of the shape, which is scaled to 1 at its widest.
  double turn_stem(std::vector<double>& y, std::vector<double>& slope) const {
    std::vector<double> before = y;
    load_stem(y, slope);
    double work = dot(before, y), inertia = dot(y, y), widest = 0;
    for (std::size_t i : stem_) widest = std::max(widest, std::abs(y[i]));
    for (std::size_t i : stem_) y[i] /= std::max(widest, 1e-30), slope[i] /= std::max(widest, 1e-30);
    return inertia > 0 ? work / inertia : 0;
  }

  /// Weighted by mass.
  double dot(const std::vector<double>& a, const std::vector<double>& b) const {
    double sum = 0;
    for (std::size_t i : stem_) sum += mass_[i] * a[i] * b[i];
    return sum;
  }

  void find_second() {
    out_.second.assign(n_, 0);
    out_.stem_second = {1e4, 1};
    for (std::size_t i = 0; i < n_; ++i)
      if (out_.limb[i] == 0) stem_.push_back(i);
    std::vector<double> first(n_), second(n_), slope(n_);
    double rate2 = 0;
    for (std::size_t i : stem_) first[i] = y_[i], second[i] = rest_.distance[i];
    for (int k = 0; k < kFirstTurns; ++k) rate2 = turn_stem(first, slope);
    double inertia = dot(first, first);
    if (stem_.size() < 4 || rate2 <= 0 || inertia <= 0) return;
    auto drag_of = [&](const std::vector<double>& y, bool squared) {
      double sum = 0;
      for (std::size_t i : stem_) sum += area_[i] * y[i] * (squared ? y[i] : 1);
      return sum;
    };
    out_.limbs[0].mode = mode_of(rate2 * inertia, inertia, drag_of(first, true));
    for (int k = 0; k < kSecondTurns; ++k) {
      double share = dot(second, first) / inertia;
      for (std::size_t i : stem_) second[i] -= share * first[i];
      rate2 = turn_stem(second, slope);
    }
    double own = dot(second, second);
    if (rate2 <= 0 || own <= 0) return;
    out_.stem_second = mode_of(rate2 * own, own, drag_of(second, true));
    double reach = drag_of(second, false) / (rate2 * own);
    for (std::size_t i : stem_)
      if (same_limb(i)) out_.second[i] = static_cast<float>(reach * (slope[i] - slope[rest_.parent[i]]));
  }

  void answer() {
    const std::vector<Gust>& gusts = out_.wind->gusts;
    out_.response.assign((rows_ + 1) * gusts.size(), 0);
    std::size_t row = 0;
    for (const SwayLimb& limb : out_.limbs) {
      if (static_cast<std::size_t>(limb.gusts) != row) continue;
      Vec3 at = rest_.position[limb.first];
      for (std::size_t k = 0; k < gusts.size(); ++k) {
        const Gust& g = gusts[k];
        std::complex<double> felt =
            std::polar(g.share, g.phase - double{g.wave.x} * at.x - double{g.wave.y} * at.z);
        std::complex<double> own = transfer(limb.mode, g.rate);
        out_.response[row * gusts.size() + k] = std::complex<float>(felt * own);
        if (row == 0)
          out_.response[rows_ * gusts.size() + k] =
              std::complex<float>(felt * (transfer(out_.stem_second, g.rate) - own));
      }
      ++row;
    }
  }

  const Skeleton& rest_;
  Sway& out_;
  std::size_t n_, rows_ = 0;
  std::vector<Beam> beam_;
  std::vector<float> mass_, area_, y_;  // of each node, and how far its limb bends there
  std::vector<std::size_t> stem_;
};

}  // namespace

std::complex<double> transfer(const Mode& mode, double rate) {
  double r = rate / mode.rate, real = 1 - r * r, imaginary = 2 * mode.damping * r;
  return std::complex<double>(real, -imaginary) / (real * real + imaginary * imaginary);
}

std::vector<float> leaf_areas(const Model& model) {
  std::vector<double> shape;
  for (const Prototype& prototype : model.prototypes) {
    double sum = 0;
    for (const OrganPart& part : prototype.parts)
      if (is_leaf(part.tissue)) sum += area(part.surface);
    shape.push_back(sum);
  }
  std::vector<float> areas(model.skeleton.size());
  const Organs& o = model.organs;
  for (std::size_t i = 0; i < o.size(); ++i) {
    if (o.node[i] == Skeleton::kRoot || (!o.loose.empty() && o.loose[i] > 0)) continue;
    areas[o.node[i]] += static_cast<float>(shape[o.prototype[i]]) * o.scale[i].x * o.scale[i].y;
  }
  return areas;
}

Sway sway_of(const Model& model, const SwayWood& wood, std::shared_ptr<const WindField> wind) {
  Sway sway;
  sway.wind = std::move(wind), sway.wood = wood;
  SwayMaker(model, sway);
  return sway;
}

WindLoads::WindLoads(const Skeleton& rest, const Sway& sway, double time, double exposure)
    : rest_(rest), sway_(sway), mean_(sway.wind->mean(time)), time_(time), exposure_(exposure) {
  assert(sway.give.size() == rest.size() && sway.limb.size() == rest.size());
  pressure_ = static_cast<float>(exposure * drag_pressure(mean_));
  power_ = static_cast<float>(drag_power(mean_));
  std::vector<std::complex<float>> now;
  for (const Gust& g : sway.wind->gusts)
    now.emplace_back(std::polar(1.0, std::remainder(g.rate * time, 2 * kPi)));
  assert(!now.empty());
  swing_.resize(sway.response.size() / now.size());
  for (std::size_t row = 0; row < swing_.size(); ++row)
    for (std::size_t k = 0; k < now.size(); ++k) {
      const std::complex<float>& r = sway.response[row * now.size() + k];
      swing_[row] += r.real() * now[k].real() - r.imag() * now[k].imag();
    }
}

Quat WindLoads::turn(std::size_t i, const std::vector<Quat>& turns) const {
  std::int32_t p = rest_.parent[i];
  if (p == Skeleton::kRoot) return Quat(1, 0, 0, 0);
  const Quat& borne = turns[p];
  float swing = swing_[sway_.limbs[static_cast<std::size_t>(sway_.limb[i])].gusts];
  float bend = pressure_ * (sway_.give[i] * (1 + power_ * swing) + sway_.second[i] * power_ * swing_.back());
  Vec3 segment = borne * (rest_.position[i] - rest_.position[p]);
  float length2 = glm::dot(segment, segment);
  if (length2 < 1e-16f) return borne;
  Vec3 axis = glm::cross(segment, sway_.wind->along) / std::sqrt(length2);
  float sine = glm::length(axis);
  // No more than what is left to the direction of the wind, or to the one against it.
  Vec3 half = axis * (0.5f * bend / (1 + std::abs(bend)));
  if (sine < 1e-6f) return borne;
  return glm::normalize(Quat(1, half.x, half.y, half.z) * borne);
}

void WindLoads::set_flutter(Pose& pose) const {
  if (pressure_ <= 0) return;
  pose.flutter = static_cast<float>(exposure_ * std::min(kTrembleAngle * mean_, kMostTremble));
  double rate = looping_rate(kTremble, sway_.wind->film_length);
  pose.flutter_phase = static_cast<float>(std::remainder(2 * kPi * rate * time_, 2 * kPi));
  pose.gusts.clear();
  for (const SwayLimb& limb : sway_.limbs)
    pose.gusts.push_back(std::clamp(1 + kGusty * swing_[limb.gusts], 0.2f, 2.5f));
}

}  // namespace frond
