#include "geometry/polygon_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <tuple>

#include "core/bounds.h"
#include "core/joined_sets.h"
#include "geometry/crease.h"
#include "geometry/polygon.h"

namespace frond {

namespace {

using Part = PolygonMesh::Part;
using Corner = PolygonMesh::Corner;

bool is_taken(const std::vector<char>& taken, std::uint32_t part) { return taken.empty() || taken[part]; }

/// A direction of the file in the world's axes.
template <class V>
V turned(const V& v, bool z_up) {
  return z_up ? V(v.x, v.z, -v.y) : v;
}

using TriangleSpan = std::span<const std::array<std::uint32_t, 3>>;

/// A piece of a mesh that hangs together.
struct MeshPiece {
  std::vector<std::uint32_t> triangles;
  double volume = 0;
  Bounds box;
  bool closed = false, turned = false;
};

/// For each vertex the first at the same place.
std::vector<std::uint32_t> welded(std::span<const Vec3> position) {
  std::vector<std::uint32_t> order(position.size()), first(position.size());
  std::iota(order.begin(), order.end(), 0u);
  auto key = [&](std::uint32_t i) { return std::tuple(position[i].x, position[i].y, position[i].z, i); };
  std::ranges::sort(order, [&](auto a, auto b) { return key(a) < key(b); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    bool same = k > 0 && position[order[k]] == position[order[k - 1]];
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  return first;
}

/// Whether each edge is run as often one way as the other.
bool is_closed(const MeshPiece& piece, TriangleSpan triangles, const std::vector<std::uint32_t>& vertex) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, int>> edges;
  for (std::uint32_t t : piece.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t a = vertex[triangles[t][k]], b = vertex[triangles[t][(k + 1) % 3]];
      edges.emplace_back(std::min(a, b), std::max(a, b), a < b ? 1 : -1);
    }
  std::ranges::sort(edges);
  for (std::size_t i = 0; i < edges.size();) {
    int sum = 0;
    auto [low, high, way] = edges[i];
    for (; i < edges.size() && std::get<0>(edges[i]) == low && std::get<1>(edges[i]) == high; ++i)
      sum += std::get<2>(edges[i]);
    if (sum != 0) return false;
  }
  return true;
}

/// The pieces that some of the triangles make up where vertices are those of a list.
std::vector<MeshPiece> pieces_of(std::span<const Vec3> position, TriangleSpan triangles,
                                 const std::vector<std::uint32_t>& which,
                                 const std::vector<std::uint32_t>& vertex) {
  JoinedSets joined(position.size());
  for (std::uint32_t t : which)
    for (std::size_t k = 1; k < 3; ++k) joined.join(vertex[triangles[t][0]], vertex[triangles[t][k]]);
  std::map<std::uint32_t, std::size_t> known;
  std::vector<MeshPiece> pieces;
  for (std::uint32_t t : which) {
    auto [place, fresh] = known.try_emplace(joined.top(vertex[triangles[t][0]]), pieces.size());
    if (fresh) pieces.emplace_back();
    pieces[place->second].triangles.push_back(t);
  }
  for (MeshPiece& piece : pieces) {
    DVec3 middle(position[triangles[piece.triangles[0]][0]]);
    for (std::uint32_t t : piece.triangles) {
      auto at = [&](std::size_t k) { return DVec3(position[triangles[t][k]]) - middle; };
      piece.volume += glm::dot(at(0), glm::cross(at(1), at(2)));
      for (std::uint32_t v : triangles[t]) piece.box.extend(position[v]);
    }
    piece.closed = is_closed(piece, triangles, vertex);
  }
  return pieces;
}

bool holds(const Bounds& outer, const Bounds& inner) {
  return glm::all(glm::lessThan(outer.low, inner.low)) && glm::all(glm::greaterThan(outer.high, inner.high));
}

/// Which triangles of a mesh look inward, and are to be turned over: those of closed pieces that enclose
/// their volume from behind, as after a mirroring. A piece inside the box of a larger one, which may be a
/// hollow in it, is turned over if that one is. Pieces hang together by their vertices, or, where they are
/// open so, by vertices at one place. Open pieces stay as they are.
std::vector<char> inward(std::span<const Vec3> position, TriangleSpan triangles) {
  std::vector<std::uint32_t> vertex(position.size()), left(triangles.size());
  std::iota(vertex.begin(), vertex.end(), 0u);
  std::iota(left.begin(), left.end(), 0u);
  std::vector<MeshPiece> closed;
  for (bool weld : {false, true}) {
    if (left.empty()) break;
    if (weld) vertex = welded(position);
    std::vector<std::uint32_t> open;
    for (MeshPiece& piece : pieces_of(position, triangles, left, vertex))
      if (piece.closed)
        closed.push_back(std::move(piece));
      else
        open.insert(open.end(), piece.triangles.begin(), piece.triangles.end());
    left = std::move(open);
  }
  std::ranges::stable_sort(
      closed, [](const MeshPiece& a, const MeshPiece& b) { return std::abs(a.volume) > std::abs(b.volume); });
  constexpr std::size_t kMostOuter = 64;  // the largest, which others may lie in
  std::vector<char> turned(triangles.size(), 0);
  for (std::size_t i = 0; i < closed.size(); ++i) {
    auto larger = std::span(closed).first(std::min(i, kMostOuter));
    auto outer =
        std::ranges::find_if(larger, [&](const MeshPiece& other) { return holds(other.box, closed[i].box); });
    closed[i].turned = outer != larger.end() ? outer->turned : closed[i].volume < 0;
    if (closed[i].turned)
      for (std::uint32_t t : closed[i].triangles) turned[t] = 1;
  }
  return turned;
}

/// A triangle by the corners of its polygon.
struct Cut {
  std::array<Corner, 3> corner;
  std::uint32_t part = 0;
  bool reversed = false;  // its normals look the other way

  void turn_over() { std::swap(corner[1], corner[2]); }
};

class Cutter {
 public:
  Cutter(const PolygonMesh& mesh, const MeshFrame& frame, const std::string& name)
      : mesh_(mesh), frame_(frame), name_(name) {
    for (const DVec3& p : mesh.place)
      place_.emplace_back(turned((p - frame.origin) * frame.scale, frame.z_up));
  }

  Result<PartedSurface> result() {
    for (const PolygonMesh::Face& face : mesh_.face)
      if (is_taken(frame_.taken, face.part) && !cut(face))
        return Error{
            face.line > 0 ? fmt::format("{}:{}", name_, face.line) : name_,
            fmt::format("a face of {} corners crosses itself; expected it in simpler ones", face.count)};
    if (cuts_.empty()) return Error{name_, "holds no face that could be drawn"};
    turn_outward();
    PartedSurface made;
    bool complete = has_normals();
    made.normals_kept = !complete || normals_fit();
    build(made, complete && made.normals_kept);
    return made;
  }

 private:
  /// Cuts a polygon into triangles; false if that cannot be done.
  bool cut(const PolygonMesh::Face& face) {
    points_.clear(), triangles_.clear();
    for (std::uint32_t i = 0; i < face.count; ++i)
      points_.push_back(mesh_.place[mesh_.corner[face.first + i].place]);
    if (!triangulate_polygon(points_, triangles_)) return false;
    for (auto [a, b, c] : triangles_) {
      Cut cut{{mesh_.corner[face.first + a], mesh_.corner[face.first + b], mesh_.corner[face.first + c]},
              face.part};
      Vec3 area = area_of(cut);
      if (float square = glm::dot(area, area); square > 0 && std::isfinite(square)) cuts_.push_back(cut);
    }
    return true;
  }

  Vec3 area_of(const Cut& cut) const {
    Vec3 a = place_[cut.corner[0].place];
    return glm::cross(place_[cut.corner[1].place] - a, place_[cut.corner[2].place] - a);
  }

  Vec3 normal_of(const Cut& cut, std::size_t corner) const {
    Vec3 n = turned(mesh_.normal[cut.corner[corner].normal], frame_.z_up);
    float length = glm::length(n);
    return n / (cut.reversed ? -length : length);
  }

  void turn_outward() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const Cut& cut : cuts_)
      triangles.push_back({cut.corner[0].place, cut.corner[1].place, cut.corner[2].place});
    std::vector<char> in = inward(place_, triangles);
    bool normals = has_normals();
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      if (!in[i]) continue;
      cuts_[i].turn_over();
      if (normals && agreement(cuts_[i]) < 0) cuts_[i].reversed = true;
    }
  }

