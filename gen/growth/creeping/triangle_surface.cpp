#include "creeping/triangle_surface.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "core/cancellation.h"
#include "creeping/soup.h"

namespace frond {

namespace {

constexpr int kFace = 6;  // features: 0..2 a corner, 3..5 the edge that begins there, the face
constexpr double kInf = std::numeric_limits<double>::infinity();

/// The nearest point of a triangle and the feature that it lies on (Ericson 2005, 5.1.5).
DVec3 nearest_on(const std::array<Vec3, 3>& t, const DVec3& p, int& feature) {
  DVec3 a(t[0]), b(t[1]), c(t[2]);
  DVec3 ab = b - a, ac = c - a, ap = p - a;
  double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return feature = 0, a;
  DVec3 bp = p - b;
  double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return feature = 1, b;
  double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return feature = 3, a + ab * (d1 / (d1 - d3));
  DVec3 cp = p - c;
  double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return feature = 2, c;
  double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return feature = 5, a + ac * (d2 / (d2 - d6));
  double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return feature = 4, b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  double sum = 1 / (va + vb + vc);
  return feature = kFace, a + ab * (vb * sum) + ac * (vc * sum);
}

/// A segment, and what it meets (Moeller and Trumbore 1997).
struct Segment : RTCIntersectContext {
  DVec3 from{0}, along{0};
  bool all = false;     // count every crossing of a closed part instead of finding the first
  double share = kInf;  // of the first
  std::uint32_t triangle = TriangleSurface::kNoTriangle;
  int winding = 0;

  void meet(std::uint32_t t, const std::array<Vec3, 3>& corners, bool solid) {
    DVec3 a(corners[0]), ab = DVec3(corners[1]) - a, ac = DVec3(corners[2]) - a;
    DVec3 across = glm::cross(along, ac), off = from - a;
    double area = glm::dot(ab, across);
    if (area == 0) return;
    double u = glm::dot(off, across) / area;
    // A hair of room at the edges, so that nothing slips through between two triangles.
    constexpr double room = 1e-9;
    if (!(u >= -room && u <= 1 + room)) return;
    DVec3 q = glm::cross(off, ab);
    double v = glm::dot(along, q) / area;
    if (!(v >= -room && u + v <= 1 + room)) return;
    double s = glm::dot(ac, q) / area;
    if (!(s >= 0 && s <= 1)) return;
    if (all) {
      if (solid) winding += area < 0 ? 1 : -1;
    } else if (s < share || (s == share && t < triangle)) {
      share = s;
      triangle = t;
    }
  }
};

struct Search {
  const std::vector<std::array<Vec3, 3>>* corners;
  DVec3 place;
  double best;  // distance squared
  double blur;  // what single precision may miss
  DVec3 point{0};
  std::uint32_t triangle = TriangleSurface::kNoTriangle;
  int feature = kFace;

  /// True where the triangle is nearer than what was known.
  bool look(std::uint32_t t) {
    int f;
    DVec3 q = nearest_on((*corners)[t], place, f), offset = place - q;
    double d = glm::dot(offset, offset);
    if (d > best || (d == best && t >= triangle)) return false;
    bool nearer = d < best || triangle == TriangleSurface::kNoTriangle;
    best = d;
    point = q;
    triangle = t;
    feature = f;
    return nearer;
  }
  float radius() const {
    double r = std::sqrt(best);
    return r < 1e30 ? static_cast<float>(r * (1 + 1e-5) + blur) : std::numeric_limits<float>::infinity();
  }
};

bool look_at(RTCPointQueryFunctionArguments* args) {
  Search& search = *static_cast<Search*>(args->userPtr);
  if (!search.look(args->primID)) return false;
  float radius = search.radius();
  if (!(radius < args->query->radius)) return false;
  args->query->radius = radius;
  return true;
}

}  // namespace

/// Embree's tree over boxes round the triangles.
struct TriangleSurface::Tree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  const std::array<Vec3, 3>* corners = nullptr;  // of each triangle of the host
  const std::uint8_t* solid = nullptr;
  double blur = 0;

  ~Tree() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  static void bounds(const RTCBoundsFunctionArguments* args) {
    const Tree& tree = *static_cast<const Tree*>(args->geometryUserPtr);
    const auto& c = tree.corners[args->primID];
    Vec3 pad(static_cast<float>(tree.blur));
    Vec3 low = glm::min(glm::min(c[0], c[1]), c[2]) - pad, high = glm::max(glm::max(c[0], c[1]), c[2]) + pad;
    *args->bounds_o = {low.x, low.y, low.z, 0, high.x, high.y, high.z, 0};
  }

  static void intersect(const RTCIntersectFunctionNArguments* args) {
    if (!args->valid[0]) return;
    const Tree& tree = *static_cast<const Tree*>(args->geometryUserPtr);
    Segment& segment = *static_cast<Segment*>(args->context);
    segment.meet(args->primID, tree.corners[args->primID], tree.solid[args->primID] != 0);
  }

