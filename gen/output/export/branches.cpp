#include <algorithm>
#include <array>
#include <cmath>

#include "core/bounds.h"
#include "export/parts.h"
#include "export/surfaces.h"
#include "geometry/far.h"
#include "geometry/tubes.h"

namespace frond {

namespace {

constexpr double kFirstGrain = 1.0 / 6000, kCoarserGrain = 1.4;  // of its size, where branches are too many
constexpr double kLastGrain = 0.05;
constexpr double kRootTriangles = 40;  // of a root at the foot, at most
constexpr double kMostStretch = 1.41;  // of a bark's height along a branch, and of its inverse

/// Lets a bark go as far along twigs as along the trunk, within a factor of two; along its own circumference,
/// which a picture goes whole times round, it would be a hundred times smaller there.
void keep_bark_long(TubeMesh& mesh, const Skeleton& rest, const TubeShape& shape) {
  std::vector<float> factor(rest.size(), 1);
  auto n = static_cast<std::int32_t>(rest.size());
  for (std::int32_t first = 0, last = 0; first < n; first = last + 1) {
    for (last = first; last + 1 < n && rest.parent[last + 1] == last;) ++last;
    double thick = 0;
    for (std::int32_t i = first; i <= last; ++i)
      thick = std::max(thick, static_cast<double>(shape.girth.empty() ? rest.radius[i] : shape.girth[i]));
    double round = 2 * kPi * thick, usual = shape.wrap * shape.aspect;
    double own = round / std::max(1.0, std::round(round / shape.wrap)) * shape.aspect;
    double wanted = std::clamp(own, usual / kMostStretch, usual * kMostStretch);
    std::fill(factor.begin() + first, factor.begin() + last + 1, static_cast<float>(own / wanted));
  }
  for (std::size_t v = 0; v < mesh.node.size(); ++v)
    mesh.surface.uv[v].y *= factor[static_cast<std::size_t>(mesh.node[v])];
}

/// How much more light than the darkest the cube gives back that holds a place, in sides.
Vec3 brightness_at(Vec3 at) {
  Vec3 cube = glm::floor(at + 0.5f);
  Seed seed = Seed{34};
  for (int axis = 0; axis < 3; ++axis)
    seed = seed.child(static_cast<std::uint64_t>(static_cast<std::int64_t>(cube[axis])));
  return Vec3(static_cast<float>((185 + seed.unit() * 70) / 255));
}

/// For each node, whether it is of a root that runs out from the foot: as low as the foot is thick, and
/// short.
std::vector<char> roots_of(const Skeleton& s) {
  constexpr float kReach = 4;  // radii of the foot
  std::vector<char> roots(s.size(), 0);
  auto n = static_cast<std::int32_t>(s.size());
  for (std::int32_t first = 0, last = 0; first < n; first = last + 1) {
    for (last = first; last + 1 < n && s.parent[last + 1] == last;) ++last;
    std::int32_t foot = s.parent[first];
    if (foot == Skeleton::kRoot || s.parent[foot] != Skeleton::kRoot) continue;
    bool low = true;
    for (std::int32_t i = first; i <= last; ++i) {
      Vec3 from = s.position[i] - s.position[foot];
      low = low && from.y < s.radius[foot] && glm::length(from) < kReach * s.radius[foot];
    }
    std::fill(roots.begin() + first, roots.begin() + last + 1, low);
  }
  return roots;
}

/// Makes the branches of one organism.
class Brancher {
 public:
  Brancher(Maker& maker, const DrawnBranches& b, double triangles)
      : maker_(maker), options_(maker.options), b_(b), pose_(b.pose), most_(triangles) {}

  Result<std::vector<BranchPart>> parts() {
    if (b_.form() != BranchForm::body) {
      TubeMesh mesh = b_.form() == BranchForm::coat ? coated() : tubes();
      return finished(by_color(std::move(mesh.surface), mesh.node));
    }
    Result<FusedMesh> mesh = b_.body();
    if (!mesh) return mesh.errors();
    // Programs and files that tell places apart by fewer digits would find faces without area, and edges of
    // four faces.
    if (b_.traits.style.build != Build::voxels)
      join_short_edges(mesh->surface, mesh->node, shortest_edge(b_.traits.style.voxel));
    return finished(by_color(std::move(mesh->surface), mesh->node));
  }

