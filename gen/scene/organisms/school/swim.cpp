#include "organisms/school/swim.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/bytes.h"

namespace frond {

std::size_t Trajectory::bytes() const {
  return bytes_of(position) + bytes_of(velocity) + bytes_of(heading) + bytes_of(stroke) + bytes_of(size) +
         bytes_of(next);
}

namespace {

constexpr double kStep = 1.0 / 20;   // seconds, about
constexpr double kSettling = 8;      // seconds before the film in which they find their order
constexpr double kStillPeriod = 24;  // seconds of a still picture's round
constexpr double kMostBlend = 2.5;   // seconds in which the end goes over into the beginning
constexpr double kBlendShare = 0.6;  // of the film, at most
constexpr double kBodyShare = 0.5;   // of its length that it keeps clear, as its nose and its tail stand out

// Accelerations by which fish are steered, each 1/s, by eye.
constexpr float kAlignment = 2.2f, kFollowing = 1.2f, kLevelling = 1.5f;  // times a difference of velocities
constexpr float kSeparation = 1.6f, kCohesion = 1.1f, kAvoidance = 6, kHoming = 2.5f;  // times their speed

/// The state of all fish.
struct Shoal {
  std::vector<Vec3> at, velocity;  // metres, metres a second over the ground
};

class Swimmer {
 public:
  Swimmer(const SwimTask& task, const Clearance& clear)
      : task_(task), p_(task.params), clear_(clear), period_(task.film > 0 ? task.film : kStillPeriod) {
    phase_ = task.seed.child("round").range(0, 2 * kPi);
    // No faster than they swim, so that the shorter the film the nearer to home they stay.
    constexpr double kGuidePace = 0.6;  // of their speed
    round_ = static_cast<float>(std::min(p_.roam, kGuidePace * p_.speed * period_ / (2 * kPi)));
    current_ = static_cast<float>(p_.speed) * p_.current;
    body_ = static_cast<float>(kBodyShare * task.length + p_.clearance);
  }

  double period() const { return period_; }

  /// Where the middle of the school is drawn to.
  Vec3 guide(double time) const {
    constexpr double kUp = 0.15, kAside = 0.7;  // of how far it goes along x
    double turn = 2 * kPi * time / period_ + phase_;
    return task_.home + round_ * Vec3(std::cos(turn), kUp * std::sin(2 * turn), kAside * std::sin(turn));
  }
  Vec3 guide_velocity(double time) const { return (guide(time + 0.01) - guide(time - 0.01)) / 0.02f; }

  Shoal begin(double time) {
    Shoal shoal;
    Vec3 ahead = guide_velocity(time) - current_;
    for (int i = 0; i < task_.count; ++i) {
      Seed own = task_.seed.child("fish", static_cast<std::uint64_t>(i));
      double r = std::cbrt(own.child("far").unit()), up = own.child("up").range(-1, 1),
             turn = own.child("turn").range(0, 2 * kPi), flat = std::sqrt(1 - up * up);
      Vec3 off(p_.home * r * flat * std::cos(turn), p_.layer * r * up, p_.home * r * flat * std::sin(turn));
      shoal.at.push_back(guide(time) + off);
      Vec3 direction = glm::length(ahead) > 1e-4f ? glm::normalize(ahead) : Vec3(1, 0, 0);
      shoal.velocity.push_back(direction * static_cast<float>(p_.speed) + current_);
    }
    constexpr int kSpreading = 30;  // rounds until nearly all have room
    for (int k = 0; k < kSpreading; ++k) keep_apart(shoal.at, 0.5f), keep_clear(shoal.at);
    return shoal;
  }

  /// Moves all of them on by one step, as Reynolds (1987) has it, in water that moves.
  void step(Shoal& shoal, double time, double dt) {
    sort_by_x(shoal.at);
    pull_.assign(shoal.at.size(), Vec3(0));
    for (std::size_t k = 0; k < order_.size(); ++k) heed_others(shoal, k);
    for (std::size_t i = 0; i < shoal.at.size(); ++i) move(shoal, i, time, static_cast<float>(dt));
    keep_apart(shoal.at, 0.5f);
    keep_clear(shoal.at);
  }

