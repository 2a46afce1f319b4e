#include "passes/traced_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frond {

namespace {

constexpr float kClear = 1e-4f;  // of the distance to the eye, by which a ray begins off its surface

/// The ray from a place in a direction, between two distances.
RTCRay ray_of(Vec3 from, Vec3 along, float least, float most) {
  RTCRay ray{};
  ray.org_x = from.x, ray.org_y = from.y, ray.org_z = from.z;
  ray.dir_x = along.x, ray.dir_y = along.y, ray.dir_z = along.z;
  ray.tnear = least, ray.tfar = most;
  ray.mask = ~0u;
  return ray;
}

/// The normal that a place on a triangle is shaded by, of any length.
Vec3 shading_normal(const Surface& surface, std::uint32_t face, Vec2 share, Vec3 flat) {
  if (surface.normal.size() != surface.position.size()) return flat;
  const auto& t = surface.triangle[face];
  return (1 - share.x - share.y) * surface.normal[t[0]] + share.x * surface.normal[t[1]] +
         share.y * surface.normal[t[2]];
}

/// The normal is as long as twice the triangle's area.
PlaceNormal on_triangle(const Surface& surface, std::uint32_t face, Vec2 share) {
  const auto& t = surface.triangle[face];
  Vec3 a = surface.position[t[0]], b = surface.position[t[1]], c = surface.position[t[2]];
  return {a + share.x * (b - a) + share.y * (c - a), glm::cross(b - a, c - a)};
}

/// What a ray meets, and the normal that it is shaded by.
std::pair<PassHit, Vec3> hit_on(const Placed& one, const RTCRayHit& ray) {
  PassHit hit;
  hit.away = ray.ray.tfar;
  Vec3 from(ray.ray.org_x, ray.ray.org_y, ray.ray.org_z), along(ray.ray.dir_x, ray.ray.dir_y, ray.ray.dir_z);
  hit.at = from + hit.away * along;
  Vec3 normal(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z), shaded = normal;
  if (one.branches) {
    hit.spot = one.branches->spot(ray.hit.primID, ray.hit.u, hit.at);
  } else {
    const Surface& mesh = one.meshes->surface(ray.hit.geomID);
    hit.spot.part = ray.hit.geomID;
    hit.spot.face = ray.hit.primID;
    PlaceNormal own = on_triangle(mesh, ray.hit.primID, {ray.hit.u, ray.hit.v});
    hit.at = one.axes * own.at + one.at;
    const glm::mat3 turn = glm::inverse(glm::transpose(one.axes));
    normal = turn * own.normal;
    shaded = turn * shading_normal(mesh, ray.hit.primID, {ray.hit.u, ray.hit.v}, own.normal);
    hit.spot.own = one.changes ? Vec3(ray.hit.u, ray.hit.v, 0) : own.at;
  }
  hit.spot.thing = one.thing;
  float length = glm::length(normal);
  hit.normal = length > 0 ? normal / length : -along;
  float shaded_length = glm::length(shaded);
  return {hit, shaded_length > 0 ? shaded / shaded_length : hit.normal};
}

}  // namespace

Placed placed(Thing thing, std::shared_ptr<const MeshGroup> meshes, const OrganPlace& place, bool changes) {
  return {thing, std::move(meshes), nullptr, axes_of(place.turn, place.scale), place.at, changes};
}

