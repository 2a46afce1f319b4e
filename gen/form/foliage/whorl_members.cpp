#include "foliage/whorl_members.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace frond {

namespace {

constexpr int kStations = 48, kTube = 16;  // of a midrib, and of its part in a tube
constexpr double kFree = 0.8;  // of the angle between neighbours, to which a blade may reach to either side
constexpr double kWidestAngle = 1.75;   // radians, the same of one that has few neighbours
constexpr double kClearance = 0.006;    // of the length, between blades that overlap
constexpr double kLeastRadius = 0.002;  // of the flower's size

double default_width(FloralPart part) {
  switch (part) {
    case FloralPart::sepals:
      return 0.36;
    case FloralPart::tepals:
      return 0.5;
    case FloralPart::petals:
      return 0.7;
    case FloralPart::stamens:
      return 0.035;
    case FloralPart::carpels:
      return 0.22;
  }
  return 0.5;
}

double default_open(FloralPart part) {
  switch (part) {
    case FloralPart::sepals:
      return radians(85.0);
    case FloralPart::tepals:
    case FloralPart::petals:
      return radians(65.0);
    case FloralPart::stamens:
      return radians(25.0);
    case FloralPart::carpels:
      return radians(15.0);
  }
  return 0;
}

/// Half the width at `t` as a share of the greatest: round at the foot, drawn out to a tip or round.
double outline_at(double t, const Whorl& w) {
  if (t <= 0 || t >= 1) return 0;
  if (t < w.widest) return std::pow(std::sin(t / w.widest * kPi / 2), 0.8);
  double x = (1 - t) / (1 - w.widest), point = std::pow(std::sin(x * kPi / 2), 1.15);
  return point + w.round * (std::sqrt(1 - (1 - x) * (1 - x)) - point);
}

const MemberSide* own_side(const Whorl& w, Side side) {
  const std::optional<MemberSide>& own = side == Side::upper  ? w.upper
                                         : side == Side::side ? w.side
                                                              : w.lower;
  return own ? &*own : nullptr;
}

/// Which layer a member is in: of a quincunx two outside, two inside, one between; of a bilateral whorl the
/// upper outside.
void set_layer(WhorlMember& m, const Whorl& w, int k) {
  if (w.aestivation == Aestivation::valvate) return;
  if (w.bilateral()) {
    m.outer = m.side == Side::upper ? 1 : m.side == Side::side ? 0 : -1;
    if (w.spiral) m.outer = 0;
  } else if (w.aestivation == Aestivation::contorted) {
    m.slope = 1;
  } else if (w.count % 2 == 1 && k == w.count - 1) {
    m.slope = 1;  // under the one before, which is inside, and over the first, which is outside
  } else {
    m.outer = k % 2 == 0 ? 1 : -1;
  }
}

}  // namespace

Opening opening_of(FloralPart part, double stage) {
  bool green = part == FloralPart::sepals,
       blade = green || part == FloralPart::tepals || part == FloralPart::petals;
  double wither = std::clamp(stage - 1, 0.0, 1.0), bud = std::clamp(stage, 0.0, 1.0);
  Opening o;
  o.open = green ? smooth_step(0.05, 0.8, bud) : smooth_step(0.25, 1.0, bud);
  double least = green ? 0.8 : blade ? 0.45 : 0.4;
  o.grown = least + (1 - least) * smooth_step(0.0, 0.9, bud);
  o.wither = wither;
  if (part == FloralPart::carpels)
    o.grown *= 1 + 0.35 * wither;
  else if (!green)
    o.grown *= 1 - (blade ? 0.3 : 0.4) * wither;
  return o;
}

Side side_of(double azimuth) {
  constexpr double kSlack = 1e-6;
  double off = std::abs(std::remainder(azimuth, 2 * kPi));
  return off <= kPi / 3 + kSlack ? Side::upper : off <= 2 * kPi / 3 + kSlack ? Side::side : Side::lower;
}