  /// Moves those that are nearer to each other than half their spacing apart.
  void keep_apart(std::vector<Vec3>& at, float share) {
    sort_by_x(at);
    auto least = static_cast<float>(std::max(0.5 * p_.spacing, 0.5 * task_.length));
    push_.assign(at.size(), Vec3(0));
    for (std::size_t k = 0; k < order_.size(); ++k)
      for (std::size_t l = k + 1; l < order_.size(); ++l) {
        std::size_t i = order_[k], j = order_[l];
        Vec3 off = at[i] - at[j];
        if (-off.x > least) break;
        float d2 = glm::dot(off, off);
        if (d2 >= least * least) continue;
        float d = std::sqrt(d2);
        Vec3 out = d > 1e-5f ? off / d : Vec3(0, i < j ? 1 : -1, 0);
        push_[i] += share * (least - d) * out;
        push_[j] -= share * (least - d) * out;
      }
    for (std::size_t i = 0; i < at.size(); ++i) at[i] += push_[i];
  }

  /// Moves those out that are nearer to what stands than their body.
  void keep_clear(std::vector<Vec3>& at) const {
    constexpr int kTries = 4;
    constexpr float kFlat = 0.05f;       // slope of the clearance below which it tells no way out
    constexpr float kLeastSlope = 0.4f;  // as if it were at least so steep, so that steps stay short
    constexpr float kFarther = 1.05f;    // than what is missing
    for (Vec3& place : at)
      for (int k = 0; k < kTries; ++k) {
        float room = clear_(place);
        if (room >= body_) break;
        Vec3 out = clear_.away(place);
        float slope = glm::length(out);
        place += slope > kFlat ? (body_ - room) * kFarther / std::max(slope, kLeastSlope) * out / slope
                               : Vec3(0, body_ - room, 0);
      }
  }

 private:
  void sort_by_x(const std::vector<Vec3>& at) {
    if (order_.size() != at.size()) {
      order_.resize(at.size());
      std::iota(order_.begin(), order_.end(), 0);
    }
    std::ranges::sort(
        order_, [&](std::size_t i, std::size_t j) { return at[i].x != at[j].x ? at[i].x < at[j].x : i < j; });
  }

  /// Separation, alignment and cohesion of the fish that is k-th from the left.
  void heed_others(const Shoal& shoal, std::size_t k) {
    std::size_t i = order_[k];
    auto sight = static_cast<float>(p_.sight), room = static_cast<float>(p_.spacing);
    Vec3 apart(0), velocity(0), middle(0);
    float heeded = 0;
    auto heed = [&](std::size_t j) {
      Vec3 off = shoal.at[j] - shoal.at[i];
      float d2 = glm::dot(off, off);
      if (d2 >= sight * sight || d2 < 1e-10f) return;
      float d = std::sqrt(d2), weight = 1 - d / sight;
      if (d < room) apart -= off / d * (room / d - 1);
      velocity += weight * shoal.velocity[j];
      middle += weight * shoal.at[j];
      heeded += weight;
    };
    for (std::size_t l = k; l-- > 0 && shoal.at[i].x - shoal.at[order_[l]].x < sight;) heed(order_[l]);
    for (std::size_t l = k + 1; l < order_.size() && shoal.at[order_[l]].x - shoal.at[i].x < sight; ++l)
      heed(order_[l]);
    auto speed = static_cast<float>(p_.speed);
    Vec3 pull = static_cast<float>(p_.separation) * kSeparation * speed * apart;
    if (heeded > 0) {
      pull += static_cast<float>(p_.alignment) * kAlignment * (velocity / heeded - shoal.velocity[i]);
      pull += static_cast<float>(p_.cohesion) * kCohesion * speed * (middle / heeded - shoal.at[i]) / sight;
    }
    pull_[i] = pull;
  }

