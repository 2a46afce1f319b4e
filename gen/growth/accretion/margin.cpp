#include "accretion/margin.h"

#include <algorithm>
#include <cmath>

#include "accretion/growing_sheets.h"
#include "core/noise.h"

namespace frond {

std::uint32_t GrowingSheets::add(Vec3 at, std::array<std::uint32_t, 2> parents, float row, float distance,
                                 float u, std::uint32_t sheet) {
  auto v = static_cast<std::uint32_t>(sheet_.position.size());
  sheet_.position.push_back(at);
  sheet_.parents.push_back(parents[0] == kRimNobody ? std::array{v, v} : parents);
  sheet_.row.push_back(row);
  sheet_.distance.push_back(distance);
  u_.push_back(u);
  owner_.push_back(sheet);
  seat_.push_back(kRimNobody);
  grid_.add(at, v);
  return v;
}

void GrowingSheets::start(const MarginStart& start, std::uint32_t sheet) {
  GrowingRim rim{.closed = start.closed, .sheet = sheet};
  rim.tube = start.closed && !start.filled;
  rim.first = static_cast<int>(start.begins * sheet_.rows);
  rim.last = std::min(sheet_.rows, rim.first + static_cast<int>(start.reach * sheet_.rows));
  auto row = static_cast<float>(rim.first);
  for (std::size_t i = 0; i < start.rim.size(); ++i) {
    float u = static_cast<float>(i) / static_cast<float>(start.rim.size());
    rim.vertex.push_back(add(start.rim[i], {kRimNobody, kRimNobody}, row, start.from_middle, u, sheet));
    rim.heading.push_back(start.heading[i]);
    rim.pace.push_back(1);
  }
  if (start.closed && start.filled) {
    Vec3 middle(0);
    for (Vec3 p : start.rim) middle += p / static_cast<float>(start.rim.size());
    std::uint32_t center = add(middle, {kRimNobody, kRimNobody}, row, 0, 0, sheet);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      sheet_.triangle.push_back({center, rim.vertex[i], rim.vertex[rim.next(i)]});
      auto [low, high] = box_of(sheet_.triangle.back(), [&](std::uint32_t v) { return sheet_.position[v]; });
      skin_.add(low, high, static_cast<std::uint32_t>(sheet_.triangle.size() - 1));
    }
  }
  rims_.push_back(std::move(rim));
}

/// How fast each place of the rim may go, even along it.
void GrowingSheets::set_paces(GrowingRim& rim) {
  auto lobes = static_cast<float>(law_.lobes), frequency = static_cast<float>(1 / law_.lobe_size);
  constexpr float kSlowest = 0.3f;                 // pace that all keep; less of it, the more there are lobes
  constexpr float kHalts = 0.5f, kUnhindered = 3;  // edges of free room
  std::vector<float>& pace = rim.pace;
  shift_.assign(rim.size(), Vec3(0));
  for (std::size_t i = 0; i < rim.size(); ++i) {
    if (pace[i] == 0) continue;
    Vec3 at = sheet_.position[rim.vertex[i]];
    float uneven = 1 + lobes * static_cast<float>(fractal_noise(at * frequency + lot_, 2));
    float speed = std::clamp(uneven, 0.0f, 1.0f);
    speed = std::max(speed, kSlowest * (1 - lobes));
    if (world_.room) speed *= smooth_step(kHalts * edge_, kUnhindered * edge_, world_.room(at, 6 * edge_));
    shift_[i].x = speed;
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    if (pace[i] == 0) continue;
    float own = shift_[i].x;
    float mean = 0.5f * own + 0.25f * (shift_[rim.prior(i)].x + shift_[rim.next(i)].x);
    // What the neighbours have lost slows it, but they do not push it on.
    shift_[i].y = std::min(own, mean);
  }
  for (std::size_t i = 0; i < rim.size(); ++i)
    if (pace[i] != 0) pace[i] = shift_[i].y < kRimStill ? 0 : shift_[i].y;
}