 private:
  /// Gives the parts their materials, and what is fused its places on pictures.
  std::vector<BranchPart> finished(std::vector<BranchPart> parts) {
    std::string name = maker_.name() + "_branches";
    bool cubes = b_.traits.style.build == Build::voxels;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      auto& [part, node] = parts[k];
      if (part.surface.triangle.empty()) continue;
      Palette::Use use =
          cubes ? maker_.palette.cubes(b_.look(), b_.traits.brightness, k, b_.traits.style.voxel, name)
                : maker_.palette.branches(b_.traits.look, b_.traits.brightness, k, name, options_.tints);
      part.material = use.material;
      if (b_.traits.style.build != Build::sweeps) {
        std::vector<std::uint32_t> from;
        part.surface = box_mapped(part.surface, &from);
        std::vector<std::int32_t> of;
        for (std::uint32_t v : from) of.push_back(node[v]);
        node = std::move(of);
        double side = b_.traits.style.voxel;
        cubes ? lay_picture(part.surface, side, side, Vec2(0.5f))
              : lay_picture(part.surface, use.wide, use.high);
      }
      add_tints(parts[k], use);
    }
    return parts;
  }

  /// Tips are paler, and cubes differ a little.
  void add_tints(BranchPart& branch, const Palette::Use& use) {
    bool cubes = b_.traits.style.build == Build::voxels;
    const std::vector<float>& light = b_.model.light;
    bool shaded = options_.tints && !light.empty();
    if (use.young == Vec3(1) && !cubes && !shaded) return;
    double young = b_.look().young_length();
    const Surface& s = branch.part.surface;
    float longest = b_.rest().longest();
    for (std::size_t v = 0; v < s.position.size(); ++v) {
      float age = youth(b_.rest(), pose_, longest, static_cast<float>(young), branch.node[v]);
      Vec3 tint = use.tint_at(age);
      if (shaded) tint *= starved(light[static_cast<std::size_t>(branch.node[v])], b_.look().albedo());
      // The middle of the cube tells its brightness: half a side below the face, less than that from a
      // corner.
      if (cubes)
        tint *= brightness_at(s.position[v] / static_cast<float>(b_.traits.style.voxel) - 0.5f * s.normal[v]);
      branch.part.tint.push_back(tint_of(tint));
    }
  }

  /// Branches with less in them until they have so few triangles; a skeleton that still grows stays as it is.
  /// mesh_of(skeleton, grain, step) makes a mesh of as much as a grain leaves, in the step so many.
  template <class Mesh>
  TubeMesh fitting(const Mesh& mesh_of) {
    Skeleton posed = b_.rest();
    posed.position = pose_.position;
    posed.radius = pose_.radius;
    TubeMesh made = mesh_of(posed, 0.0f, 0.0);
    if (pose_.front <= 1 || posed.size() < 2) return made;
    double size = glm::length(bounds_of(posed.position).size());
    double first = size * (options_.pixels > 0 ? 1 / options_.pixels : kFirstGrain);
    auto grain_of = [&](double step) { return first * std::pow(kCoarserGrain, step - 1); };
    // Thin roots stay with the stem, as nodes of order 0 do: without them its foot would be half as wide.
    // They are few, and taken from nothing: a stem of few triangles would become flat.
    Skeleton rooted = posed;
    std::vector<char> roots = roots_of(posed);
    double room = 0;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      if (!roots[i]) continue;
      rooted.order[i] = 0;
      if (posed.parent[i] != static_cast<std::int32_t>(i) - 1 || !roots[i - 1]) room += kRootTriangles;
    }
    most_ += room, maker_.spare += room;
    auto thinner = [&](double step) {
      std::vector<std::int32_t> kept;
      auto grain = static_cast<float>(grain_of(step));
      Skeleton less = thinned(rooted, 0.4f * grain, 0.5f * grain, &kept);
      for (std::size_t i = 0; i < kept.size(); ++i)
        less.order[i] = posed.order[static_cast<std::size_t>(kept[i])];
      TubeMesh mesh = mesh_of(less, grain, step);
      for (std::int32_t& node : mesh.node) node = kept[static_cast<std::size_t>(node)];
      return mesh;
    };
    auto fits = [&](const TubeMesh& mesh) {
      return static_cast<double>(mesh.surface.triangle.size()) <= most_;
    };
    double step = 0;
    while ((!fits(made) || (step == 0 && options_.pixels > 0)) && grain_of(step + 1) < kLastGrain * size)
      made = thinner(++step);
    // A level of detail comes near to its share.
    for (double back = 0.5; maker_.level > 0 && step > 0 && fits(made) && back > 0.1; back /= 2)
      if (TubeMesh more = thinner(step - back); fits(more)) made = std::move(more), step -= back;
    return made;
  }