std::vector<double> azimuths(const FloralDiagram& diagram, std::size_t whorl) {
  double first = 0;
  for (std::size_t i = 0; i <= whorl; ++i) {
    const Whorl& w = diagram.whorls[i];
    first += w.turn.value_or(i == 0 ? 0 : kPi / w.count);
  }
  const Whorl& w = diagram.whorls[whorl];
  std::vector<double> all;
  for (int k = 0; k < w.count; ++k)
    all.push_back(first + (w.spiral ? kGoldenAngle * k : 2 * kPi * k / w.count));
  return all;
}

std::vector<WhorlMember> members_of(const FloralDiagram& diagram, std::size_t whorl, double stage) {
  const Whorl& w = diagram.whorls[whorl];
  const Receptacle& foot = diagram.receptacle;
  Opening opening = opening_of(w.part, stage);
  constexpr double kStep = 0.012;  // from whorl to whorl
  double height = w.at.value_or(kStep * static_cast<double>(whorl));
  double high = std::clamp(height / std::max(foot.height, 1e-6), 0.0, 1.0);
  double radius = w.radius.value_or(foot.radius * std::sqrt(1 - 0.9 * high * high));
  std::vector<WhorlMember> all;
  int k = 0;
  for (double azimuth : azimuths(diagram, whorl)) {
    double inner = w.spiral && w.count > 1 ? static_cast<double>(k) / (w.count - 1) : 0;
    WhorlMember m{.azimuth = azimuth,
                  .side = side_of(azimuth),
                  .open = w.open.value_or(default_open(w.part)),
                  .bend = w.bend,
                  .fold = w.fold,
                  .cup = w.cup};
    m.length = w.length * opening.grown;
    m.foot_radius = radius, m.foot_height = height, m.innermost = inner;
    double width = w.width.value_or(default_width(w.part));
    if (w.spiral) {
      m.length *= 1 + (w.spiral->length - 1) * inner;
      m.open += (w.spiral->open - m.open) * inner;
      m.foot_radius *= 1 - 0.9 * inner, m.foot_height += w.spiral->rise * inner;
    }
    if (const MemberSide* own = own_side(w, m.side)) {
      m.length *= own->length, width *= own->width;
      m.open = own->open.value_or(m.open), m.bend = own->bend.value_or(m.bend);
      m.fold = own->fold.value_or(m.fold), m.cup = own->cup.value_or(m.cup);
    }
    m.half = 0.5 * width * m.length;
    m.bend += opening.wither * radians(w.part == FloralPart::sepals ? 0.0 : 70.0);
    set_layer(m, w, k++);
    all.push_back(m);
  }
  return all;
}

WhorlBlades::WhorlBlades(const FloralDiagram& diagram, std::size_t whorl, double stage)
    : w_(diagram.whorls[whorl]),
      opening_(opening_of(w_.part, stage)),
      members_(members_of(diagram, whorl, stage)) {
  constexpr double kWithin = 0.84,
                   kInner = 0.12;  // of the bud's radius: the outermost whorl, and less for each
  fused_ = std::clamp(w_.fused.value_or(0), 0.0, 0.98);
  sector_ = w_.spiral ? 2 * kPi / std::min(w_.count, 5) : 2 * kPi / w_.count;
  bud_ = 0.5 * diagram.bud * std::max(kWithin - kInner * static_cast<double>(whorl), 0.3);
  midribs_.resize(members_.size());
  for (std::size_t k = 0; k < members_.size(); ++k) run(members_[k], midribs_[k]);
  keep_apart();
}

double WhorlBlades::tube_radius(double share) const {
  double length = w_.length * opening_.grown, foot = members_[0].foot_radius;
  double open = w_.tube ? (*w_.tube)(share)*length : foot + (0.28 * length - foot) * share;
  return std::max(std::min(open, bud_) + (open - std::min(open, bud_)) * opening_.open, kLeastRadius);
}

