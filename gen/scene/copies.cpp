#include "scene/copies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/far.h"
#include "geometry/tubes.h"

namespace frond {

namespace {

constexpr std::uint64_t kFormat = 6;       // of models; to be raised where anything that makes them changes
constexpr std::int32_t kOwnPlaces = 3600;  // how many leaves can be told apart
constexpr int kNeighbours = 6;
constexpr double kManyPixels = 9;    // the side of a leaf that is drawn with its outline
constexpr double kFewestPixels = 2;  // the side of a leaf; smaller ones become fewer and larger

/// A tree that grew up among others.
Model grow_in_crowd(const TreeParams& params, double crowd, double age, Seed seed) {
  std::vector<TreeSite> sites{{&params, Vec3(0), Quat(1, 0, 0, 0), age, seed.child("tree")}};
  double turn = seed.child("ring").range(0, 2 * kPi);
  for (std::uint64_t k = 0; crowd > 0 && k < kNeighbours; ++k) {
    Seed own = seed.child("neighbour", k);
    double angle = turn + 2 * kPi * (static_cast<double>(k) + own.child(0).range(-0.2, 0.2)) / kNeighbours;
    double far = crowd * own.child(1).range(0.85, 1.15);
    sites.push_back({&params, Vec3(far * std::cos(angle), 0, far * std::sin(angle)), Quat(1, 0, 0, 0),
                     age * own.child(2).range(0.75, 0.95), own.child("tree")});
  }
  Grove grove = grow_trees(sites, false, seed.child("weather"));
  return tree_model(params, grove.trees[0], year_at({}, grove.years, 0), {}, seed.child("look"));
}

/// How deep a model stands in the ground.
float sunk(const Organism& organism, const Skeleton& s) {
  if (s.size() == 0) return 0;
  if (std::holds_alternative<TreeParams>(organism.body)) return 0.3f * s.radius[0];
  return std::min(s.radius[0], 0.1f * s.longest());
}

/// The shape of an organ at a grain, and how many stand for one.
struct FarShape {
  Surface surface;
  Pieces pieces;
  int stride = 1;
};

/// Edge of a square of a surface's mean piece, or of all of it.
double extent(const Surface& s, std::uint32_t pieces) {
  double area = 0;
  for (auto [a, b, c] : s.triangle)
    area += 0.5 * glm::length(glm::cross(s.position[b] - s.position[a], s.position[c] - s.position[a]));
  return std::sqrt(area / std::max(1u, pieces));
}

/// How many pieces of so many pixels one stands for, so that it has kFewestPixels.
int stride_of(double pixels) {
  return static_cast<int>(
      std::clamp(std::ceil(kFewestPixels * kFewestPixels / (pixels * pixels)), 1.0, 60.0));
}

/// The shape of `count` organs of a mean size.
FarShape far_shape(const Surface& shape, double size, double count, const CopyDetail& detail) {
  FarShape far{shape, pieces_of(shape), 1};
  double piece = size * extent(shape, far.pieces.count) / detail.grain;
  if (piece > kManyPixels && count * static_cast<double>(shape.triangle.size()) < detail.leaves) return far;
  auto crowded = static_cast<int>(std::min(std::ceil(count * 2 * far.pieces.count / detail.leaves), 1e6));
  int stride = std::max(stride_of(piece), crowded);
  // Pieces stand for each other as far as there are some; then whole organs do.
  auto pieces = static_cast<int>(far.pieces.count);
  if (2 * stride <= pieces || pieces == 1) {
    if (pieces == 1) far.stride = std::exchange(stride, 1);
    far.surface = diamonds(shape, far.pieces, stride);
  } else {
    far.surface = one_diamond(shape, far.pieces);
    far.stride = std::max(stride_of(size * extent(shape, 1) / detail.grain), crowded / pieces);
  }
  far.pieces = pieces_of(far.surface);
  return far;
}

/// Adds one of `stride` organs of a prototype in place of all of them.
void merge(Surface& out, const Model& model, std::size_t which, const FarShape& far, int stride) {
  const Organs& o = model.organs;
  auto colors = static_cast<std::int32_t>(model.prototypes[which].colors.size());
  int rank = 0;
  float larger = std::sqrt(static_cast<float>(stride));
  for (std::size_t i = 0; i < o.size(); ++i) {
    if (o.prototype[i] != which) continue;
    Seed own{o.id[i]};
    if (rank++ % stride != stride / 2) continue;
    auto first = static_cast<std::uint32_t>(out.position.size());
    glm::mat3 frame = glm::mat3_cast(o.turn[i]), normals = frame;
    for (int axis = 0; axis < 3; ++axis) frame[axis] *= o.scale[i][axis] * larger;
    for (const Vec3& p : far.surface.position) out.position.push_back(o.position[i] + frame * p);
    for (const Vec3& n : far.surface.normal) out.normal.push_back(normals * n);
    std::int32_t color = (o.color[i] % colors + colors) % colors;
    for (std::size_t v = 0; v < far.surface.uv.size(); ++v) {
      auto k = static_cast<std::int32_t>(own.child(far.pieces.of[v]).bits() %
                                         static_cast<std::uint64_t>(kOwnPlaces / colors)) *
               colors;
      // A place at the far rim would be one on the next leaf.
      Vec2 uv = glm::clamp(far.surface.uv[v], Vec2(0.001f), Vec2(0.999f));
      out.uv.push_back(uv + Vec2(static_cast<float>(k + color), 0));
    }
    for (auto [a, b, c] : far.surface.triangle) out.triangle.push_back({first + a, first + b, first + c});
  }
}

/// All organs of one prototype, each part of them as one mesh.
std::vector<Surface> merged_organs(const Model& model, std::size_t which, const CopyDetail& detail) {
  const Prototype& prototype = model.prototypes[which];
  const Organs& o = model.organs;
  double size = 0;
  int count = 0;
  for (std::size_t i = 0; i < o.size(); ++i)
    if (o.prototype[i] == which) size += std::max({o.scale[i].x, o.scale[i].y, o.scale[i].z}), ++count;
  std::vector<Surface> parts(prototype.parts.size());
  if (count == 0) return parts;
  std::vector<FarShape> shapes;
  int stride = 1;
  for (const OrganPart& part : prototype.parts) {
    shapes.push_back(far_shape(part.surface, size / count, count, detail));
    stride = std::max(stride, shapes.back().stride);
  }
  stride = std::min(stride, count);  // one is left at least
  for (std::size_t k = 0; k < parts.size(); ++k) merge(parts[k], model, which, shapes[k], stride);
  return parts;
}

Surface merged_solid(const Solids& solids, std::size_t shape) {
  Surface out;
  const Surface& s = solids.shapes[shape].surface;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (solids.shape[i] != shape) continue;
    auto first = static_cast<std::uint32_t>(out.position.size());
    for (const Vec3& p : s.position)
      out.position.push_back(solids.position[i] + solids.turn[i] * (p * solids.scale[i]));
    for (const Vec3& n : s.normal)
      out.normal.push_back(glm::normalize(solids.turn[i] * (n / solids.scale[i])));
    out.uv.insert(out.uv.end(), s.uv.begin(), s.uv.end());
    for (auto [a, b, c] : s.triangle) out.triangle.push_back({first + a, first + b, first + c});
  }
  return out;
}

}  // namespace

