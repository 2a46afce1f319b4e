#include <algorithm>
#include <cmath>

#include "accretion/growing_sheets.h"

namespace frond {

/// What has come too near to something stays where it is, for good.
void GrowingSheets::stop_what_collides(GrowingRim& rim) {
  for (int round = 0; round < 6; ++round) {
    bool any = false;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      if (rim.pace[i] == 0) continue;
      bool meets = world_.room && world_.room(to_[i], 2 * edge_) < 0.3f * edge_;
      for (const RimRival& rival : rivals_[i]) {
        std::uint32_t seat = seat_[rival.who];
        Vec3 other = seat == kRimNobody ? sheet_.position[rival.who] : to_[seat];
        float now = glm::distance(to_[i], other);
        if (now < 0.8f * rival.distance && now < glm::distance(from_[i], sheet_.position[rival.who]))
          meets = true;
      }
      if (is_kinked(rim, i)) meets = true;
      // Nor does a sheet turn over.
      Vec3 side = glm::cross(to_[rim.next(i)] - to_[rim.prior(i)], to_[i] - from_[i]);
      Vec3 was = glm::cross(tangent_[i], rim.heading[i]);
      if (glm::dot(side, was) < 0.3f * glm::length(side) * glm::length(was)) meets = true;
      if (!meets) continue;
      rim.pace[i] = 0;
      to_[i] = from_[i];
      any = true;
    }
    if (!any) return;
  }
}

/// Lays the row: triangles between the rim and where it has come to, which is the rim from now on.
void GrowingSheets::lay(GrowingRim& rim, int row) {
  auto& triangles = sheet_.triangle;
  std::size_t count = rim.size(), gaps = rim.closed ? count : count - 1;
  GrowingRim after{
      .closed = rim.closed, .tube = rim.tube, .sheet = rim.sheet, .first = rim.first, .last = rim.last};
  auto put = [&](std::uint32_t v, Vec3 heading, float pace) {
    after.vertex.push_back(v), after.heading.push_back(heading), after.pace.push_back(pace);
  };
  auto birth = static_cast<float>(row + 1);
  auto raised = [&](std::size_t i) {
    if (rim.pace[i] == 0) return rim.vertex[i];
    std::uint32_t v = rim.vertex[i];
    float way = sheet_.way[v] + glm::distance(from_[i], to_[i]);
    return add(to_[i], {v, v}, birth, way, u_[v], rim.sheet);
  };
  auto heading = [&](std::size_t i) {
    return rim.pace[i] == 0 ? rim.heading[i] : glm::normalize(to_[i] - from_[i]);
  };
  std::size_t left = count;  // that may still be lost
  std::vector<std::uint32_t> above(count, kRimNobody);
  for (std::size_t i = 0; i < count; ++i) {
    if (above[i] == kRimNobody) {
      std::size_t j = rim.next(i);
      bool near = j > i && rim.pace[i] > 0 && rim.pace[j] > 0 && left > 8 && i > 0 && j + 1 < count &&
                  glm::distance(to_[i], to_[j]) < 0.5f * edge_;
      if (near) {
        std::uint32_t p = rim.vertex[i], q = rim.vertex[j];
        Vec3 at = (to_[i] + to_[j]) * 0.5f;
        float way = (sheet_.way[p] + sheet_.way[q]) / 2 + step_ * rim.pace[i];
        above[i] = above[j] = add(at, {p, q}, birth, way, (u_[p] + u_[q]) / 2, rim.sheet);
        put(above[i], glm::normalize(heading(i) + heading(j) + aim_[i] * 0.01f), rim.pace[i]);
        --left;
      } else {
        above[i] = raised(i);
        put(above[i], heading(i), rim.pace[i]);
      }
    }
    if (i >= gaps) continue;
    std::size_t j = rim.next(i);
    bool merges = j > i && above[j] != kRimNobody;
    bool moves = rim.pace[i] > 0 || rim.pace[j] > 0;
    if (merges || !moves || glm::distance(to_[i], to_[j]) < 1.45f * edge_) continue;
    std::uint32_t p = rim.vertex[i], q = rim.vertex[j];
    Vec3 at = (to_[i] + to_[j]) * 0.5f;
    std::uint32_t m = add(at, {p, q}, birth, (sheet_.way[p] + sheet_.way[q]) / 2 + step_ * rim.pace[i],
                          (u_[p] + (j > i ? u_[q] : 1)) / 2, rim.sheet);
    put(m, glm::normalize(heading(i) + heading(j) + aim_[i] * 0.01f), std::max(rim.pace[i], rim.pace[j]));
  }
  // Between each old vertex and the next lies a run of new ones.
  std::size_t place = 0;
  for (std::size_t i = 0; i < gaps; ++i) {
    std::size_t j = rim.next(i);
    std::uint32_t p = rim.vertex[i], q = rim.vertex[j];
    std::uint32_t begin = above[i], end = above[j];
    if (begin == end) {
      if (begin != p && begin != q) triangles.push_back({p, begin, q});
      continue;
    }
    std::vector<std::uint32_t> run{begin};
    while (after.vertex[place] != begin) ++place;
    for (std::size_t k = place + 1; after.vertex[k % after.size()] != end; ++k)
      run.push_back(after.vertex[k % after.size()]);
    run.push_back(end);
    std::size_t half = run.size() / 2;
    for (std::size_t k = 0; k + 1 < run.size(); ++k) {
      std::uint32_t low = k < half ? p : q;
      if (run[k] != low && run[k + 1] != low) triangles.push_back({p == low ? p : q, run[k], run[k + 1]});
    }
    if (run[half] != p && run[half] != q) triangles.push_back({p, run[half], q});
  }
  for (std::uint32_t v : rim.vertex) seat_[v] = kRimNobody;
  rim = std::move(after);
}

}  // namespace frond
