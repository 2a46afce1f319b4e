#include "scene/copy_organs.h"

#include <algorithm>
#include <cmath>

#include "appearance/fruiting.h"
#include "core/bounds.h"
#include "geometry/far.h"

namespace frond {

namespace {

constexpr std::int32_t kOwnPlaces = 3600;  // how many leaves can be told apart
constexpr double kManyPixels = 9;          // the side of a leaf that is drawn with its outline
constexpr double kFewestPixels = 2;        // the side of a leaf; smaller ones become fewer and larger

/// The shape of an organ's part at a grain, and how many organs stand for one: for the size of their pixels,
/// and for their number.
struct FarShape {
  Surface surface;
  Pieces pieces;
  int stride = 1, crowd = 1;
};

/// Edge of a square of a surface's mean piece, or of all of it.
double extent(const Surface& s, std::uint32_t pieces) { return std::sqrt(area(s) / std::max(1u, pieces)); }

double largest_of(Vec3 sides) { return std::max({sides.x, sides.y, sides.z}); }

/// How many pieces of so many pixels one stands for, so that it has kFewestPixels.
int stride_of(double pixels) {
  return static_cast<int>(
      std::clamp(std::ceil(kFewestPixels * kFewestPixels / (pixels * pixels)), 1.0, 60.0));
}

/// The shape of `count` organs of a mean size, whose sides are in `ratio`, 1 the longest.
FarShape far_shape(const Surface& own, Vec3 ratio, double size, double count, const CopyDetail& detail) {
  FarShape far{own, pieces_of(own)};
  // What is long in an organ that is as long and wide as they are.
  Surface shape = own;
  for (Vec3& p : shape.position) p *= ratio;
  double piece = size * extent(shape, far.pieces.count) / detail.grain;
  FarLeaf as = detail.plain ? FarLeaf::triangle : FarLeaf::diamond;
  if (piece > kManyPixels && count * static_cast<double>(shape.triangle.size()) < detail.leaves) return far;
  // What is seen as a body stays one, of as many triangles as there are for it.
  constexpr double kLeastBody = 12;
  if (double most = detail.leaves / count; detail.solid && piece > kManyPixels && most >= kLeastBody) {
    far.surface = reduced(own, static_cast<std::size_t>(most));
    const auto same_area = static_cast<float>(std::sqrt(area(own) / area(far.surface)));
    for (Vec3& p : far.surface.position) p *= same_area;
    far.pieces = pieces_of(far.surface);
    return far;
  }
  const double each = as == FarLeaf::triangle ? 1 : 2;  // triangles
  auto crowded = static_cast<int>(std::min(std::ceil(count * each * far.pieces.count / detail.leaves), 1e6));
  int stride = std::max(stride_of(piece), crowded);
  // Pieces stand for each other as far as there are some; then whole organs do.
  auto pieces = static_cast<int>(far.pieces.count);
  if (pieces > 1 && 2 * stride <= pieces) {
    far.surface = far_leaves(shape, far.pieces, stride, as, detail.cover);
  } else {
    far.surface = one_far_leaf(shape, far.pieces, as);
    far.stride = stride_of(size * extent(shape, 1) / detail.grain), far.crowd = crowded / pieces;
  }
  for (Vec3& p : far.surface.position) p /= ratio;
  far.pieces = pieces_of(far.surface);
  return far;
}

/// One of `stride` organs of a prototype, which stands for all of them: indices in `now`, if there is one.
std::vector<std::size_t> chosen(const Model& model, std::size_t which, int stride, const Organs* now) {
  std::vector<std::size_t> list;
  const Organs& all = model.organs;
  std::size_t next = 0;
  int rank = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all.prototype[i] != which) continue;
    bool stands = rank++ % stride == stride / 2;
    if (!now) {
      if (stands) list.push_back(i);
      continue;
    }
    // Those that are there are in the same order.
    while (next < now->size() && now->prototype[next] != which) ++next;
    if (next == now->size() || now->id[next] != all.id[i]) continue;
    if (stands) list.push_back(next);
    ++next;
  }
  // What the model in full leaf does not bear.
  for (std::size_t i = 0; now && rank == 0 && i < now->size(); ++i)
    if (now->prototype[i] == which && Seed{now->id[i]}.bits() % static_cast<std::uint64_t>(stride) == 0)
      list.push_back(i);
  return list;
}

/// How many times larger those that are left are, so that they have that share of the area of all in full
/// leaf.
float larger_by(const Model& model, std::size_t which, int stride, double cover) {
  const Organs& all = model.organs;
  auto area_of = [&](std::size_t i) { return static_cast<double>(glm::dot(all.scale[i], all.scale[i])); };
  double whole = 0, left = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all.prototype[i] == which) whole += area_of(i);
  for (std::size_t i : chosen(model, which, stride, nullptr)) left += area_of(i);
  return static_cast<float>(std::sqrt(std::max(1.0, cover * (left > 0 ? whole / left : stride))));
}