Seed copy_key(const Organism& organism, int which) {
  const Sowing& sown = *organism.sown;
  auto index = static_cast<std::size_t>(which);
  std::uint64_t seed = index < sown.seeds.size() ? static_cast<std::uint64_t>(sown.seeds[index]) : index + 1;
  // The distance as a whole number of tenths of a millimetre.
  auto crowd = static_cast<std::uint64_t>(std::llround(sown.crowd * 1e4));
  auto ages = static_cast<std::uint64_t>(std::llround(organism.place.size_variation * 1e6));
  return Seed{seed}.child(organism.text, kFormat).child("crowd", crowd).child("ages", ages);
}

Result<Model> grow_copy(const Organism& organism, int which) {
  Seed seed = copy_key(organism, which);
  Result<Model> model = [&]() -> Result<Model> {
    const auto* tree = std::get_if<TreeParams>(&organism.body);
    if (!tree) return grow(organism, seed);
    double age = 1 + organism.place.size_variation * seed.child("age").range(-1, 1);
    return grow_in_crowd(*tree, organism.sown->crowd, age, seed);
  }();
  if (!model) return model;
  if (const Seasons* seasons = seasons_of(organism)) in_season(*model, *seasons, 0, seed.child("season"));
  float depth = sunk(organism, model->skeleton);
  auto lower = [&](std::vector<Vec3>& places) {
    for (Vec3& p : places) p.y -= depth;
  };
  lower(model->skeleton.position);
  lower(model->organs.position);
  lower(model->blades.surface.position);
  return model;
}