  bool has_normals() const {
    return std::ranges::all_of(cuts_, [&](const Cut& cut) {
      return std::ranges::all_of(cut.corner, [&](const Corner& corner) {
        if (corner.normal < 0) return false;
        float length = glm::length(mesh_.normal[corner.normal]);
        return length > 0 && std::isfinite(length);
      });
    });
  }

  /// By how much of its area more corners of a triangle look to its front than to its back.
  double agreement(const Cut& cut) const {
    Vec3 area = area_of(cut);
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += glm::dot(normal_of(cut, k), area) > 0 ? 1 : -1;
    return sum * glm::length(area);
  }

  /// Whether the normals are those of the faces. What is open and mirrored is turned over to them.
  bool normals_fit() {
    double against = 0, all = 0;
    for (const Cut& cut : cuts_) {
      double area = 3 * glm::length(area_of(cut)), with = agreement(cut);
      all += area, against += (area - with) / 2;
    }
    if (against > 0.99 * all) {
      for (Cut& cut : cuts_) cut.turn_over();
      return true;
    }
    return against < 0.01 * all;
  }

  /// What is painted at a corner.
  Vec3 paint_of(const Corner& corner) const {
    Vec3 paint = kUnpainted;
    if (corner.texture >= 0) {
      Vec2 at = mesh_.texture[corner.texture];
      paint.x = at.x, paint.y = at.y;
    }
    if (!mesh_.color.empty())
      paint.z = std::clamp(glm::dot(mesh_.color[corner.place], Vec3(0.2126f, 0.7152f, 0.0722f)), 0.0f, 1.0f);
    return paint;
  }