  bool build(const TriangleSurface& over) {
    blur = 4e-7 * std::max(glm::length(over.low_), glm::length(over.high_)) + 1e-30;
    // A device that is to use fewer threads would hold all of TBB to as many, as long as it lives. What is
    // found does not depend on how the tree was built.
    device = rtcNewDevice(nullptr);
    if (!device) return false;
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(over.corners_.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    isolated([&] { rtcCommitScene(scene); });
    return rtcGetDeviceError(device) == RTC_ERROR_NONE;
  }

  void walk(Segment& segment) const {
    rtcInitIntersectContext(&segment);
    Vec3 from(segment.from), along(segment.along);
    RTCRayHit ray{{from.x, from.y, from.z, 0, along.x, along.y, along.z, 0, 1, ~0u, 0, 0}, {}};
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &segment, &ray);
  }
};

TriangleSurface::TriangleSurface() : tree_(std::make_unique<Tree>()) {}
TriangleSurface::~TriangleSurface() = default;
TriangleSurface::TriangleSurface(TriangleSurface&&) noexcept = default;
TriangleSurface& TriangleSurface::operator=(TriangleSurface&&) noexcept = default;

/// Takes over the triangles; the boxes of their tree are left as they are.
void TriangleSurface::adopt(Soup&& soup) {
  assert(!soup.corners.empty() && soup.vertex.size() == soup.corners.size());
  assert(soup.neighbour.size() == soup.corners.size() && soup.solid.size() == soup.corners.size());
  corners_ = std::move(soup.corners);
  vertex_ = std::move(soup.vertex);
  neighbour_ = std::move(soup.neighbour);
  solid_ = std::move(soup.solid);
  tree_->corners = corners_.data(), tree_->solid = solid_.data();
  paint_ = std::move(soup.paint);
  closed_ = std::all_of(solid_.begin(), solid_.end(), [](auto s) { return s != 0; });
  vertex_normal_.assign(soup.vertices, Vec3(0));
  Vec3 low = corners_[0][0], high = low;
  for (std::uint32_t t = 0; t < corners_.size(); ++t) {
    const auto& c = corners_[t];
    DVec3 normal = face_normal(t);
    for (int i = 0; i < 3; ++i) {
      low = glm::min(low, c[i]);
      high = glm::max(high, c[i]);
      DVec3 a = glm::normalize(DVec3(c[(i + 1) % 3]) - DVec3(c[i]));
      DVec3 b = glm::normalize(DVec3(c[(i + 2) % 3]) - DVec3(c[i]));
      double angle = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
      vertex_normal_[vertex_[t][i]] += Vec3(normal * angle);
    }
  }
  low_ = low;
  high_ = high;
}

/// How many of four rays lead from one side (1 or -1) of a triangle into the open.
double TriangleSurface::openness(std::uint32_t triangle, double side) const {
  constexpr double kOff = 1e-5, kFar = 2;  // of the host's size: from the face; how far is looked
  constexpr double kLean = 0.7;            // of rays to their side, beside the normal's 1
  const auto& c = corners_[triangle];
  DVec3 normal = side * face_normal(triangle), along = glm::normalize(DVec3(c[1]) - DVec3(c[0]));
  DVec3 from = (DVec3(c[0]) + DVec3(c[1]) + DVec3(c[2])) / 3.0 + normal * (kOff * size());
  DVec3 across = glm::cross(normal, along);
  double open = 0;
  for (const DVec3& lean : {along, -along, across, -across})
    open += !crossing(from, from + (normal + kLean * lean) * (kFar * size()));
  return open;
}

Result<TriangleSurface> TriangleSurface::build(const Surface& surface, std::string_view name) {
  Soup soup = mend_surface(surface);
  if (soup.corners.empty())
    return error_at(std::string(name), "none of the {} triangles has an area", surface.triangle.size());
  TriangleSurface host;
  host.adopt(Soup(soup));
  if (!host.tree_->build(host)) return Error{std::string(name), "Embree could not build its tree"};
  if (host.closed_) return host;
  // Open pieces are looked at from both sides, at so many of their triangles or a few more, and turned where
  // the back is clearly more in the open.
  constexpr std::uint32_t kLooks = 64;
  constexpr double kClearly = 1.25;
  std::vector<std::uint32_t> count(soup.pieces, 0), seen(soup.pieces, 0);
  std::vector<double> front(soup.pieces, 0), back(soup.pieces, 0);
  for (std::uint32_t p : soup.piece) ++count[p];
  for (std::uint32_t t = 0; t < soup.piece.size(); ++t) {
    std::uint32_t p = soup.piece[t];
    if (soup.solid[t] || seen[p]++ % (1 + count[p] / kLooks) != 0) continue;
    front[p] += host.openness(t, 1);
    back[p] += host.openness(t, -1);
  }
  bool turned = false;
  for (std::uint32_t t = 0; t < soup.piece.size(); ++t) {
    std::uint32_t p = soup.piece[t];
    if (back[p] <= kClearly * front[p] + 1) continue;
    flip(soup, t);
    turned = true;
  }
  if (turned) host.adopt(std::move(soup));
  return host;
}

