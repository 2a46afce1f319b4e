#include <array>
#include <map>

#include "cpfg/cpfg.h"

namespace frond {

namespace {

constexpr std::int32_t kNone = -1;

template <class V>
V mixed_values(V a, V b, double t) {
  return a + (b - a) * t;
}

/// Which parts of two lists are the same: those at the same place in the order of what hangs on a segment.
class SamePlaces {
 public:
  /// Gives an address that parts of both lists share: `on`, told as a segment of the first figure, and how
  /// many of the same kind came before.
  std::array<std::int64_t, 3> next(std::int64_t on, std::int64_t kind) {
    return {on, kind, count_[{on, kind}]++};
  }

 private:
  std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> count_;
};

class Between {
 public:
  Between(const CpfgFigure& a, const CpfgFigure& b, double share) : a_(a), b_(b), t_(share) {}

  CpfgFigure make() {
    match_segments();
    make_segments();
    result_.surfaces = b_.surfaces;
    result_.surfaces.insert(a_.surfaces.begin(), a_.surfaces.end());
    result_.colors = b_.colors;
    make_parts(&CpfgFigure::polygons);
    make_parts(&CpfgFigure::skins);
    make_parts(&CpfgFigure::placed);
    make_parts(&CpfgFigure::spheres);
    make_parts(&CpfgFigure::discs);
    result_.low = mixed_values(a_.low, b_.low, t_), result_.high = mixed_values(a_.high, b_.high, t_);
    result_.end = b_.end, result_.end_heading = b_.end_heading, result_.end_left = b_.end_left,
    result_.end_up = b_.end_up, result_.max_stack_depth = b_.max_stack_depth;
    return std::move(result_);
  }

 private:
  static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

  /// Branches and what goes straight on are counted apart.
  static std::int64_t kind_of(const std::vector<CpfgSegment>& all, const CpfgSegment& s) {
    return s.before != kNone && s.depth > all[index(s.before)].depth ? 1 : 0;
  }

  void match_segments() {
    std::map<std::array<std::int64_t, 3>, std::int32_t> at;
    SamePlaces first, second;
    for (std::size_t i = 0; i < a_.segments.size(); ++i) {
      const CpfgSegment& s = a_.segments[i];
      at[first.next(s.before, kind_of(a_.segments, s))] = static_cast<std::int32_t>(i);
    }
    in_b_.assign(a_.segments.size(), kNone);
    in_a_.assign(b_.segments.size(), kNone);
    for (std::size_t i = 0; i < b_.segments.size(); ++i) {
      const CpfgSegment& s = b_.segments[i];
      if (s.before != kNone && in_a_[index(s.before)] == kNone) continue;
      std::int64_t on = s.before == kNone ? kNone : in_a_[index(s.before)];
      auto found = at.find(second.next(on, kind_of(b_.segments, s)));
      if (found == at.end()) continue;
      in_a_[i] = found->second;
      in_b_[index(found->second)] = static_cast<std::int32_t>(i);
    }
  }

  /// Where a segment's nearest one that is in both figures ends in the other; `otherwise` if there is none.
  static DVec3 anchor(const std::vector<CpfgSegment>& own, const std::vector<std::int32_t>& same,
                      const std::vector<CpfgSegment>& other, std::int32_t segment, DVec3 otherwise) {
    for (; segment != kNone; segment = own[index(segment)].before) {
      if (same[index(segment)] != kNone) return other[index(same[index(segment)])].to;
      otherwise = own[index(segment)].from;
    }
    return otherwise;
  }
  DVec3 anchor_in_a(std::int32_t segment, DVec3 otherwise) const {
    return anchor(b_.segments, in_a_, a_.segments, segment, otherwise);
  }
  DVec3 anchor_in_b(std::int32_t segment, DVec3 otherwise) const {
    return anchor(a_.segments, in_b_, b_.segments, segment, otherwise);
  }

  void make_segments() {
    std::vector<CpfgSegment>& made = result_.segments;
    for (std::size_t i = 0; i < b_.segments.size(); ++i) {
      CpfgSegment s = b_.segments[i];
      if (in_a_[i] != kNone) {
        const CpfgSegment& was = a_.segments[index(in_a_[i])];
        s.from = mixed_values(was.from, s.from, t_), s.to = mixed_values(was.to, s.to, t_);
        s.radius_from = mixed_values(was.radius_from, s.radius_from, t_);
        s.radius_to = mixed_values(was.radius_to, s.radius_to, t_);
      } else {
        DVec3 bud = anchor_in_a(s.before, s.from);
        s.from = mixed_values(bud, s.from, t_), s.to = mixed_values(bud, s.to, t_);
        s.radius_from *= t_, s.radius_to *= t_;
      }
      if (s.before != kNone) s.from = made[index(s.before)].to;
      made.push_back(s);
    }
    // What is gone in the second figure shrinks.
    std::vector<std::int32_t> place = in_b_;
    for (std::size_t i = 0; i < a_.segments.size(); ++i) {
      if (in_b_[i] != kNone) continue;
      CpfgSegment s = a_.segments[i];
      DVec3 scar = anchor_in_b(s.before, s.from);
      s.from = mixed_values(s.from, scar, t_), s.to = mixed_values(s.to, scar, t_);
      s.radius_from *= 1 - t_, s.radius_to *= 1 - t_;
      if (s.before != kNone) s.before = place[index(s.before)], s.from = made[index(s.before)].to;
      place[i] = static_cast<std::int32_t>(made.size());
      made.push_back(s);
    }
    gone_at_ = std::move(place);
  }