/// Where each place of the rim would go if it were alone.
void GrowingSheets::aim(GrowingRim& rim) {
  std::size_t count = rim.size();
  from_.resize(count), to_.resize(count), aim_.resize(count), tangent_.resize(count), rest_.resize(count);
  for (std::size_t i = 0; i < count; ++i) from_[i] = sheet_.position[rim.vertex[i]];
  auto turn = static_cast<float>(law_.light / law_.reach) * step_;
  auto rise = static_cast<float>(std::sin(law_.pitch)), out = static_cast<float>(std::cos(law_.pitch));
  auto frequency = static_cast<float>(1 / law_.ruffle);
  constexpr float kStir = 0.12f;  // radians a row, at most, by which ruffles begin
  float stir = law_.excess > 1 ? kStir : 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 along = from_[rim.next(i)] - from_[rim.prior(i)];
    float length = glm::length(along);
    tangent_[i] = along = length > 0 ? along / length : Vec3(0);
    Vec3 h = rim.heading[i] * 2.0f + rim.heading[rim.next(i)] + rim.heading[rim.prior(i)];
    h -= along * glm::dot(h, along);
    float size = glm::length(h);
    h = size > 0.2f ? h / size : rim.heading[i];
    if (world_.cling) {
      Vec3 at = from_[i], normal(0, 1, 0);
      world_.cling(at, normal);
      h -= normal * glm::dot(h, normal);
    } else {
      Vec3 level(h.x, 0, h.z);
      float flat = glm::length(level);
      Vec3 wish = (flat > 0.05f ? level / flat * out : Vec3(0)) + Vec3(0, rise, 0);
      h += turn * (wish - along * glm::dot(wish, along));
      if (stir > 0) h += stir * static_cast<float>(noise(from_[i] * frequency + lot_)) * glm::cross(along, h);
    }
    size = glm::length(h);
    aim_[i] = size > 1e-4f ? h / size : rim.heading[i];
    to_[i] = from_[i] + aim_[i] * (step_ * rim.pace[i]);
  }
  auto more = 1 + static_cast<float>(std::log(law_.excess) / law_.reach) * step_;
  for (std::size_t i = 0; i < count; ++i) rest_[i] = more * glm::distance(to_[i], to_[rim.next(i)]);
}

/// Finds for each place of the rim what it must keep away from, and how far.
void GrowingSheets::look_round(const GrowingRim& rim) {
  constexpr float kBeside = 2.2f;  // edges along the sheet: what is nearer is no rival
  std::size_t count = rim.size();
  rivals_.resize(std::max(rivals_.size(), count));
  float reach = clearance_ + 2 * step_, whole = 0;
  // Threads keep their order, so that u says where on this rim an older vertex' thread has come to.
  arc_.clear(), thread_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    arc_.push_back(whole);
    thread_.push_back(u_[rim.vertex[i]]);
    whole += glm::distance(from_[i], from_[rim.next(i)]);
  }
  auto along = [&](std::size_t i, std::uint32_t who) {
    auto j = static_cast<std::size_t>(std::ranges::lower_bound(thread_, u_[who]) - thread_.begin());
    float from = j == 0 ? 0 : arc_[j - 1], to = j < count ? arc_[j] : whole;
    float distance = from > arc_[i] ? from - arc_[i] : to < arc_[i] ? arc_[i] - to : 0;
    return rim.closed ? std::min(distance, whole - distance) : distance;
  };
  for (std::size_t i = 0; i < count; ++i) {
    rivals_[i].clear();
    if (rim.pace[i] == 0) continue;
    std::uint32_t own = rim.vertex[i];
    grid_.each(from_[i], [&](std::uint32_t who) {
      if (who == own || glm::distance(sheet_.position[who], from_[i]) > reach) return;
      float need = clearance_;
      if (owner_[who] == rim.sheet) {
        float distance = std::max(along(i, who), std::abs(sheet_.distance[own] - sheet_.distance[who]));
        distance = std::min(distance, sheet_.distance[own] + sheet_.distance[who]);
        if (distance < kBeside * edge_) return;
        need = std::min(need, kRimBow * distance);
      }
      rivals_[i].push_back({who, need});
    });
  }
}

void GrowingSheets::keep_away(std::size_t i) {
  constexpr float kGiveWay = 0.4f;  // of what is lacking, in a round
  for (const RimRival& rival : rivals_[i]) {
    std::uint32_t seat = seat_[rival.who];
    Vec3 off = to_[i] - (seat == kRimNobody ? sheet_.position[rival.who] : to_[seat]);
    float d2 = glm::dot(off, off);
    if (d2 >= rival.distance * rival.distance || d2 < 1e-12f) continue;
    float d = std::sqrt(d2);
    shift_[i] += off * (kGiveWay * (rival.distance - d) / d);
  }
}

/// Whether the rim turns back on itself within a few vertices.
bool GrowingSheets::is_kinked(const GrowingRim& rim, std::size_t i) const {
  constexpr float kSharp = 0.6f, kFolded = 0.5f;  // chord over arc: from neighbour to neighbour; farther on
  std::size_t a = i, b = i;
  float arc = 0;
  int reach = std::min(3, static_cast<int>(rim.size()) / 6);  // a small ring turns back by itself
  for (int k = 0; k < reach; ++k) {
    arc += glm::distance(to_[b], to_[rim.next(b)]) + glm::distance(to_[a], to_[rim.prior(a)]);
    b = rim.next(b), a = rim.prior(a);
    if (glm::distance(to_[a], to_[b]) < (k == 0 ? kSharp : kFolded) * arc) return true;
  }
  return false;
}