  TubeMesh coated() {
    TubeShape shape = b_.look().tube_shape();
    shape.least = 0;
    double facet = shape.side;
    return fitting([&](const Skeleton& posed, float grain, double) {
      if (grain == 0) {
        shape.girth = b_.model.girth;
        TubeMesh whole = tube_mesh(b_.rest(), pose_.position, pose_.radius, pose_.turn, shape);
        keep_bark_long(whole, b_.rest(), shape);
        return whole;
      }
      shape.girth = {};
      shape.side = std::max(facet, 4.0 * static_cast<double>(grain));
      TubeMesh thin = tube_mesh(posed, posed.position, posed.radius, {}, shape);
      keep_bark_long(thin, posed, shape);
      return thin;
    });
  }

  TubeMesh tubes() {
    return fitting([&](const Skeleton& posed, float grain, double step) {
      if (grain == 0) return wrapped(b_.rest(), pose_.position, pose_.radius, pose_.front, options_.sides);
      int sides = std::max(std::min(options_.sides, maker_.level > 0 ? 3 : 5),
                           options_.sides - static_cast<int>(std::ceil(step)));
      std::vector<float> radius = posed.radius;
      // Tubes of few sides are as wide as they were round, as a mean of all sides.
      if (maker_.level > 0)
        for (float& r : radius) r *= static_cast<float>(kPi / sides / std::sin(kPi / sides));
      return wrapped(posed, posed.position, radius, 2, sides);
    });
  }

  /// Closed tubes, a picture going a whole number of times round each branch.
  TubeMesh wrapped(const Skeleton& rest, const std::vector<Vec3>& position, const std::vector<float>& radius,
                   float front, int sides) {
    TubeMesh mesh = closed_tubes(rest, position, radius, front, sides);
    std::vector<std::pair<double, double>> sizes;
    for (std::size_t k = 0; k < b_.look().colors(); ++k) sizes.push_back(Palette::picture_size(b_.look(), k));
    // A skeleton that was thinned does not know its colours; there pictures are as large as the plant's own.
    bool known = !b_.look().others.empty() && &rest == &b_.rest();
    auto size_at = [&](std::int32_t node) { return sizes[known ? b_.look().color_at(b_.model, node) : 0]; };
    std::vector<float> wraps(rest.size(), 1);
    for (std::size_t i = 1; i < rest.size(); ++i) {
      bool goes_on =
          rest.parent[i] == static_cast<std::int32_t>(i) - 1 && rest.parent[i - 1] != Skeleton::kRoot;
      wraps[i] =
          goes_on
              ? wraps[i - 1]
              : static_cast<float>(std::max(1.0, std::round(2 * kPi * static_cast<double>(rest.radius[i]) /
                                                            size_at(static_cast<std::int32_t>(i)).first)));
    }
    for (std::size_t v = 0; v < mesh.node.size(); ++v) {
      Vec2& at = mesh.surface.uv[v];
      at = {at.x * wraps[static_cast<std::size_t>(mesh.node[v])],
            at.y / static_cast<float>(size_at(mesh.node[v]).second)};
    }
    return mesh;
  }

  /// Branches of several colours are parted by the colour of each triangle's first vertex; where edits gave
  /// some another bark, by the farthest, so that a segment of a tube is of one bark.
  std::vector<BranchPart> by_color(Surface&& surface, std::vector<std::int32_t>& node) {
    const BranchLook& look = b_.look();
    bool others = !look.others.empty();
    std::size_t colors = b_.form() == BranchForm::coat && !others ? 1 : look.colors();
    std::vector<BranchPart> parts(colors);
    if (b_.model.color.empty() || colors == 1) {
      parts[0] = {{std::move(surface)}, std::move(node)};
      return parts;
    }
    std::vector<std::vector<std::array<std::uint32_t, 3>>> triangles(colors);
    for (const auto& t : surface.triangle) {
      std::int32_t of = others ? std::max({node[t[0]], node[t[1]], node[t[2]]}) : node[t[0]];
      triangles[look.color_at(b_.model, of)].push_back(t);
    }
    for (std::size_t k = 0; k < colors; ++k) {
      std::vector<std::uint32_t> kept;
      parts[k].part.surface = with_corners_of(surface, std::move(triangles[k]), &kept);
      for (std::uint32_t v : kept) parts[k].node.push_back(node[v]);
    }
    return parts;
  }

  Maker& maker_;
  const ExportOptions& options_;
  const DrawnBranches& b_;
  const Pose& pose_;
  double most_;
};

}  // namespace

Result<std::vector<BranchPart>> branch_parts(Maker& maker, const DrawnBranches& branches, double triangles) {
  return Brancher(maker, branches, triangles).parts();
}

}  // namespace frond