  // How far a part has come: from `was`, or from its bud where there is none; or back to its scar.

  static bool same_form(const CpfgPolygon& a, const CpfgPolygon& b) {
    return a.points.size() == b.points.size();
  }
  static bool same_form(const CpfgSkin& a, const CpfgSkin& b) {
    return a.mesh.position.size() == b.mesh.position.size() && a.mesh.triangle == b.mesh.triangle;
  }
  static bool same_form(const CpfgPlaced& a, const CpfgPlaced& b) { return a.surface == b.surface; }
  static bool same_form(const CpfgRound&, const CpfgRound&) { return true; }

  static DVec3 place_of(const CpfgPolygon& p) { return p.points.front(); }
  static DVec3 place_of(const CpfgSkin& s) { return s.foot; }
  static DVec3 place_of(const CpfgPlaced& p) { return p.position; }
  static DVec3 place_of(const CpfgRound& r) { return r.center; }

  static void mix(CpfgPolygon& p, const CpfgPolygon& was, double t) {
    for (std::size_t i = 0; i < p.points.size(); ++i)
      p.points[i] = mixed_values(was.points[i], p.points[i], t);
  }
  static void mix(CpfgSkin& s, const CpfgSkin& was, double t) {
    for (std::size_t i = 0; i < s.mesh.position.size(); ++i)
      s.mesh.position[i] = Vec3(mixed_values(DVec3(was.mesh.position[i]), DVec3(s.mesh.position[i]), t));
    set_normals(s.mesh);
    s.foot = mixed_values(was.foot, s.foot, t);
  }
  static void mix(CpfgPlaced& p, const CpfgPlaced& was, double t) {
    p.position = mixed_values(was.position, p.position, t);
    p.factors = mixed_values(was.factors, p.factors, t);
    DVec3 heading = mixed_values(was.heading, p.heading, t), left = mixed_values(was.left, p.left, t);
    if (glm::length(heading) < 1e-9 || glm::length(glm::cross(heading, left)) < 1e-9) return;
    p.heading = glm::normalize(heading);
    p.left = glm::normalize(left - p.heading * glm::dot(left, p.heading));
    p.up = glm::cross(p.left, p.heading);
  }
  static void mix(CpfgRound& r, const CpfgRound& was, double t) {
    r.center = mixed_values(was.center, r.center, t), r.radius = mixed_values(was.radius, r.radius, t);
    DVec3 normal = mixed_values(was.normal, r.normal, t);
    if (glm::length(normal) > 1e-9) r.normal = glm::normalize(normal);
  }

  /// A part with its place at `at` and `size` times as large.
  static void shrink(CpfgPolygon& p, DVec3 at, double size) {
    DVec3 foot = place_of(p);
    for (DVec3& point : p.points) point = at + (point - foot) * size;
  }
  static void shrink(CpfgSkin& s, DVec3 at, double size) {
    for (Vec3& point : s.mesh.position) point = Vec3(at + (DVec3(point) - s.foot) * size);
    s.foot = at;
  }
  static void shrink(CpfgPlaced& p, DVec3 at, double size) { p.position = at, p.factors *= size; }
  static void shrink(CpfgRound& r, DVec3 at, double size) { r.center = at, r.radius *= size; }

  template <class Part>
  void make_parts(std::vector<Part> CpfgFigure::*list) {
    const std::vector<Part>&before = a_.*list, &after = b_.*list;
    std::map<std::array<std::int64_t, 3>, std::size_t> at;
    std::vector<bool> kept(before.size());
    SamePlaces first, second;
    for (std::size_t i = 0; i < before.size(); ++i) at[first.next(before[i].segment, 0)] = i;
    for (Part part : after) {
      std::int32_t on = part.segment == kNone ? kNone : in_a_[index(part.segment)];
      bool known = part.segment == kNone || on != kNone;
      auto found = known ? at.find(second.next(on, 0)) : at.end();
      if (found != at.end() && same_form(before[found->second], part)) {
        kept[found->second] = true;
        mix(part, before[found->second], t_);
      } else {
        DVec3 bud = anchor_in_a(part.segment, place_of(part));
        shrink(part, mixed_values(bud, place_of(part), t_), t_);
      }
      (result_.*list).push_back(std::move(part));
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (kept[i]) continue;
      Part part = before[i];
      DVec3 scar = anchor_in_b(part.segment, place_of(part));
      shrink(part, mixed_values(place_of(part), scar, t_), 1 - t_);
      if (part.segment != kNone) part.segment = gone_at_[index(part.segment)];
      (result_.*list).push_back(std::move(part));
    }
  }

  const CpfgFigure &a_, &b_;
  double t_;
  CpfgFigure result_;
  std::vector<std::int32_t> in_a_, in_b_;  ///< the same segment in the other figure
  std::vector<std::int32_t> gone_at_;      ///< where each segment of the first is in the result
};

}  // namespace

CpfgFigure between(const CpfgFigure& a, const CpfgFigure& b, double share) {
  if (share <= 0) return a;
  if (share >= 1) return b;
  return Between(a, b, share).make();
}

}  // namespace frond