/// Closed it is a spindle that meets its like at the tip; open it leaves the axis by its angle and bends on.
void WhorlBlades::run(const WhorlMember& m, std::vector<Station>& midrib) const {
  double f = fused_, o = opening_.open, tube = f * w_.length * opening_.grown;
  double rim = f > 0 ? tube_radius(1) : 0;
  double lead = f > 0 ? std::atan2(rim - tube_radius(0.95), 0.05 * tube) : 0;  // angle of the tube at its rim
  double lobe = m.length * (1 - f), wide = std::min(bud_, 0.35 * lobe + m.foot_radius);
  if (w_.spiral) wide *= 1 - 0.6 * m.innermost;
  Station at{m.foot_radius, m.foot_height, 0, 1};
  for (int i = 0; i <= kStations; ++i) {
    double t = place_of(i);
    if (f > 0 && i <= kTube) {
      double u = static_cast<double>(i) / kTube,
             slope = std::atan2(tube_radius(std::min(u + 0.05, 1.0)) - tube_radius(std::max(u - 0.05, 0.0)),
                                (std::min(u + 0.05, 1.0) - std::max(u - 0.05, 0.0)) * tube);
      at = {tube_radius(u), m.foot_height + u * tube, std::sin(slope), std::cos(slope)};
      midrib.push_back(at);
      continue;
    }
    double u = (t - f) / (1 - f);
    double closed = f > 0 ? -kPi / 2 * rim * std::sin(kPi / 2 * u)
                          : kPi * std::cos(kPi * u) * (wide - m.foot_radius * (1 - u)) -
                                m.foot_radius * (1 - std::sin(kPi * u));
    double shut = std::asin(std::clamp(closed / lobe, -0.95, 0.95));
    double spread = f > 0 ? lead + (m.open - lead) * smooth_step(0.0, 0.4, u) : m.open;
    double angle = shut + (spread + m.bend * u - shut) * o;
    double step = i == 0 ? 0 : lobe / (kStations - (f > 0 ? kTube : 0));
    at.sine = std::sin(angle), at.cosine = std::cos(angle);
    at.radius = std::max(at.radius + at.sine * step, kLeastRadius), at.height += at.cosine * step;
    midrib.push_back(at);
  }
}

double WhorlBlades::place_of(int station) const {
  if (fused_ <= 0) return static_cast<double>(station) / kStations;
  if (station <= kTube) return fused_ * station / kTube;
  return fused_ + (1 - fused_) * (station - kTube) / (kStations - kTube);
}

double WhorlBlades::station_of(double t) const {
  t = std::clamp(t, 0.0, 1.0);
  if (fused_ <= 0) return t * kStations;
  if (t <= fused_) return t / fused_ * kTube;
  return kTube + (t - fused_) / (1 - fused_) * (kStations - kTube);
}

WhorlBlades::Station WhorlBlades::station(std::size_t k, double t) const {
  double x = station_of(t);
  auto i = std::min(static_cast<std::size_t>(x), static_cast<std::size_t>(kStations - 1));
  double part = x - static_cast<double>(i);
  const Station &a = midribs_[k][i], &b = midribs_[k][i + 1];
  auto mix = [&](double p, double q) { return p + (q - p) * part; };
  return {mix(a.radius, b.radius), mix(a.height, b.height), mix(a.sine, b.sine), mix(a.cosine, b.cosine)};
}

double WhorlBlades::half_at(const WhorlMember& m, double t) const {
  if (fused_ <= 0) return std::max(m.half * outline_at(t, w_), 0.012 * m.length * (1 - t));
  double u = (t - fused_) / (1 - fused_), base = 0.5 * sector_ * tube_radius(1),
         most = std::max(m.half * (1 - fused_), base * 0.2);
  if (u < w_.widest) return base + (most - base) * std::sin(u / w_.widest * kPi / 2);
  return most * outline_at(u, w_);
}

double WhorlBlades::rim_angle(std::size_t k, double t) const {
  if (fused_ > 0 && t <= fused_) return 0.5 * sector_;
  double most = w_.aestivation == Aestivation::valvate ? 0.5 * sector_ : kFree * sector_;
  double angle = half_at(members_[k], t) / std::max(station(k, t).radius, kLeastRadius);
  return std::min({angle, most, kWidestAngle});
}