PlacedScene::PlacedScene(std::vector<Placed> placed) : things(std::move(placed)) {
  std::ranges::stable_sort(things, {}, &Placed::thing);
  scene.reset(rtcNewScene(embree_device()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  for (std::size_t i = 0; i < things.size(); ++i) {
    GeometryPointer instance(rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_INSTANCE));
    check_embree();
    rtcSetGeometryInstancedScene(instance.get(), things[i].scene());
    glm::mat4x3 transform(things[i].axes[0], things[i].axes[1], things[i].axes[2], things[i].at);
    rtcSetGeometryTransform(instance.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &transform[0][0]);
    rtcCommitGeometry(instance.get());
    rtcAttachGeometryByID(scene.get(), instance.get(), static_cast<unsigned>(i));
  }
  commit_scene(scene.get());
}

const Placed* PlacedScene::find(const Thing& thing) const {
  auto found = std::ranges::lower_bound(things, thing, {}, &Placed::thing);
  return found != things.end() && found->thing == thing ? &*found : nullptr;
}

bool TracedFrame::Parts::open(RTCRay ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(still->scene.get(), &context, &ray);
  if (ray.tfar >= 0) rtcOccluded1(moving.scene.get(), &context, &ray);
  return ray.tfar >= 0;
}

TracedFrame::TracedFrame(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
TracedFrame::~TracedFrame() = default;
TracedFrame::TracedFrame(TracedFrame&&) noexcept = default;

std::optional<PassHit> TracedFrame::trace(Vec3 from, Vec3 direction) const {
  RTCRayHit ray{};
  ray.ray = ray_of(from, direction, 1e-4f, std::numeric_limits<float>::infinity());
  ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(parts_->still->scene.get(), &context, &ray);
  // What moves may be met just as far away as what does not, so the distance does not tell which of both it
  // is.
  RTCHit unmoved = ray.hit;
  ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(parts_->moving.scene.get(), &context, &ray);
  bool moves = ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  if (!moves) ray.hit = unmoved;
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Placed& one = (moves ? parts_->moving : *parts_->still).things[ray.hit.instID[0]];
  auto [hit, shaded] = hit_on(one, ray);
  if (glm::dot(hit.normal, direction) > 0) hit.normal = -hit.normal;
  if (glm::dot(shaded, direction) > 0) shaded = -shaded;
  hit.spot.facing = glm::dot(shaded, to_light(hit.at).first);
  if (one.branches)
    hit.spot.own_normal = glm::conjugate(one.branches->turn(hit.spot.face)) * hit.normal;
  else if (!one.changes)
    hit.spot.own_normal = glm::transpose(one.axes) * hit.normal;
  else
    hit.spot.own_normal = hit.normal;
  return hit;
}

std::pair<Vec3, float> TracedFrame::to_light(Vec3 at) const {
  if (!parts_->is_lamp) return {parts_->light, std::numeric_limits<float>::infinity()};
  Vec3 way = parts_->light - at;
  float far = glm::length(way);
  return {way / std::max(far, 1e-6f), far};
}

bool TracedFrame::lit(const PassHit& hit) const {
  auto [toward, far] = to_light(hit.at);
  if (hit.spot.facing <= 0 || glm::dot(hit.normal, toward) <= 0) return false;
  float clear = kClear * std::max(glm::distance(hit.at, eye.at), 1.0f);
  return parts_->open(ray_of(hit.at + clear * hit.normal, toward, clear, far));
}

bool TracedFrame::open(Vec3 from, Vec3 direction) const {
  return parts_->open(ray_of(from, direction, 1e-3f, std::numeric_limits<float>::infinity()));
}

std::optional<PlaceNormal> TracedFrame::where(const SurfaceSpot& spot) const {
  const Placed* found = parts_->moving.find(spot.thing);
  if (!found) found = parts_->still->find(spot.thing);
  if (!found) return std::nullopt;
  if (found->branches) return found->branches->where(spot);
  PlaceNormal own{spot.own, spot.own_normal};
  if (found->changes) {
    if (spot.part >= found->meshes->size()) return std::nullopt;
    const Surface& mesh = found->meshes->surface(spot.part);
    if (spot.face >= mesh.triangle.size()) return std::nullopt;
    own = on_triangle(mesh, spot.face, Vec2(spot.own));
  }
  Vec3 normal = glm::inverse(glm::transpose(found->axes)) * own.normal;
  float length = glm::length(normal);
  return PlaceNormal{found->axes * own.at + found->at, length > 0 ? normal / length : Vec3(0, 1, 0)};
}

CameraRay TracedFrame::ray(Vec2 place, int ray, float spread) const {
  Vec3 along = picture_ray(eye, place);
  if (lens == 0) return {eye.at, along};
  // The sequence of Roberts (2018) for two dimensions.
  float far = glm::fract(spread + 0.7548777f * static_cast<float>(ray)),
        turn = 2 * static_cast<float>(kPi) * glm::fract(spread + 0.5698403f * static_cast<float>(ray));
  Vec2 aside = 0.5f * lens * std::sqrt(far) * Vec2(std::cos(turn), std::sin(turn));
  Vec3 from = eye.at + aside.x * glm::cross(eye.ahead, eye.up) + aside.y * eye.up;
  Vec3 to = eye.at + along * (sharp / glm::dot(along, eye.ahead));
  return {from, glm::normalize(to - from)};
}

float TracedFrame::blur(Vec3 at) const {
  float deep = std::max(glm::dot(at - eye.at, eye.ahead), 1e-3f);
  return lens * std::abs(1 / sharp - 1 / deep) / static_cast<float>(2 * eye.broad);
}

Vec3 picture_ray(const Eye& eye, Vec2 place) {
  Vec3 right = glm::cross(eye.ahead, eye.up);
  auto aside = static_cast<float>(eye.broad) * (2 * place.x - 1),
       high = static_cast<float>(eye.tall) * (1 - 2 * place.y);
  return glm::normalize(eye.ahead + aside * right + high * eye.up);
}

std::optional<Vec2> picture_place(const Eye& eye, Vec3 at) {
  Vec3 offset = at - eye.at, right = glm::cross(eye.ahead, eye.up);
  float deep = glm::dot(offset, eye.ahead);
  if (deep <= 1e-6f) return std::nullopt;
  float aside = glm::dot(offset, right) / (deep * static_cast<float>(eye.broad)),
        high = glm::dot(offset, eye.up) / (deep * static_cast<float>(eye.tall));
  return Vec2((aside + 1) / 2, (1 - high) / 2);
}

}  // namespace frond
