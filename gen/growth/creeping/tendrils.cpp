#include "creeping/tendrils.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "creeping/tendril_lines.h"

namespace frond {

namespace {

constexpr double kTaper = 0.4;    // of the radius, lost toward the tip
constexpr double kCoiling = 4;    // of the time in which it grows: until it has coiled
constexpr double kWinding = 1.5;  // of that time: until it has wound round its support

/// A line of nodes that leaves a node of the tendril, or the strand. Times are in those that a tendril takes.
struct Twig {
  std::vector<DVec3> at;
  std::vector<double> radius, time;
  std::int32_t from = -1;  // of the first twig; -1: the strand
};

struct Grown {
  TendrilState state = TendrilState::free;
  std::vector<Twig> twigs;  // none where it finds no room
};

/// A place of the host within reach.
struct Hold {
  DVec3 place{0}, normal{0};
  double score = 0;
};

/// A tendril that is to grow, and where.
struct Bearing {
  const TriangleSurface& host;
  const Tendrils& tendrils;
  const GroundHeight& ground;
  DVec3 foot{0}, heading{0, 1, 0}, normal{0}, aside{0};
  double age = 0;  // since its node is there
  Seed seed = {};
};

DVec3 unit_or(const DVec3& v, const DVec3& otherwise) {
  double length = glm::length(v);
  return length > 1e-9 ? v / length : otherwise;
}

/// Across a direction, of length 1.
DVec3 across(const DVec3& v, const DVec3& direction) {
  DVec3 side = v - glm::dot(v, direction) * direction;
  return unit_or(side, glm::normalize(glm::cross(direction, reference_axis(direction))));
}

DVec3 heading_at(const Skeleton& s, std::int32_t i) {
  std::int32_t p = s.parent[i];
  bool goes_on = i + 1 < static_cast<std::int32_t>(s.size()) && s.parent[i + 1] == i;
  DVec3 direction = goes_on ? DVec3(s.position[i + 1] - s.position[i]) : DVec3(0);
  if (p != Skeleton::kRoot) direction += DVec3(s.position[i] - s.position[p]);
  return unit_or(direction, DVec3(0, 1, 0));
}

/// Moves the places of a line, but the first, out of the host by their radius where they are too near. False
/// where that is too far, where the line goes through the host, or where it enters the ground.
bool set_clear(const Bearing& b, std::vector<DVec3>& line, double radius) {
  constexpr double kDeepest = 4;  // radii that a place is moved from within the host
  for (std::size_t i = 1; i < line.size(); ++i) {
    DVec3& at = line[i];
    std::optional<Contact> near = b.host.closest(at, kDeepest * radius);
    if (near && (near->inside || near->distance < radius)) at = near->point + radius * near->normal;
    if (b.ground && at.y < b.ground(at.x, at.z) + radius) return false;
    if (b.host.crossing(line[i - 1], at)) return false;
  }
  return !b.host.inside(line.back());
}

/// Places of the host within reach, the best first: toward its own side, upward, and near.
std::vector<Hold> holds_of(const Bearing& b) {
  constexpr int kProbes = 48;
  constexpr double kNearest = 0.35, kFarthest = 0.92;  // of the reach, so that some is left to coil
  constexpr double kOwn = 0.5;                         // sine of the angle to the strand
  const double reach = b.tendrils.reach;
  std::vector<Hold> holds;
  for (std::uint64_t k = 0; k < kProbes; ++k) {
    Seed own = b.seed.child("probe", k);
    double height = own.child(0).range(-1, 1), angle = own.child(1).range(0, 2 * kPi);
    double wide = std::sqrt(1 - height * height);
    DVec3 to(wide * std::cos(angle), height, wide * std::sin(angle));
    if (double back = glm::dot(to, b.aside); back < 0) to -= 2 * back * b.aside;
    DVec3 at = b.foot + own.child(2).range(kNearest, kFarthest) * reach * to;
    std::optional<Contact> near = b.host.closest(at, 0.5 * reach);
    if (!near || near->inside) continue;
    DVec3 way = near->point - b.foot;
    double far = glm::length(way);
    if (far < kNearest * reach || far > kFarthest * reach) continue;
    way /= far;
    // What its own strand runs along is no hold.
    if (glm::length(glm::cross(way, b.heading)) < kOwn) continue;
    double score = glm::dot(way, b.aside) + 0.35 * way.y + 0.3 * glm::dot(way, b.heading) - 0.8 * far / reach;
    holds.push_back({near->point, near->normal, score});
  }
  std::ranges::stable_sort(holds, std::greater{}, &Hold::score);
  return holds;
}

/// A line as a twig that takes its time from `start` to `end`. Its first place belongs to what it leaves.
Twig twig_of(const std::vector<DVec3>& line, double thick, double thin, double start, double end) {
  Twig twig;
  for (std::size_t i = 1; i < line.size(); ++i) {
    double share = static_cast<double>(i) / static_cast<double>(line.size() - 1);
    twig.at.push_back(line[i]);
    twig.radius.push_back(std::lerp(thick, thin, share));
    twig.time.push_back(std::lerp(start, end, share));
  }
  return twig;
}

void append(Twig& twig, const Twig& more) {
  twig.at.insert(twig.at.end(), more.at.begin(), more.at.end());
  twig.radius.insert(twig.radius.end(), more.radius.begin(), more.radius.end());
  twig.time.insert(twig.time.end(), more.time.begin(), more.time.end());
}

double coil_of(const Bearing& b) { return b.tendrils.coil * smooth_step(1.0, 1 + kCoiling, b.age); }

/// Round a thin part of the host.
std::optional<Grown> wind_round(const Bearing& b, const Hold& hold) {
  constexpr double kThickest = 0.25;  // of the reach
  const Tendrils& t = b.tendrils;
  std::optional<Pole> pole = pole_at(b.host, hold.place, hold.normal, kThickest * t.reach);
  if (!pole) return std::nullopt;
  double thin = (1 - kTaper) * t.radius, wound = std::min((b.age - 1) / kWinding, 1.0);
  double turns = std::max(0.2, t.turns * wound * b.seed.child("turns").range(0.75, 1.25));
  double pitch = 2 * thin * b.seed.child("pitch").range(1.1, 2.2);
  if (b.seed.child("down").unit() < 0.4) pitch = -pitch;
  double hand = b.seed.child("hand").unit() < 0.5 ? 1 : -1;
  std::vector<DVec3> round = wound_line(b.host, *pole, b.foot, turns, thin, pitch, hand);
  if (round.size() < 2 || !set_clear(b, round, thin)) return std::nullopt;
  double far = glm::distance(b.foot, round[0]);
  if (far > t.reach) return std::nullopt;
  DVec3 onward = unit_or(round[1] - round[0], b.heading);
  DVec3 bend = round[0] - 0.5 * far * onward + 0.22 * far * b.normal;
  std::vector<DVec3> line = coiled_line(b.foot, bend, round[0], t.coils, coil_of(b));
  if (!set_clear(b, line, thin)) return std::nullopt;
  Grown grown{TendrilState::wound, {twig_of(line, t.radius, thin, 0, 1)}};
  append(grown.twigs[0], twig_of(round, thin, thin, 1, 1 + kWinding * wound));
  return grown;
}

/// A short branch from a place of a tendril to the wall beside it, and the pad at its end: a disc that is
/// flat on the wall.
std::optional<Twig> padded_twig(const Bearing& b, const DVec3& from, const DVec3& direction, double length,
                                double start) {
  const Tendrils& t = b.tendrils;
  double thin = (1 - kTaper) * t.radius;
  std::optional<Contact> near = b.host.closest(from + length * direction);
  if (!near || near->inside || glm::distance(near->point, from) > 1.6 * length) return std::nullopt;
  const DVec3& n = near->normal;
  DVec3 end = near->point + std::max(0.9 * t.pad, thin) * n;
  std::vector<DVec3> line = coiled_line(from, 0.5 * (from + end) + 0.25 * length * n, end, 0, 0);
  // Walls bear very many, and half of the places do for so short a line.
  std::size_t kept = 0;
  for (std::size_t i = 0; i < line.size(); i += 2) line[kept++] = line[i];
  line.resize(kept);
  if (!set_clear(b, line, thin)) return std::nullopt;
  Twig twig = twig_of(line, thin, thin, start, start + 0.4);
  // A ball that is sunk into the wall, so that a disc as wide as the pad is seen, two thirds as high.
  for (auto [off, wide] : {std::array{0.35, 0.45}, std::array{-0.4, 1.08}}) {
    twig.at.push_back(near->point + off * t.pad * n);
    twig.radius.push_back(wide * t.pad);
    twig.time.push_back(start + 0.5);
  }
  return twig;
}

/// Against a wall, by short branches to either side of its end and one ahead.
std::optional<Grown> stick_to(const Bearing& b, const Hold& hold) {
  const Tendrils& t = b.tendrils;
  double thin = (1 - kTaper) * t.radius, far = glm::distance(hold.place, b.foot);
  const DVec3& n = hold.normal;
  DVec3 ahead = across(hold.place - b.foot, n);
  // Branches take the last part of the way.
  constexpr double kStem = 0.72;
  DVec3 end = b.foot + kStem * (hold.place - b.foot);
  if (std::optional<Contact> near = b.host.closest(end); near && !near->inside)
    end = near->point + (0.1 * far + thin) * near->normal;
  DVec3 bend = 0.5 * (b.foot + end) + 0.3 * far * unit_or(n + b.normal, n);
  std::vector<DVec3> line = coiled_line(b.foot, bend, end, t.coils, coil_of(b));
  if (!set_clear(b, line, thin)) return std::nullopt;
  Grown grown{TendrilState::padded, {twig_of(line, t.radius, thin, 0, 1)}};
  const Twig stem = grown.twigs[0];
  DVec3 beside = glm::cross(n, ahead);
  auto last = static_cast<std::int32_t>(stem.at.size()) - 1;
  for (int i = 0; i < t.branches; ++i) {
    // From the end downward, to either side in turn.
    Seed own = b.seed.child("branch", static_cast<std::uint64_t>(i));
    double down = t.branches > 1 ? static_cast<double>(i) / t.branches : 0;
    double angle = i == 0 ? 0 : (i % 2 ? 1 : -1) * radians(own.child(0).range(25, 60));
    auto from = std::max<std::int32_t>(0, last - static_cast<std::int32_t>(std::lround(0.55 * down * last)));
    DVec3 direction = std::cos(angle) * ahead + std::sin(angle) * beside;
    double length = (1 - kStem) * far * own.child(1).range(0.75, 1.15);
    std::optional<Twig> twig = padded_twig(b, stem.at[from], direction, length, stem.time[from]);
    if (!twig) continue;
    twig->from = from;
    grown.twigs.push_back(std::move(*twig));
  }
  return grown.twigs.size() > 1 ? std::optional(grown) : std::nullopt;
}

/// Straight toward a place, as far as it has come.
Grown reach_out(const Bearing& b, const DVec3& toward, double length) {
  const Tendrils& t = b.tendrils;
  double thin = (1 - kTaper) * t.radius;
  length *= std::clamp(b.age, 0.05, 1.0);
  DVec3 direction = unit_or(toward - b.foot, b.aside);
  std::vector<DVec3> line = coiled_line(b.foot, b.foot + 0.5 * length * direction + 0.06 * length * b.normal,
                                        b.foot + length * direction, 0, 0);
  Grown grown{b.age < 1 ? TendrilState::young : TendrilState::free, {}};
  double curled = smooth_step(1.0, 1 + kCoiling, b.age), grew = std::min(b.age, 1.0);
  std::size_t straight = line.size();
  if (curled > 0) {
    DVec3 side = across(b.normal - DVec3(0, 0.5, 0), direction);
    std::vector<DVec3> curl =
        curled_line(line.back(), direction, side, 2 * t.coil, 2.5 * curled, 2.6 * t.radius);
    line.insert(line.end(), curl.begin(), curl.end());
  }
  if (!set_clear(b, line, thin)) return grown;
  std::vector<DVec3> rest(line.begin() + static_cast<std::ptrdiff_t>(straight) - 1, line.end());
  line.resize(straight);
  grown.twigs.push_back(twig_of(line, t.radius, thin, 0, grew));
  if (rest.size() > 1) append(grown.twigs[0], twig_of(rest, thin, thin, grew, grew + curled));
  return grown;
}

Grown grow_tendril(const Bearing& b, bool hangs) {
  constexpr std::size_t kTries = 16;
  std::vector<Hold> holds = hangs ? std::vector<Hold>{} : holds_of(b);
  if (holds.size() > kTries) holds.resize(kTries);
  if (b.age < 1 && !holds.empty())
    return reach_out(b, holds[0].place + 0.4 * glm::distance(holds[0].place, b.foot) * b.normal,
                     0.8 * b.tendrils.reach);
  for (const Hold& hold : holds) {
    std::optional<Grown> grown = wind_round(b, hold);
    if (!grown && b.tendrils.pads) grown = stick_to(b, hold);
    if (grown) return *grown;
  }
  if (b.seed.child("waste").unit() >= b.tendrils.waste) return {};
  DVec3 toward = b.foot + b.aside + 0.5 * b.heading + 0.7 * b.normal + DVec3(0, 0.2, 0);
  return reach_out(b, toward, b.seed.child("length").range(0.6, 0.9) * b.tendrils.reach);
}

/// Adds a twig to strands as one more of them.
TendrilRun add_twig(Strands& s, const Twig& twig, std::int32_t node, std::int32_t below, double time,
                    TendrilState state) {
  Skeleton& k = s.skeleton;
  const std::int32_t of = s.of[node], first = static_cast<std::int32_t>(k.size());
  const float born = k.birth[node];
  const auto depth = static_cast<std::uint16_t>(k.order[node] + (below == node ? 1 : 2));
  for (std::size_t i = 0; i < twig.at.size(); ++i) {
    below = k.add(Vec3(twig.at[i]), static_cast<float>(twig.radius[i]), below, depth);
    float later = born + static_cast<float>(time * twig.time[i]);
    k.birth.back() = std::max(k.birth[k.parent.back()], std::min(later, 1.0f));
    s.normal.push_back(s.normal[node]);
    s.contact.push_back(k.position.back());
    s.age.push_back(born < 1 ? s.age[node] * (1 - k.birth.back()) / (1 - born) : 0);
    s.hanging.push_back(s.hanging[node]);
    s.room.push_back(0);  // one that rides on a hanging strand keeps its shape
    s.of.push_back(static_cast<std::int32_t>(s.strands.size()));
    if (!s.mask.empty()) s.mask.push_back(1);
  }
  auto count = static_cast<std::int32_t>(twig.at.size());
  s.strands.push_back({first, count, of, End::length});
  for (std::int32_t i = first + count - 1; i > first; --i)
    k.to_tip[i - 1] = k.to_tip[i] + k.distance[i] - k.distance[i - 1];
  return {first, count, state, depth > k.order[node] + 1};
}

}  // namespace

std::vector<TendrilRun> add_tendrils(Strands& strands, const TriangleSurface& host,
                                     const std::vector<TendrilSite>& sites, const Tendrils& tendrils,
                                     double time, Seed seed, const GroundHeight& ground) {
  std::vector<Grown> grown(sites.size());
  const Skeleton& s = strands.skeleton;
  parallel_for(sites.size(), [&](std::size_t i) {
    std::int32_t node = sites[i].node;
    if (s.to_tip[node] < tendrils.behind) return;
    const Strand& strand = strands.strands[strands.of[node]];
    Bearing b{host, tendrils, ground, DVec3(s.position[node]), heading_at(s, node)};
    b.normal = across(DVec3(strands.normal[node]), b.heading);
    b.aside = across(DVec3(sites[i].aside), b.heading);
    b.age = (1 - s.birth[node]) / time;
    b.seed = seed.child(static_cast<std::uint64_t>(strands.of[node]))
                 .child("node", static_cast<std::uint64_t>(node - strand.first));
    grown[i] = grow_tendril(b, strands.hanging[node] != 0);
  });
  std::vector<TendrilRun> runs;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    auto first = static_cast<std::int32_t>(s.size());
    for (const Twig& twig : grown[i].twigs) {
      std::int32_t below = twig.from < 0 ? sites[i].node : first + twig.from;
      runs.push_back(add_twig(strands, twig, sites[i].node, below, time, grown[i].state));
    }
  }
  return runs;
}

}  // namespace frond