/// Adds organs of the model, or of what there is `now`, each `larger` than it is.
void merge(CopyPart& part, const Model& model, std::size_t which, const FarShape& far,
           const std::vector<std::size_t>& list, float larger, const ModelBlocks* blocks, const Organs* now) {
  Surface& out = part.surface;
  const Organs& o = now ? *now : model.organs;
  auto colors = static_cast<std::int32_t>(model.prototypes[which].colors.size());
  for (std::size_t i : list) {
    Seed own{o.id[i]};
    auto first = static_cast<std::uint32_t>(out.position.size());
    glm::mat3 frame = glm::mat3_cast(o.turn[i]), normals = frame;
    for (int axis = 0; axis < 3; ++axis) frame[axis] *= o.scale[i][axis] * larger;
    for (const Vec3& p : far.surface.position) out.position.push_back(o.position[i] + frame * p);
    for (const Vec3& n : far.surface.normal) out.normal.push_back(normals * n);
    auto color = static_cast<std::int32_t>(color_index(o.color[i], model.prototypes[which].colors.size()));
    for (std::size_t v = 0; v < far.surface.uv.size(); ++v) {
      auto k = static_cast<std::int32_t>(own.child(far.pieces.of[v]).bits() %
                                         static_cast<std::uint64_t>(kOwnPlaces / colors)) *
               colors;
      // A place at the far rim would be one on the next leaf.
      Vec2 uv = glm::clamp(far.surface.uv[v], Vec2(0.001f), Vec2(0.999f));
      out.uv.push_back(uv + Vec2(k + color, 0));
    }
    for (auto [a, b, c] : far.surface.triangle) out.triangle.push_back({first + a, first + b, first + c});
    if (blocks) part.block.resize(out.triangle.size(), blocks->of(o.position[i]));
  }
}

}  // namespace

bool is_fruit(const Prototype& organ) { return organ.name == kFruit || organ.name == kFruitStalk; }

std::vector<double> organ_areas(const Model& model) {
  std::vector<double> each, areas;
  for (const Prototype& prototype : model.prototypes) {
    double& of = each.emplace_back(0);
    for (const OrganPart& part : prototype.parts)
      if (part.tissue != Tissue::dew && !is_fruit(prototype))
        of += area(far_leaves(part.surface, pieces_of(part.surface)));
  }
  areas.resize(each.size());
  const Organs& o = model.organs;
  for (std::size_t i = 0; i < o.size(); ++i) {
    // A shape that is stretched along its axes, seen from all sides.
    const Vec3 s = o.scale[i];
    areas[o.prototype[i]] += each[o.prototype[i]] * (s.x * s.y + s.y * s.z + s.z * s.x) / 3;
  }
  return areas;
}

double hiding_share(const Model& model, double area) {
  constexpr double kHidden = 10;  // silhouettes
  if (!(area > 0)) return 1;
  std::vector<Bounds> shapes(model.prototypes.size());
  for (std::size_t p = 0; p < shapes.size(); ++p)
    for (const OrganPart& part : model.prototypes[p].parts)
      for (const Vec3& at : part.surface.position) shapes[p].extend(at);
  Bounds box;
  const Organs& o = model.organs;
  for (std::size_t i = 0; i < o.size(); ++i)
    for (int corner = 0; corner < 8; ++corner) {
      const auto& [low, high] = shapes[o.prototype[i]];
      const Vec3 at(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
      box.extend(o.position[i] + o.turn[i] * (o.scale[i] * at));
    }
  const Vec3 s = box.high - box.low;
  // The mean silhouette of a convex body is a quarter of its surface (Cauchy); of an ellipsoid in the box.
  const double silhouette = kPi / 4 * (s.x * s.y + s.y * s.z + s.z * s.x) / 2;
  return std::min(1.0, kHidden * silhouette / area);
}

std::vector<CopyPart> merged_organs(const Model& model, std::size_t which, const CopyDetail& detail,
                                    const ModelBlocks* blocks, const Organs* now) {
  constexpr double kFlower = 0.035;  // metres across, of those that come before the leaves
  const Prototype& prototype = model.prototypes[which];
  const Organs& o = model.organs;
  double size = 0, largest = 0;
  int count = 0;
  Vec3 sides(0);
  for (std::size_t i = 0; i < o.size(); ++i)
    if (o.prototype[i] == which) size += largest_of(o.scale[i]), sides += o.scale[i], ++count;
  std::vector<CopyPart> parts(prototype.parts.size());
  Vec3 ratio = count > 0 ? sides / static_cast<float>(largest_of(sides)) : Vec3(1);
  if (count == 0 && now) {
    const double borne = prototype.borne;
    count = borne > 0 ? std::max(1, static_cast<int>(borne * static_cast<double>(o.size())))
                      : static_cast<int>(o.size()) + 1;
    size = (borne > 0 ? prototype.mean : kFlower) * count;
  }
  if (count == 0) return parts;
  std::vector<FarShape> shapes;
  // The largest part decides how many organs are seen; of the others only their number counts.
  int stride = 1, crowd = 1;
  for (const OrganPart& part : prototype.parts) {
    shapes.push_back(part.tissue == Tissue::dew
                         ? FarShape{}
                         : far_shape(part.surface, ratio, size / count, count, detail));
    crowd = std::max(crowd, shapes.back().crowd);
    if (double of_part = part.tissue == Tissue::dew ? 0 : area(part.surface); of_part > largest)
      largest = of_part, stride = shapes.back().stride;
  }
  stride = std::min(std::max(stride, crowd), count);  // one is left at least
  const std::vector<std::size_t> list = chosen(model, which, stride, now);
  const float larger = stride > 1 ? larger_by(model, which, stride, detail.cover) : 1;
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (prototype.parts[k].tissue != Tissue::dew)
      merge(parts[k], model, which, shapes[k], list, larger, blocks, now);
  return parts;
}

}  // namespace frond
