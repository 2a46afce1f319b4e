#include <algorithm>
#include <cassert>

#include "accretion/growing_sheets.h"

namespace frond {

/// What has come too near to something stays where it is, for good.
void GrowingSheets::stop_what_collides(GrowingRim& rim) {
  constexpr int kRounds = 6;
  constexpr float kTouches = 0.3f;  // edges of free room
  constexpr float kTooNear = 0.8f;  // of the distance to keep
  constexpr float kTurned = 0.3f;   // cosine: from how the sheet lay to how it would
  for (int round = 0; round < kRounds; ++round) {
    bool any = false;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      if (rim.pace[i] == 0) continue;
      bool meets = world_.room && world_.room(to_[i], 2 * edge_) < kTouches * edge_;
      for (const RimRival& rival : rivals_[i]) {
        std::uint32_t seat = seat_[rival.who];
        Vec3 other = seat == kRimNobody ? sheet_.position[rival.who] : to_[seat];
        float now = glm::distance(to_[i], other);
        if (now < kTooNear * rival.distance && now < glm::distance(from_[i], sheet_.position[rival.who]))
          meets = true;
      }
      if (is_kinked(rim, i)) meets = true;
      // Nor does a sheet turn over.
      Vec3 side = glm::cross(to_[rim.next(i)] - to_[rim.prior(i)], to_[i] - from_[i]);
      Vec3 was = glm::cross(tangent_[i], rim.heading[i]);
      if (glm::dot(side, was) < kTurned * glm::length(side) * glm::length(was)) meets = true;
      if (!meets) continue;
      rim.pace[i] = 0;
      to_[i] = from_[i];
      any = true;
    }
    if (!any) return;
  }
}

/// The row between the rim and where it has come to, which is the rim from then on.
RimRow GrowingSheets::plan(const GrowingRim& rim) const {
  constexpr float kMerge = 0.5f, kSplit = 1.45f;  // edges between two vertices
  constexpr std::size_t kLeastLeft = 8;           // vertices of a rim that are not merged
  std::size_t count = rim.size(), gaps = rim.closed ? count : count - 1;
  RimRow row;
  GrowingRim& after = row.after = {
      .closed = rim.closed, .tube = rim.tube, .sheet = rim.sheet, .first = rim.first, .last = rim.last};
  auto put = [&](std::uint32_t v, Vec3 heading, float pace) {
    after.vertex.push_back(v), after.heading.push_back(heading), after.pace.push_back(pace);
  };
  auto bear = [&](Vec3 at, std::array<std::uint32_t, 2> parents, float distance, float u) {
    row.vertex.push_back({at, parents, distance, u});
    return static_cast<std::uint32_t>(sheet_.position.size() + row.vertex.size() - 1);
  };
  auto raised = [&](std::size_t i) {
    if (rim.pace[i] == 0) return rim.vertex[i];
    std::uint32_t v = rim.vertex[i];
    return bear(to_[i], {v, v}, sheet_.distance[v] + glm::distance(from_[i], to_[i]), u_[v]);
  };
  auto heading = [&](std::size_t i) {
    if (rim.pace[i] == 0) return rim.heading[i];
    // What clings to a point of its host is drawn back to it.
    return direction_or(to_[i] - from_[i], aim_[i], 1e-6f * step_);
  };
  auto heading_between = [&](std::size_t i, std::size_t j) {
    return direction_or(heading(i) + heading(j) + aim_[i] * 0.01f, aim_[i]);
  };
  std::size_t left = count;  // that may still be lost
  std::vector<std::uint32_t> above(count, kRimNobody);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t j = rim.next(i);
    std::uint32_t p = rim.vertex[i], q = rim.vertex[j];
    Vec3 between = (to_[i] + to_[j]) * 0.5f;
    float distance = (sheet_.distance[p] + sheet_.distance[q]) / 2 + step_ * rim.pace[i];
    if (above[i] == kRimNobody) {
      bool near = j > i && rim.pace[i] > 0 && rim.pace[j] > 0 && left > kLeastLeft && i > 0 &&
                  j + 1 < count && glm::distance(to_[i], to_[j]) < kMerge * edge_;
      if (near) {
        above[i] = above[j] = bear(between, {p, q}, distance, (u_[p] + u_[q]) / 2);
        put(above[i], heading_between(i, j), rim.pace[i]);
        --left;
      } else {
        above[i] = raised(i);
        put(above[i], heading(i), rim.pace[i]);
      }
    }
    if (i >= gaps) continue;
    bool merges = j > i && above[j] != kRimNobody;
    bool moves = rim.pace[i] > 0 || rim.pace[j] > 0;
    if (merges || !moves || glm::distance(to_[i], to_[j]) < kSplit * edge_) continue;
    std::uint32_t m = bear(between, {p, q}, distance, (u_[p] + (j > i ? u_[q] : 1)) / 2);
    put(m, heading_between(i, j), std::max(rim.pace[i], rim.pace[j]));
  }
  fill(rim, row, above);
  return row;
}