  /// What draws it home, away from what stands, and aside.
  Vec3 drawn(const Shoal& shoal, std::size_t i, double time) const {
    constexpr float kAtHome = 0.6f;  // of its home's radius: within it nothing draws it back
    constexpr float kMarginTime = 0.35f, kMargin = 0.1f;  // it evades what is within seconds and metres
    constexpr float kLookAhead = 0.4f;                    // seconds
    auto speed = static_cast<float>(p_.speed);
    Vec3 at = shoal.at[i], off = at - guide(time);
    Vec3 share = off / Vec3(p_.home, p_.layer, p_.home);
    float out = glm::length(share);
    Vec3 pull = kFollowing * (guide_velocity(time) - shoal.velocity[i]);
    if (out > kAtHome) pull -= speed * kHoming * (out - kAtHome) * share / out;
    // Ahead of it and beside it.
    // What turns slowly looks farther ahead: in 1 / turn seconds it comes round by a radian.
    constexpr float kMostMarginTime = 3;
    float margin_time = std::clamp(1 / static_cast<float>(p_.turn), kMarginTime, kMostMarginTime);
    float margin = body_ + margin_time * speed + kMargin;
    for (Vec3 look : {at, at + std::max(kLookAhead, margin_time) * shoal.velocity[i]}) {
      float room = clear_(look);
      if (room >= margin) continue;
      float near = 1 - std::max(0.0f, room - body_) / (margin - body_);
      Vec3 away = clear_.away(look);
      float slope = glm::length(away);
      if (slope > 1e-3f)
        pull += static_cast<float>(p_.avoidance) * kAvoidance * speed * near * near * away / slope;
    }
    return pull + wander(i, time);
  }

  /// A slow drift of each fish's own; it closes with the film.
  Vec3 wander(std::size_t i, double time) const {
    constexpr double kRarest = 0.1, kOftenest = 0.35;  // hertz
    constexpr float kUpDown = 0.5f;                    // of the drift to the sides
    Seed own = task_.seed.child("fish", i).child("wander");
    Vec3 drift(0);
    for (int k = 0; k < 3; ++k) {
      Seed wave = own.child(static_cast<std::uint64_t>(k));
      double rounds = std::max(1.0, std::round(period_ * wave.child("often").range(kRarest, kOftenest)));
      drift[k] =
          static_cast<float>(std::sin(2 * kPi * (rounds * time / period_ + wave.child("phase").unit())));
    }
    return static_cast<float>(p_.wander * p_.speed) * drift * Vec3(1, kUpDown, 1);
  }

  void move(Shoal& shoal, std::size_t i, double time, float dt) {
    constexpr float kSlowest = 0.55f, kFastest = 1.5f;  // of their speed
    constexpr float kSteep = 0.6f, kFreely = 0.02f;     // rise over run; and metres a second, however slow
    auto speed = static_cast<float>(p_.speed);
    Vec3 pull = pull_[i] + drawn(shoal, i, time);
    float strength = glm::length(pull), most = static_cast<float>(p_.turn) * speed;
    if (strength > most) pull *= most / strength;
    Vec3 through = shoal.velocity[i] + pull * dt - current_;
    through.y *= 1 - kLevelling * dt;  // fish swim level
    float fast = glm::length(through);
    if (fast > 1e-5f) through *= std::clamp(fast, kSlowest * speed, kFastest * speed) / fast;
    // No steeper than they like to.
    float flat = std::hypot(through.x, through.z), steep = kSteep * flat;
    through.y = std::clamp(through.y, -steep - kFreely, steep + kFreely);
    shoal.velocity[i] = through + current_;
    shoal.at[i] += shoal.velocity[i] * dt;
  }

