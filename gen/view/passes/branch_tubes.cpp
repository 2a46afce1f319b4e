#include "passes/branch_tubes.h"

#include <algorithm>

namespace frond {

namespace {

constexpr float kThinnest = 1e-6f;  // metres, below which an offset has no direction
constexpr float kOfBody = -1;       // SurfaceSpot::along of what lies on no cone

}  // namespace

Result<BranchTubes> BranchTubes::of(const DrawnBranches& branches) {
  BranchTubes tubes(branches);
  tubes.scene_.reset(rtcNewScene(embree_device()));
  rtcSetSceneFlags(tubes.scene_.get(), RTC_SCENE_FLAG_ROBUST);
  if (branches.form() == BranchForm::body) {
    Result<FusedMesh> body = branches.body();
    if (!body) return body.errors();
    tubes.body_ = std::move(*body);
    attach_mesh(tubes.scene_.get(), tubes.body_->surface, 0);
  } else {
    tubes.add_cones();
  }
  commit_scene(tubes.scene_.get());
  return tubes;
}

bool BranchTubes::reached(std::uint32_t node) const {
  const Skeleton& rest = branches_->rest();
  std::int32_t below = node < rest.size() ? rest.parent[node] : Skeleton::kRoot;
  return below >= 0 && rest.birth[static_cast<std::size_t>(below)] < branches_->pose.front;
}

void BranchTubes::add_cones() {
  const Skeleton& rest = branches_->rest();
  const Pose& pose = branches_->pose;
  std::vector<glm::vec4> ends;
  std::vector<std::uint32_t> first;
  std::int64_t last = -1;  // node of the last end
  for (std::uint32_t node = 0; node < rest.size(); ++node) {
    if (!reached(node) || !(pose.radius[node] > 0)) continue;
    if (last != rest.parent[node] || last + 1 != node) ends.push_back(on_axis(node, 0));
    first.push_back(static_cast<std::uint32_t>(ends.size() - 1));
    node_.push_back(node);
    ends.emplace_back(pose.position[node], pose.radius[node]);
    last = node;
  }
  if (first.empty()) return;
  GeometryPointer cones(rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE));
  fill_buffer<glm::vec4>(cones.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, ends);
  fill_buffer<std::uint32_t>(cones.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, first);
  rtcCommitGeometry(cones.get());
  rtcAttachGeometryByID(scene_.get(), cones.get(), 0);
}

glm::vec4 BranchTubes::on_axis(std::uint32_t node, float along) const {
  const Skeleton& rest = branches_->rest();
  const Pose& pose = branches_->pose;
  auto below = static_cast<std::uint32_t>(rest.parent[node]);
  float foot =
      below + 1 == node ? pose.radius[below] : foot_radius(rest, pose, static_cast<std::int32_t>(node));
  return glm::mix(glm::vec4(pose.position[below], foot), glm::vec4(pose.position[node], pose.radius[node]),
                  along);
}

SurfaceSpot BranchTubes::spot(std::uint32_t face, float u, Vec3 at) const {
  const Pose& pose = branches_->pose;
  SurfaceSpot spot;
  if (body_) {
    spot.face = static_cast<std::uint32_t>(body_->node[body_->surface.triangle[face][0]]);
    spot.along = kOfBody;
    spot.own = glm::conjugate(pose.turn[spot.face]) * (at - pose.position[spot.face]);
    return spot;
  }
  spot.face = node_[face];
  spot.along = std::clamp(u, 0.0f, 1.0f);
  glm::vec4 axis = on_axis(spot.face, spot.along);
  spot.own = glm::conjugate(pose.turn[spot.face]) * (at - Vec3(axis)) / std::max(axis.w, kThinnest);
  return spot;
}

std::optional<PlaceNormal> BranchTubes::where(const SurfaceSpot& spot) const {
  if (!reached(spot.face)) return std::nullopt;
  const Pose& pose = branches_->pose;
  Vec3 offset = pose.turn[spot.face] * spot.own;
  Vec3 normal = pose.turn[spot.face] * spot.own_normal;
  if (spot.along == kOfBody) return PlaceNormal{pose.position[spot.face] + offset, normal};
  glm::vec4 axis = on_axis(spot.face, spot.along);
  return PlaceNormal{Vec3(axis) + axis.w * offset, normal};
}

}  // namespace frond
