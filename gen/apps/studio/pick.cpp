#include "studio/pick.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/parallel.h"
#include "model/bytes.h"

namespace frond {

namespace {

constexpr std::size_t kNodesAtOnce = 1 << 16;
constexpr std::size_t kMostSegments = 4000;  // that are told of what hangs on a place
constexpr float kSlack = 0.001f;             // of its distance: so thick at least a twig is, to be met

/// Where a ray meets a branch.
struct Meeting {
  float far = HUGE_VALF;  ///< along the ray
  BranchPlace place{Skeleton::kRoot, 0};
};

constexpr float kTaper = 1.5f;  // of a segment: a twig is not as thick at its foot as the limb that it leaves

float foot_radius(const Pose& pose, std::int32_t p, std::int32_t i) {
  return std::min(pose.radius[p], kTaper * pose.radius[i]);
}

float radius_at(const Pose& pose, std::int32_t p, BranchPlace place) {
  return glm::mix(foot_radius(pose, p, place.node), pose.radius[place.node], place.within);
}

/// With the cone of a segment about its axis, as if it were as thick as it is where the ray comes nearest.
void meet(Meeting& best, Vec3 from, Vec3 along, const Pose& pose, std::int32_t p, std::int32_t i) {
  const Vec3 a = pose.position[p], b = pose.position[i], way = b - a, to = a - from;
  const float length2 = glm::dot(way, way);
  if (!(length2 > 1e-14f)) return;
  const float slope = glm::dot(along, way), level = glm::dot(along, to), back = glm::dot(way, to);
  const float square = length2 - slope * slope;
  float share = square > 1e-9f * length2 ? (slope * level - back) / square : 0;
  share = std::clamp(share, 0.0f, 1.0f);
  const Vec3 on = to + way * share;
  const float far = glm::dot(along, on), gap2 = glm::dot(on, on) - far * far;
  const float radius = std::max(radius_at(pose, p, {i, share}), kSlack * far);
  if (far <= 0 || gap2 > radius * radius) return;
  const float sine = std::sqrt(std::max(square / length2, 0.04f));
  const float front = far - std::sqrt(radius * radius - std::max(gap2, 0.0f)) / sine;
  if (front < best.far) best = {front, {i, share}};
}

Meeting meet_all(const PosedScene::One& one, Vec3 from, Vec3 along) {
  const std::vector<std::int32_t>& parent = one.now->model.skeleton.parent;
  std::vector<Meeting> best((parent.size() + kNodesAtOnce - 1) / kNodesAtOnce);
  parallel_for(best.size(), [&](std::size_t k) {
    const std::size_t end = std::min((k + 1) * kNodesAtOnce, parent.size());
    for (std::size_t i = k * kNodesAtOnce; i < end; ++i)
      if (parent[i] != Skeleton::kRoot)
        meet(best[k], from, along, one.pose, parent[i], static_cast<std::int32_t>(i));
  });
  Meeting first;
  for (const Meeting& meeting : best)
    if (meeting.far < first.far) first = meeting;
  return first;
}

void append(Json& list, Vec3 at, float radius) {
  // Tenths of millimetres are enough, and shorter to send.
  for (float x : {at.x, at.y, at.z}) list.push_back(std::round(x * 1e4) / 1e4);
  list.push_back(std::round(radius * 1e5) / 1e5);
}

/// Both ends of the segments beyond a place, the thickest first.
Json hanging_json(const PosedScene::One& one, BranchPlace place, Vec3 at, float radius) {
  const std::vector<std::int32_t>& parent = one.now->model.skeleton.parent;
  const Pose& pose = one.pose;
  std::vector<std::uint8_t> beyond(parent.size());
  std::vector<std::int32_t> segments;
  beyond[place.node] = 1;
  for (auto i = static_cast<std::size_t>(place.node) + 1; i < parent.size(); ++i) {
    if (parent[i] == Skeleton::kRoot || !beyond[parent[i]]) continue;
    beyond[i] = 1;
    segments.push_back(static_cast<std::int32_t>(i));
  }
  auto thicker = [&](std::int32_t a, std::int32_t b) {
    return pose.radius[a] != pose.radius[b] ? pose.radius[a] > pose.radius[b] : a < b;
  };
  if (segments.size() >= kMostSegments) {
    std::ranges::nth_element(segments, segments.begin() + kMostSegments - 1, thicker);
    segments.resize(kMostSegments - 1);
  }
  std::ranges::sort(segments, thicker);
  Json list = Json::array();
  append(list, at, radius), append(list, pose.position[place.node], pose.radius[place.node]);
  for (std::int32_t i : segments) {
    append(list, pose.position[parent[i]], foot_radius(pose, parent[i], i));
    append(list, pose.position[i], pose.radius[i]);
  }
  return list;
}

/// The nodes of the axis of a place, from where it leaves its parent to its end.
Json beam_json(const PosedScene::One& one, BranchPlace place) {
  const std::vector<std::int32_t>& parent = one.now->model.skeleton.parent;
  const std::vector<std::int32_t> starts = axis_starts({parent, one.axes});
  const std::int32_t start = starts[place.node];
  Json list = Json::array();
  auto add = [&](std::size_t i) { append(list, one.pose.position[i], one.pose.radius[i]); };
  if (parent[start] != Skeleton::kRoot) add(static_cast<std::size_t>(parent[start]));
  for (auto i = static_cast<std::size_t>(start); i < starts.size(); ++i)
    if (starts[i] == start) add(i);
  return list;
}

Json answer_of(const PosedScene::One& one, const PosedScene& scene, BranchPlace place) {
  const Specimen& s = *one.now;
  const Pose& pose = one.pose;
  std::optional<Address> address = address_of({s.model.skeleton.parent, one.axes}, place);
  if (!address) return nullptr;
  const std::int32_t p = s.model.skeleton.parent[place.node];
  const Vec3 way = pose.position[place.node] - pose.position[p];
  const Vec3 at = pose.position[p] + way * place.within;
  const float radius = radius_at(pose, p, place);
  const Placement& placed = s.placement;
  Json json{{"entry", one.entry},
            {"plant", one.plant},
            {"at", text(*address)},
            {"point", json_of(at)},
            {"radius", radius},
            {"direction", json_of(glm::normalize(way))},
            {"frame", {placed.turn.x, placed.turn.y, placed.turn.z, placed.turn.w}},
            {"size", placed.size},
            {"foot", json_of(placed.foot)},
            {"hangs", hanging_json(one, place, at, radius)},
            {"beam", beam_json(one, place)},
            {"year", nullptr}};
  if (s.life.age) json["year"] = s.life.age(scene.time);
  return json;
}

}  // namespace

std::size_t PosedScene::bytes() const {
  std::size_t bytes = 0;
  for (const One& one : specimens) {
    bytes += bytes_of(one.axes) + bytes_of(one.pose.position) + bytes_of(one.pose.radius) +
             bytes_of(one.pose.turn);
    if (one.now->life.changes()) bytes += bytes_of(*one.now);
  }
  return bytes;
}

Result<PosedScene> posed(const Scene& scene, double time) {
  PosedScene all;
  all.time = time;
  std::vector<const Specimen*> specimens;
  std::map<std::size_t, std::size_t> count;
  for (const Specimen& s : scene.specimens) {
    const std::size_t plant = count[s.entry]++;
    if (s.entry == Specimen::kNoEntry || s.model.skeleton.size() < 2) continue;
    specimens.push_back(&s);
    all.specimens.push_back({s.entry, plant, {}, {}, {}});
  }
  std::vector<Errors> errors(specimens.size());
  parallel_for(specimens.size(), [&](std::size_t i) {
    PosedScene::One& one = all.specimens[i];
    auto now = developed(*specimens[i], time);
    if (!now) {
      errors[i] = now.errors();
      return;
    }
    one.now = *now;
    one.axes = axis_nodes(one.now->model);
    pose_specimen(*one.now, time, one.pose);
  });
  for (const Errors& each : errors)
    if (!each.empty()) return each;
  return all;
}

Json picked(const PosedScene& scene, Vec3 from, Vec3 to, std::optional<std::size_t> entry) {
  const Vec3 way = to - from;
  if (!(glm::length(way) > 0)) return nullptr;
  const Vec3 along = glm::normalize(way);
  Meeting first;
  const PosedScene::One* which = nullptr;
  for (const PosedScene::One& one : scene.specimens) {
    if (entry && one.entry != *entry) continue;
    const Meeting meeting = meet_all(one, from, along);
    if (meeting.far < first.far) first = meeting, which = &one;
  }
  return which ? answer_of(*which, scene, first.place) : Json(nullptr);
}

Json picked_at(const PosedScene& scene, std::size_t entry, std::size_t plant, const Address& address) {
  for (const PosedScene::One& one : scene.specimens) {
    if (one.entry != entry || one.plant != plant) continue;
    const Branching branches{one.now->model.skeleton.parent, one.axes};
    Result<BranchPlace> place = find_place(branches, axis_starts(branches), address);
    if (place && branches.parent[place->node] != Skeleton::kRoot) return answer_of(one, scene, *place);
  }
  return nullptr;
}

}  // namespace frond