DVec3 TriangleSurface::face_normal(std::uint32_t triangle) const {
  assert(triangle < corners_.size());
  const auto& c = corners_[triangle];
  return glm::normalize(glm::cross(DVec3(c[1]) - DVec3(c[0]), DVec3(c[2]) - DVec3(c[0])));
}

Vec3 TriangleSurface::paint(std::uint32_t triangle, const DVec3& point) const {
  if (paint_.empty()) return kUnpainted;
  const auto& c = corners_[triangle];
  const auto& p = paint_[triangle];
  DVec3 one = DVec3(c[1]) - DVec3(c[0]), two = DVec3(c[2]) - DVec3(c[0]), across = glm::cross(one, two);
  DVec3 off = (point - DVec3(c[0])) / glm::dot(across, across);
  auto v = static_cast<float>(glm::dot(glm::cross(off, two), across));
  auto w = static_cast<float>(glm::dot(glm::cross(one, off), across));
  return p[0] * (1 - v - w) + p[1] * v + p[2] * w;
}

bool TriangleSurface::has_paint(int channel) const {
  // A grey below 0 only bars creepers.
  return std::ranges::any_of(paint_, [&](const auto& corners) {
    return channel == 2 ? corners[0][channel] >= 0 : !std::isnan(corners[0][channel]);
  });
}

/// Tells outside from inside at any feature (Baerentzen and Aanaes 2005).
DVec3 TriangleSurface::feature_normal(std::uint32_t triangle, int feature) const {
  assert(feature >= 0 && feature <= kFace);
  DVec3 face = face_normal(triangle), sum = face;
  if (feature < 3) {
    sum = DVec3(vertex_normal_[vertex_[triangle][feature]]);
  } else if (feature < kFace) {
    std::uint32_t other = neighbour_[triangle][feature - 3];
    if (other != kNoTriangle) sum += face_normal(other);
  }
  double length = glm::length(sum);
  return length > 1e-6 ? sum / length : face;
}

std::optional<Contact> TriangleSurface::closest(const DVec3& place, double within,
                                                std::uint32_t likely) const {
  assert(std::isfinite(glm::dot(place, place)) && within >= 0);
  Search search{&corners_, place, within * within, tree_->blur + 2e-7 * glm::length(place)};
  if (likely < corners_.size()) search.look(likely);
  RTCPointQuery query{static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z),
                      0, search.radius()};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(tree_->scene, &query, &context, look_at, &search);
  if (search.triangle == kNoTriangle) return std::nullopt;
  Contact contact{search.point, feature_normal(search.triangle, search.feature), std::sqrt(search.best),
                  search.triangle};
  DVec3 offset = place - search.point;
  contact.inside = glm::dot(offset, contact.normal) < 0;
  if (contact.distance > 1e-12 * size()) {
    DVec3 out = offset / (contact.inside ? -contact.distance : contact.distance);
    // On the surface itself there is no such direction; the feature's takes over.
    contact.normal = glm::normalize(out + (1e-7 * size() / contact.distance) * contact.normal);
  }
  return contact;
}

std::optional<Crossing> TriangleSurface::crossing(const DVec3& from, const DVec3& to) const {
  assert(std::isfinite(glm::dot(from, from)) && std::isfinite(glm::dot(to, to)));
  Segment segment;
  segment.from = from;
  segment.along = to - from;
  tree_->walk(segment);
  if (segment.triangle == kNoTriangle) return std::nullopt;
  return Crossing{segment.share, face_normal(segment.triangle), segment.triangle};
}

bool TriangleSurface::inside(const DVec3& place) const {
  if (glm::any(glm::lessThan(place, low_)) || glm::any(glm::greaterThan(place, high_))) return false;
  // A ray that meets an edge counts two triangles; the majority of five does not.
  static const DVec3 directions[] = {{0.5377, 0.7639, 0.3569},
                                     {-0.8611, 0.2274, 0.4549},
                                     {0.1321, -0.4783, 0.8682},
                                     {-0.3127, 0.6421, -0.7001},
                                     {0.7219, -0.5897, -0.3621}};
  int votes = 0;
  for (const DVec3& direction : directions) {
    Segment segment;
    segment.from = place;
    segment.along = direction * (2 * size());
    segment.all = true;
    tree_->walk(segment);
    votes += segment.winding > 0 ? 1 : -1;  // more faces left than entered
    if (std::abs(votes) == 3) break;
  }
  return votes > 0;
}

}  // namespace frond