double WhorlBlades::rise(const WhorlMember& m, double t, double s) const {
  if (t <= fused_) return 0;
  double half = half_at(m, t), share = std::abs(s), out = (t - fused_) / (1 - fused_);
  double begins = fused_ > 0 ? smooth_step(0.0, 0.4, out) : 1;
  double high = half * (std::sin(m.fold) * share * (1 - 0.45 * share) +
                        m.cup * s * s * std::sin(kPi * std::min(out * 1.2, 1.0)));
  double wave = w_.wave + 0.9 * opening_.wither;
  high += 0.06 * wave * m.length * s * s * out * std::sin(out * 17 + (w_.bilateral() ? 0.0 : s));
  return high * begins * opening_.open;
}

/// By stations the least distance of layers at which no blade meets its neighbour's where they overlap.
void WhorlBlades::keep_apart() {
  apart_.assign(kStations + 1, 0);
  if (w_.count < 2 || w_.spiral || w_.aestivation == Aestivation::valvate) return;
  constexpr int kSamples = 24;
  bool contorted = w_.aestivation == Aestivation::contorted && !w_.bilateral();
  const WhorlMember& m = members_[0];
  for (int i = 0; i <= kStations; ++i) {
    double t = place_of(i), rim = rim_angle(0, t), overlap = 2 * rim - sector_;
    if (t <= fused_ || overlap <= 0) continue;
    double most = 0;
    for (int j = 0; j <= kSamples; ++j) {
      double a = sector_ - rim + overlap * j / kSamples;
      most = std::max(most, std::abs(rise(m, t, a / rim) - rise(m, t, (a - sector_) / rim)));
    }
    double factor = contorted ? sector_ / rim : 1.25;
    apart_[static_cast<std::size_t>(i)] = (most + std::min(kClearance * m.length, 0.08 * bud_)) / factor;
  }
  // The largest of neighbours, then their mean, is smooth and nowhere less than what is needed.
  constexpr int kNear = 4;
  std::vector<double> largest(apart_.size());
  for (int i = 0; i <= kStations; ++i) {
    auto near = std::span(apart_).subspan(static_cast<std::size_t>(std::max(i - kNear, 0)));
    near = near.first(std::min(near.size(), static_cast<std::size_t>(std::min(i, kNear) + kNear + 1)));
    largest[static_cast<std::size_t>(i)] = *std::ranges::max_element(near);
  }
  for (int i = 0; i <= kStations; ++i) {
    auto near = std::span<const double>(largest).subspan(static_cast<std::size_t>(std::max(i - kNear, 0)));
    near = near.first(std::min(near.size(), static_cast<std::size_t>(std::min(i, kNear) + kNear + 1)));
    apart_[static_cast<std::size_t>(i)] =
        std::accumulate(near.begin(), near.end(), 0.0) / static_cast<double>(near.size());
  }
}

double WhorlBlades::layer(double t) const {
  if (t <= fused_) return 0;
  double x = station_of(t);
  auto i = std::min(static_cast<std::size_t>(x), static_cast<std::size_t>(kStations - 1));
  double begins = fused_ > 0 ? smooth_step(fused_, fused_ + 0.15 * (1 - fused_), t) : 1;
  return begins * (apart_[i] + (apart_[i + 1] - apart_[i]) * (x - static_cast<double>(i)));
}

Vec3 WhorlBlades::at(std::size_t k, double t, double s, double above) const {
  const WhorlMember& m = members_[k];
  double rim = rim_angle(k, t);
  double in = 1 - std::abs(s),
         notched = t > fused_ ? t * (1 - w_.notch * in * std::sqrt(in) * std::pow(t, 4)) : t;
  Station here = station(k, notched);
  double off = rise(m, t, s) + layer(t) * (m.slope * s - m.outer) + above +
               0.05 * m.innermost * m.length * (1 - opening_.open);
  double radius = std::max(here.radius - here.cosine * off, 0.5 * kLeastRadius),
         height = here.height + here.sine * off;
  double angle = m.azimuth + s * rim;
  if (fused_ > 0) {
    double share = std::min(t / fused_, 1.0);
    height -=
        w_.slant * w_.length * opening_.grown * share * share * std::cos(angle) * (0.3 + 0.7 * opening_.open);
  }
  return Vec3(radius * std::sin(angle), height, radius * std::cos(angle));
}

}  // namespace frond