std::vector<CopyPart> copy_parts(const Organism& organism, const Model& model, const CopyDetail& detail) {
  std::vector<CopyPart> parts;
  auto add = [&](CopyPart::Kind kind, std::size_t which, std::size_t part, Surface surface) {
    if (!surface.triangle.empty()) parts.push_back({kind, which, part, std::move(surface)});
  };
  if (model.skeleton.size() > 1) {
    auto fine = static_cast<float>(detail.grain);
    TubeShape shape;
    const BarkCoat* coat = coat_of(organism);
    if (coat) shape.wrap = coat->wrap, shape.aspect = coat->aspect;
    shape.side = std::max(coat ? coat->facet : 0.02, 4 * detail.grain);
    add(CopyPart::Kind::wood, 0, 0, tube_surface(thinned(model.skeleton, 0.4f * fine, 0.5f * fine), shape));
  }
  CopyDetail each = detail;
  std::size_t shapes = 0;
  for (const Prototype& prototype : model.prototypes) shapes += prototype.parts.size();
  each.leaves /= static_cast<double>(std::max<std::size_t>(1, shapes));
  for (std::size_t p = 0; p < model.prototypes.size(); ++p) {
    std::vector<Surface> merged = merged_organs(model, p, each);
    for (std::size_t k = 0; k < merged.size(); ++k) add(CopyPart::Kind::organ, p, k, std::move(merged[k]));
  }
  add(CopyPart::Kind::blade, 0, 0, model.blades.surface);
  for (std::size_t s = 0; s < model.solids.shapes.size(); ++s)
    add(CopyPart::Kind::solid, s, 0, merged_solid(model.solids, s));
  return parts;
}

namespace {

template <class T>
const T* held(const T& value) {
  return &value;
}
template <class T>
const T* held(const std::optional<T>& value) {
  return value ? &*value : nullptr;
}

/// What `get` finds in the parameters of an organism or in what it wears; nullptr where they have no such
/// thing.
template <class Get>
auto found(const Organism& organism, Get get) {
  return std::visit(
      [&](const auto& params) -> decltype(get(TreeParams{})) {
        if constexpr (requires { params.dress; })
          return get(params.dress);
        else if constexpr (requires { get(params); })
          return get(params);
        return nullptr;
      },
      organism.body);
}

}  // namespace

const BarkCoat* coat_of(const Organism& organism) {
  return found(
      organism, [](const auto& p) requires requires { p.coat; } { return held(p.coat); });
}

const Bark* bark_of(const Organism& organism) {
  return found(
      organism, [](const auto& p) requires requires { p.bark; } { return held(p.bark); });
}

const Wave* wave_of(const Organism& organism) {
  return found(
      organism, [](const auto& p) requires requires { p.wave; } { return held(p.wave); });
}

const Seasons* seasons_of(const Organism& organism) {
  return found(
      organism, [](const auto& p) requires requires { p.season; } { return held(p.season); });
}

}  // namespace frond