/// The triangles of a row; `above` is what each place of the rim has become.
void GrowingSheets::fill(const GrowingRim& rim, RimRow& row, const std::vector<std::uint32_t>& above) const {
  const GrowingRim& after = row.after;
  auto put = [&](std::size_t gap, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    row.triangle.push_back({a, b, c});
    row.gap.push_back(gap);
  };
  // Between each old vertex and the next lies a run of new ones.
  std::size_t place = 0, gaps = rim.closed ? rim.size() : rim.size() - 1;
  std::vector<std::uint32_t> run;
  for (std::size_t i = 0; i < gaps; ++i) {
    std::size_t j = rim.next(i);
    std::uint32_t p = rim.vertex[i], q = rim.vertex[j];
    std::uint32_t begin = above[i], end = above[j];
    if (begin == end) {
      if (begin != p && begin != q) put(i, p, begin, q);
      continue;
    }
    run.assign(1, begin);
    while (place < after.size() && after.vertex[place] != begin) ++place;
    assert(place < after.size() && "what a rim has become lies on the next one");
    for (std::size_t k = place + 1; after.vertex[k % after.size()] != end; ++k) {
      assert(k < place + after.size());
      run.push_back(after.vertex[k % after.size()]);
    }
    run.push_back(end);
    std::size_t half = run.size() / 2;
    for (std::size_t k = 0; k + 1 < run.size(); ++k) {
      std::uint32_t low = k < half ? p : q;
      if (run[k] != low && run[k + 1] != low) put(i, low, run[k], run[k + 1]);
    }
    if (run[half] != p && run[half] != q) put(i, p, run[half], q);
  }
}

/// Stops, for good, what would lay a triangle through another one. Whether there was any.
bool GrowingSheets::stop_what_crosses(GrowingRim& rim, const RimRow& plan) {
  std::size_t known = sheet_.triangle.size(), filled = skin_.size();
  auto place = [&](std::uint32_t v) {
    std::size_t count = sheet_.position.size();
    return v < count ? sheet_.position[v] : plan.vertex[v - count].at;
  };
  bool any = false;
  for (std::size_t t = 0; t < plan.triangle.size(); ++t) {
    std::array<Vec3, 2> box = box_of(plan.triangle[t], place);
    bool crosses = false;
    skin_.each(box[0], box[1], [&](std::uint32_t who) {
      const auto& other = who < known ? sheet_.triangle[who] : plan.triangle[who - known];
      crosses = crosses ||
                (boxes_meet(box, box_of(other, place)) && triangles_cross(plan.triangle[t], other, place));
    });
    skin_.add(box[0], box[1], static_cast<std::uint32_t>(known + t));
    if (!crosses) continue;
    for (std::size_t i : {plan.gap[t], rim.next(plan.gap[t])}) rim.pace[i] = 0, to_[i] = from_[i];
    any = true;
  }
  if (any) skin_.shrink(filled);
  return any;
}

void GrowingSheets::lay(GrowingRim& rim, RimRow&& plan, int row) {
  for (const RimRow::Vertex& v : plan.vertex)
    add(v.at, v.parents, static_cast<float>(row + 1), v.distance, v.u, rim.sheet);
  sheet_.triangle.insert(sheet_.triangle.end(), plan.triangle.begin(), plan.triangle.end());
  for (std::uint32_t v : rim.vertex) seat_[v] = kRimNobody;
  rim = std::move(plan.after);
}

}  // namespace frond