  void build(PartedSurface& made, bool with_normals) const {
    Surface& surface = made.surface;
    std::map<std::tuple<std::uint32_t, std::int32_t, bool>, std::uint32_t> known;
    bool painted = !mesh_.texture.empty() || !mesh_.color.empty();
    for (const Cut& cut : cuts_) {
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner& corner = cut.corner[k];
        auto [place, fresh] =
            known.try_emplace({corner.place, with_normals ? corner.normal : -1, with_normals && cut.reversed},
                              static_cast<std::uint32_t>(surface.position.size()));
        triangle[k] = place->second;
        if (!fresh) continue;
        surface.position.push_back(place_[corner.place]);
        surface.normal.push_back(with_normals ? normal_of(cut, k) : Vec3(0, 1, 0));
      }
      surface.triangle.push_back(triangle);
      made.part.push_back(cut.part);
      if (painted)
        surface.paint.push_back({paint_of(cut.corner[0]), paint_of(cut.corner[1]), paint_of(cut.corner[2])});
    }
    // Between faces: what is built keeps its edges, what has grown is round.
    constexpr double kSharp = 40;
    if (!with_normals) surface = creased(surface, radians(kSharp));
  }

  const PolygonMesh& mesh_;
  const MeshFrame& frame_;
  const std::string& name_;
  std::vector<Vec3> place_;
  std::vector<Cut> cuts_;
  std::vector<DVec3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

std::uint32_t PolygonMesh::part_of(const Part& wanted) {
  auto found = std::find(part.rbegin(), part.rend(), wanted);  // most often the last ones
  if (found != part.rend()) return static_cast<std::uint32_t>(part.rend() - found - 1);
  part.push_back(wanted);
  return static_cast<std::uint32_t>(part.size() - 1);
}

bool PolygonMesh::bears(std::uint32_t which, const std::string& name) const {
  const Part& p = part[which];
  if (name.empty()) return false;
  return p.object == name || p.group == name || (p.material >= 0 && material[p.material].name == name);
}

std::vector<std::string> PolygonMesh::names() const {
  std::vector<std::string> names;
  auto add = [&](const std::string& name) {
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  std::vector<char> used(part.size(), 0);
  for (const Face& f : face) used[f.part] = 1;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (!used[i]) continue;
    add(part[i].object), add(part[i].group);
    if (part[i].material >= 0) add(material[part[i].material].name);
  }
  return names;
}

Result<PartedSurface> parted_surface(const PolygonMesh& mesh, const MeshFrame& frame,
                                     const std::string& name) {
  return Cutter(mesh, frame, name).result();
}

MeshBox box_of(const PolygonMesh& mesh, const std::vector<char>& taken) {
  MeshBox box;
  for (const PolygonMesh::Face& face : mesh.face) {
    if (!is_taken(taken, face.part)) continue;
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const DVec3& p = mesh.place[mesh.corner[face.first + i].place];
      box.low = box.empty ? p : glm::min(box.low, p);
      box.high = box.empty ? p : glm::max(box.high, p);
      box.empty = false;
    }
  }
  return box;
}

}  // namespace frond