  const SwimTask& task_;
  const SwimParams& p_;
  const Clearance& clear_;
  double period_, phase_ = 0;
  float round_ = 0, body_ = 0;
  Vec3 current_{0};
  std::vector<std::size_t> order_;
  std::vector<Vec3> pull_, push_;
};

/// Whom each of `from` should follow among `to`: pairs near each other, each once, of the same look where
/// there are several, which go round.
std::vector<int> match(const std::vector<Vec3>& from, const std::vector<Vec3>& to, std::size_t looks) {
  std::size_t n = from.size();
  struct Pair {
    float far;
    std::uint32_t i, j;
  };
  std::vector<Pair> pairs;
  pairs.reserve(n * n);
  for (std::uint32_t i = 0; i < n; ++i)
    for (auto j = static_cast<std::uint32_t>(i % looks); j < n; j += static_cast<std::uint32_t>(looks)) {
      Vec3 off = from[i] - to[j];
      pairs.push_back({glm::dot(off, off), i, j});
    }
  std::ranges::sort(pairs, [](const Pair& a, const Pair& b) {
    return std::tie(a.far, a.i, a.j) < std::tie(b.far, b.i, b.j);
  });
  std::vector<int> next(n, -1);
  std::vector<char> taken(n, 0);
  for (const Pair& pair : pairs)
    if (next[pair.i] < 0 && !taken[pair.j]) next[pair.i] = static_cast<int>(pair.j), taken[pair.j] = 1;
  // The last ones got what was left: exchanges shorten their paths.
  constexpr int kExchanges = 12;  // rounds at most
  auto far = [&](std::size_t i, int j) {
    Vec3 off = from[i] - to[static_cast<std::size_t>(j)];
    return glm::dot(off, off);
  };
  for (int round = 0; round < kExchanges; ++round) {
    bool better = false;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + looks; j < n; j += looks)
        if (far(i, next[j]) + far(j, next[i]) < far(i, next[i]) + far(j, next[j]) - 1e-9f)
          std::swap(next[i], next[j]), better = true;
    if (!better) break;
  }
  return next;
}

double ease(double t) { return t * t * t * (t * (6 * t - 15) + 10); }

/// Directions, speeds and strokes of the tail from the places.
void finish(Trajectory& trajectory, const SwimTask& task, double beat, double size_variation) {
  int n = trajectory.count;
  auto place = [&](int s, int i) {
    if (trajectory.repeats && s > trajectory.steps)
      return trajectory
          .position[trajectory.at(s - trajectory.steps, trajectory.next[static_cast<std::size_t>(i)])];
    return trajectory.position[trajectory.at(std::clamp(s, 0, trajectory.steps), i)];
  };
  std::vector<int> before(static_cast<std::size_t>(n));  // the inverse of `next`
  for (int i = 0; i < n; ++i)
    before[static_cast<std::size_t>(trajectory.next[static_cast<std::size_t>(i)])] = i;
  auto place_back = [&](int s, int i) {
    if (trajectory.repeats && s < 0)
      return trajectory.position[trajectory.at(s + trajectory.steps, before[static_cast<std::size_t>(i)])];
    return place(s, i);
  };
  trajectory.velocity.resize(trajectory.position.size());
  trajectory.heading.resize(trajectory.position.size());
  trajectory.stroke.resize(trajectory.position.size());
  for (int i = 0; i < n; ++i) {
    Seed own = task.seed.child("fish", static_cast<std::uint64_t>(i));
    trajectory.size.push_back(static_cast<float>(1 + size_variation * own.child("size").range(-1, 1)));
    double stroke = own.child("stroke").unit();
    for (int s = 0; s <= trajectory.steps; ++s) {
      auto step = static_cast<float>(trajectory.step);
      Vec3 velocity = (place(s + 1, i) - place_back(s - 1, i)) / (2 * step);
      if (!trajectory.repeats && (s == 0 || s == trajectory.steps)) velocity *= 2;
      // Where it looks is smoother than how it goes.
      Vec3 wide = (place(s + 3, i) - place_back(s - 3, i)) / (6 * step);
      if (!trajectory.repeats) wide = velocity;
      Vec3 through = wide - static_cast<float>(task.params.speed) * task.params.current;
      float fast = glm::length(through);
      Vec3 ahead = fast > 1e-4f ? through / fast : Vec3(1, 0, 0);
      trajectory.velocity[trajectory.at(s, i)] = velocity;
      trajectory.heading[trajectory.at(s, i)] = ahead;
      trajectory.stroke[trajectory.at(s, i)] = static_cast<float>(stroke);
      stroke += trajectory.step * (task.idle + fast / (beat * task.length));
    }
  }
  if (!trajectory.repeats) return;
  // Each has beaten its tail by so much as the one whose place it takes.
  for (int i = 0; i < n; ++i) {
    float gap = trajectory.stroke[trajectory.at(0, trajectory.next[static_cast<std::size_t>(i)])] -
                trajectory.stroke[trajectory.at(trajectory.steps, i)];
    gap -= std::round(gap);
    float beaten =
        trajectory.stroke[trajectory.at(trajectory.steps, i)] - trajectory.stroke[trajectory.at(0, i)];
    // What has no idle beats would else stand still in a short film, or beat backward.
    if (task.idle <= 0 && beaten + gap < 0.5f) gap += std::ceil(0.5f - beaten - gap);
    for (int s = 0; s <= trajectory.steps; ++s)
      trajectory.stroke[trajectory.at(s, i)] +=
          gap * static_cast<float>(s) / static_cast<float>(trajectory.steps);
  }
}

}  // namespace