void GrowingSheets::relax(const GrowingRim& rim) {
  // Shares of the offset to a goal by which a vertex moves in a round; a stiff sheet adds the second ones.
  constexpr float kHome = 0.02f, kStiffHome = 0.10f;          // to where it would go alone
  constexpr float kStraight = 0.05f, kStiffStraight = 0.45f;  // between its neighbours, across the sheet
  constexpr float kSpread = 0.35f;                            // to where an edge has its length
  constexpr float kUnkink = 0.6f;                             // between its neighbours, where it is kinked
  constexpr float kLeastAhead = 0.3f;                         // of a step: the way that it makes at least
  std::size_t count = rim.size();
  auto fold = kHome + kStiffHome * static_cast<float>(law_.stiffness);
  // What does not outgrow itself keeps the bends that it has: a tube is one.
  float bend = law_.excess > 1 ? kStraight + kStiffStraight * static_cast<float>(law_.stiffness) : 0;
  for (int round = 0; round < kRimRounds; ++round) {
    shift_.assign(count, Vec3(0));
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t j = rim.next(i);
      if (j == i) continue;
      Vec3 apart = to_[j] - to_[i];
      float length = glm::length(apart);
      // Only a rim that outgrows what is there pushes.
      if (length < 1e-7f || (law_.excess <= 1 && length < rest_[i])) continue;
      Vec3 push = apart * (kSpread * (rest_[i] - length) / length);
      shift_[i] -= push;
      shift_[j] += push;
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (rim.pace[i] == 0) continue;
      std::size_t a = rim.prior(i), b = rim.next(i);
      // In its plane less, or a ring would shrink.
      Vec3 across = glm::cross(tangent_[i], aim_[i]);
      if (a != i && b != i)
        shift_[i] += across * (bend * glm::dot(across, (to_[a] + to_[b]) * 0.5f - to_[i]));
      if (is_kinked(rim, i)) shift_[i] += kUnkink * ((to_[a] + to_[b]) * 0.5f - to_[i]);
      shift_[i] += fold * (from_[i] + aim_[i] * (step_ * rim.pace[i]) - to_[i]);
      keep_away(i);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (rim.pace[i] == 0) continue;
      Vec3 offset = to_[i] + shift_[i] - from_[i];
      // No sharper turn than a row can make.
      float ahead = glm::dot(offset, aim_[i]);
      Vec3 aside = offset - aim_[i] * ahead;
      float wide = glm::length(aside), most = 0.5f * std::max(ahead, kLeastAhead * step_);
      if (wide > most) aside *= most / wide;
      offset = aim_[i] * std::max(ahead, kLeastAhead * step_) + aside;
      to_[i] = from_[i] + offset * (step_ * rim.pace[i] / glm::length(offset));
      if (world_.cling) {
        Vec3 normal(0, 1, 0);
        if (round + 1 == kRimRounds) world_.cling(to_[i], normal);
      }
    }
  }
}

void GrowingSheets::advance(GrowingRim& rim, int row) {
  // The first row is whole, or sheets would hang by single vertices.
  if (row > rim.first) set_paces(rim);
  // A tube that is hindered stops as a whole, or it would go on as a flap.
  constexpr int kOneIn = 8;  // of its vertices has stopped
  if (rim.tube && std::ranges::count(rim.pace, 0.0f) * kOneIn > std::ssize(rim.pace))
    std::ranges::fill(rim.pace, 0.0f);
  if (std::ranges::all_of(rim.pace, [](float p) { return p == 0; })) return;
  aim(rim);
  for (std::size_t i = 0; i < rim.size(); ++i) seat_[rim.vertex[i]] = static_cast<std::uint32_t>(i);
  look_round(rim);
  relax(rim);
  for (;;) {
    if (row > rim.first) stop_what_collides(rim);
    RimRow planned = plan(rim);
    if (stop_what_crosses(rim, planned)) continue;
    lay(rim, std::move(planned), row);
    return;
  }
}

Sheet GrowingSheets::grow() && {
  for (int row = 0; row < sheet_.rows; ++row)
    for (GrowingRim& rim : rims_)
      if (row >= rim.first && row < rim.last) advance(rim, row);
  sheet_.normal.assign(sheet_.position.size(), Vec3(0));
  for (auto [a, b, c] : sheet_.triangle) {
    const Vec3 &p = sheet_.position[a], &q = sheet_.position[b], &r = sheet_.position[c];
    Vec3 n = glm::cross(q - p, r - p);
    sheet_.normal[a] += n, sheet_.normal[b] += n, sheet_.normal[c] += n;
  }
  sheet_.end = sheet_.row;
  for (std::size_t v = sheet_.position.size(); v-- > 0;)
    for (std::uint32_t p : sheet_.parents[v]) sheet_.end[p] = std::max(sheet_.end[p], sheet_.end[v]);
  for (Vec3& n : sheet_.normal) n = glm::dot(n, n) > 0 ? glm::normalize(n) : Vec3(0, 1, 0);
  return std::move(sheet_);
}

Sheet grow_margins(const Margin& law, const std::vector<MarginStart>& starts, const MarginWorld& world,
                   Seed seed) {
  GrowingSheets growing(law, world, seed);
  for (std::size_t i = 0; i < starts.size(); ++i) growing.start(starts[i], static_cast<std::uint32_t>(i));
  return std::move(growing).grow();
}

}  // namespace frond