Trajectory swim(const SwimTask& task, double beat, double size_variation, const Clearance& clear) {
  Swimmer swimmer(task, clear);
  Trajectory trajectory;
  trajectory.count = task.count;
  trajectory.repeats = task.film > 0;
  double length = trajectory.repeats ? task.film : kStep;
  // Directions are taken over three steps to each side, also where the film begins again.
  trajectory.steps = std::max(3, static_cast<int>(std::ceil(length / kStep - 1e-9)));
  trajectory.step = length / trajectory.steps;
  double blended = std::min(kMostBlend, kBlendShare * length);
  int blend = trajectory.repeats ? std::max(1, static_cast<int>(blended / trajectory.step)) : 0;
  int settling = static_cast<int>(kSettling / trajectory.step);

  int first = -settling - blend;
  Shoal shoal = swimmer.begin(first * trajectory.step);
  std::vector<std::vector<Vec3>> lead;  // how they came to where they are at first
  for (int s = first; s <= trajectory.steps; ++s) {
    if (s >= -blend && s <= 0) lead.push_back(shoal.at);
    if (s >= 0) trajectory.position.insert(trajectory.position.end(), shoal.at.begin(), shoal.at.end());
    if (s < trajectory.steps) swimmer.step(shoal, s * trajectory.step, trajectory.step);
  }
  trajectory.next.resize(static_cast<std::size_t>(trajectory.count));
  std::iota(trajectory.next.begin(), trajectory.next.end(), 0);
  if (trajectory.repeats && trajectory.count > 0) {
    std::vector<Vec3> begin(trajectory.position.begin(), trajectory.position.begin() + trajectory.count);
    std::vector<Vec3> end(trajectory.position.end() - trajectory.count, trajectory.position.end());
    trajectory.next = match(end, begin, task.looks);
    std::vector<Vec3> at(begin.size());
    for (int b = 0; b <= blend; ++b) {
      int s = trajectory.steps - blend + b;
      auto share = static_cast<float>(ease(static_cast<double>(b) / blend));
      for (int i = 0; i < trajectory.count; ++i) {
        auto k = static_cast<std::size_t>(i);
        Vec3 goal = lead[static_cast<std::size_t>(b)][static_cast<std::size_t>(trajectory.next[k])];
        at[k] = trajectory.position[trajectory.at(s, i)] * (1 - share) + goal * share;
      }
      if (b > 0 && b < blend) swimmer.keep_apart(at, 0.5f), swimmer.keep_clear(at);
      std::ranges::copy(at, trajectory.position.begin() + static_cast<std::ptrdiff_t>(trajectory.at(s, 0)));
    }
  }
  finish(trajectory, task, beat, size_variation);
  return trajectory;
}

FishPose fish_at(const Trajectory& trajectory, int fish, double time) {
  double where = std::clamp(time / trajectory.step, 0.0, static_cast<double>(trajectory.steps));
  int s = std::min(static_cast<int>(where), trajectory.steps - 1);
  auto t = static_cast<float>(where - s), step = static_cast<float>(trajectory.step);
  std::size_t a = trajectory.at(s, fish), b = trajectory.at(s + 1, fish);
  float t2 = t * t, t3 = t2 * t;
  FishPose pose;
  pose.position = (2 * t3 - 3 * t2 + 1) * trajectory.position[a] +
                  (t3 - 2 * t2 + t) * step * trajectory.velocity[a] +
                  (3 * t2 - 2 * t3) * trajectory.position[b] + (t3 - t2) * step * trajectory.velocity[b];
  Vec3 from = trajectory.heading[a], to = trajectory.heading[b], ahead = from + (to - from) * t;
  pose.heading = glm::length(ahead) > 1e-4f ? glm::normalize(ahead) : from;
  pose.stroke = trajectory.stroke[a] + (trajectory.stroke[b] - trajectory.stroke[a]) * t;
  pose.turn = glm::cross(from, to).y / step;
  pose.size = trajectory.size[static_cast<std::size_t>(fish)];
  if (trajectory.repeats) {
    // Toward the end it becomes as large as the one whose place it takes.
    constexpr double kChangesFrom = 0.3;  // of the film
    double film = trajectory.steps * trajectory.step, share = smooth_step(kChangesFrom * film, film, time);
    float other = trajectory.size[static_cast<std::size_t>(trajectory.next[static_cast<std::size_t>(fish)])];
    pose.size += (other - pose.size) * static_cast<float>(share);
  }
  return pose;
}

}  // namespace frond
