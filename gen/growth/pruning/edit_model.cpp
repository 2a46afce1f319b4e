#include <algorithm>
#include <array>
#include <cmath>

#include "core/keep.h"
#include "foliage/organ_shapes.h"
#include "pruning/edits.h"

namespace frond {

namespace {

constexpr const char* kSawn = "sawn";      // the prototype of wounds
constexpr float kThinnestWound = 0.0012f;  // metres of radius
const Color kRim{0.33f, 0.26f, 0.2f}, kSawnWood{0.62f, 0.47f, 0.31f};

/// A sawn end, a unit in radius and as high, for the round end of a branch to be in it: bark up to the rim,
/// and the face of the wood, slightly sunk.
Prototype sawn_shape() {
  constexpr int kSides = 20;
  using Profile = std::array<float, 5>;
  auto turned = [&](const Profile& profile, const Profile& at) {
    Surface s = turned_surface(profile, kSides);
    for (std::size_t i = 0; i < s.position.size(); ++i) s.position[i].y = at[i / (kSides + 1)];
    set_normals(s);
    return s;
  };
  Surface bark = turned({0.98f, 1.01f, 1.0f, 0.97f, 0.9f}, {-0.1f, 0.4f, 0.9f, 1.0f, 1.03f}),
          face = turned({0.91f, 0.6f, 0.3f, 0.1f, 0.0f}, {1.03f, 1.01f, 1.01f, 1.015f, 1.015f});
  return {kSawn, {{Tissue::skin, std::move(bark)}, {Tissue::heart, std::move(face)}}, {kRim}, kSawnWood};
}

/// Leaves out the blades that do not `stay`, with their points.
void keep_blades(Blades& b, const std::vector<std::uint8_t>& stay) {
  if (b.size() == 0) return;
  std::vector<std::uint8_t> stay_point(b.surface.position.size());
  std::vector<std::uint32_t> first{0}, point(stay_point.size());
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (std::uint32_t v = b.first[i]; v < b.first[i + 1]; ++v) stay_point[v] = stay[i];
    if (stay[i]) first.push_back(first.back() + b.first[i + 1] - b.first[i]);
  }
  std::uint32_t next = 0;
  for (std::size_t v = 0; v < point.size(); ++v) {
    point[v] = next;
    next += stay_point[v];
  }
  std::erase_if(b.surface.triangle, [&](const auto& t) { return !stay_point[t[0]]; });
  for (auto& triangle : b.surface.triangle)
    for (auto& corner : triangle) corner = point[corner];
  keep(stay_point, b.surface.position, b.surface.normal, b.surface.uv);
  keep(stay, b.node, b.birth, b.color, b.id, b.foot);
  b.first = std::move(first);
}

/// For each node, the share of its segment, 0..1, from which on it is bare; above 1: it is bare nowhere.
std::vector<float> bare_from(const Model& model, std::span<const Edit> edits) {
  const std::vector<std::int32_t>& parent = model.skeleton.parent;
  const std::vector<AxisNode> axes = axis_nodes(model);
  const Branching plant{parent, axes};
  const std::vector<std::int32_t> starts = axis_starts(plant);
  std::vector<float> from(parent.size(), 2);
  for (const Edit& edit : edits) {
    if (!edit.bare) continue;
    Result<BranchPlace> place = find_place(plant, starts, edit.at);
    if (!place) continue;
    const float within = std::min(from[place->node], place->within);
    for_beyond(parent, place->node, [&](std::size_t i) { from[i] = 0; });
    from[place->node] = within;
  }
  return from;
}

/// A model and what becomes of its nodes.
class ModelEditor {
 public:
  ModelEditor(Model& model, const Reshaped& to) : m_(model), to_(to), rest_(model.skeleton.position) {
    end_.assign(rest_.size(), 1);
    for (const CutEnd& end : to.ends) end_[end.node] = end.within;
  }

  void edit() {
    carry_organs();
    carry_blades();
    shape_skeleton();
    drop_nodes();
    for (const CutEnd& end : to_.ends) {
      const std::int32_t node = moved_[end.node];
      const Skeleton& s = m_.skeleton;
      if (s.parent[node] == Skeleton::kRoot) continue;
      add_cut_face(m_, node, s.position[node] - s.position[s.parent[node]],
                   static_cast<std::uint32_t>(end.node));
    }
  }

 private:
  /// Where a point goes that is attached to a node.
  Vec3 carried(Vec3 at, std::int32_t node) const {
    return to_.position[node] + to_.turn[node] * ((at - rest_[node]) * to_.factor[node]);
  }

  /// Whether what is attached to a node stays.
  bool stays(std::int32_t node, Vec3 at) const {
    if (node == Skeleton::kRoot) return true;
    if (to_.gone[node]) return false;
    const std::int32_t p = m_.skeleton.parent[node];
    if (end_[node] >= 1 && std::ranges::find(to_.ends, node, &CutEnd::node) == to_.ends.end()) return true;
    if (p == Skeleton::kRoot) return false;
    const Vec3 along = rest_[node] - rest_[p];
    const float length2 = glm::dot(along, along);
    return length2 > 0 && glm::dot(at - rest_[p], along) / length2 < end_[node];
  }

  void carry_organs() {
    Organs& o = m_.organs;
    std::vector<std::uint8_t> stay(o.size());
    for (std::size_t i = 0; i < o.size(); ++i) {
      const std::int32_t node = o.node[i];
      stay[i] = stays(node, o.position[i]);
      if (!stay[i] || node == Skeleton::kRoot) continue;
      o.position[i] = carried(o.position[i], node);
      if (to_.turn[node] != Quat(1, 0, 0, 0)) o.turn[i] = glm::normalize(to_.turn[node] * o.turn[i]);
    }
    keep(stay, o.prototype, o.position, o.turn, o.scale, o.node, o.birth, o.color, o.id, o.loose, o.supple);
  }

  void carry_blades() {
    Blades& b = m_.blades;
    if (b.size() == 0) return;
    std::vector<std::uint8_t> stay(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
      const std::int32_t node = b.node[i];
      stay[i] = stays(node, b.foot[i]);
      const Vec3 foot = b.foot[i];
      if (stay[i] && node != Skeleton::kRoot) b.foot[i] = carried(foot, node);
      for (std::uint32_t v = b.first[i]; v < b.first[i + 1]; ++v) {
        if (!stay[i] || node == Skeleton::kRoot) continue;
        b.surface.position[v] = b.foot[i] + to_.turn[node] * (b.surface.position[v] - foot);
        if (!b.surface.normal.empty()) b.surface.normal[v] = to_.turn[node] * b.surface.normal[v];
      }
    }
    keep_blades(b, stay);
  }

  void shape_skeleton() {
    Skeleton& s = m_.skeleton;
    m_.axes = axis_nodes(m_);
    s.position = to_.position;
    bool stretched = false;
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (to_.factor[i] == 1) continue;
      s.radius[i] *= to_.factor[i];
      if (!m_.girth.empty()) m_.girth[i] *= to_.factor[i];
      stretched = true;
    }
    if (stretched) {
      set_distances(s);
      set_tip_distances(s);
    }
    for (const CutEnd& end : to_.ends) shorten(end);
  }

  /// Shortens the last segment of what was cut.
  void shorten(CutEnd end) {
    Skeleton& s = m_.skeleton;
    const std::int32_t i = end.node, p = s.parent[i];
    if (p == Skeleton::kRoot) return;
    auto cut = [&](std::vector<float>& list) {
      if (!list.empty()) list[i] = glm::mix(list[p], list[i], end.within);
    };
    s.position[i] = to_.end(s.parent, end);
    cut(s.distance);
    cut(s.birth);
    cut(s.to_tip);
    if (m_.axes[i].number == 0) {
      cut(s.radius);
      cut(m_.girth);
    }
    const float below = m_.axes[i].number == 0 ? m_.axes[p].share : 0;
    m_.axes[i].share = glm::mix(below, m_.axes[i].share, end.within);
  }

  void drop_nodes() {
    Skeleton& s = m_.skeleton;
    std::vector<std::uint8_t> stay(s.size());
    moved_.assign(s.size(), Skeleton::kRoot);
    std::int32_t next = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      stay[i] = !to_.gone[i];
      if (stay[i]) moved_[i] = next++;
    }
    keep(stay, s.position, s.radius, s.parent, s.distance, s.to_tip, s.birth, s.order);
    keep(stay, m_.color, m_.girth, m_.light, m_.axes);
    auto renumber = [&](std::vector<std::int32_t>& nodes) {
      for (std::int32_t& node : nodes)
        if (node != Skeleton::kRoot) node = moved_[node];
    };
    renumber(s.parent);
    renumber(m_.organs.node);
    renumber(m_.blades.node);
  }

  Model& m_;
  const Reshaped& to_;
  const std::vector<Vec3> rest_;
  std::vector<float> end_;           // of each segment, the share that is left
  std::vector<std::int32_t> moved_;  // of each node, its new place
};

}  // namespace

void add_cut_face(Model& model, std::int32_t node, Vec3 direction, std::uint32_t id, float open) {
  if (model.skeleton.radius[node] * open < kThinnestWound || glm::length(direction) < 1e-7f) return;
  auto at = std::ranges::find(model.prototypes, kSawn, &Prototype::name);
  const auto prototype = static_cast<std::uint16_t>(at - model.prototypes.begin());
  const float radius = model.skeleton.radius[node];
  // The face lies where the cut is, and the round end of the branch behind it.
  model.skeleton.position[node] -=
      std::min(radius, 0.5f * glm::length(direction)) * glm::normalize(direction);
  if (at == model.prototypes.end()) model.prototypes.push_back(sawn_shape());
  Organs& o = model.organs;
  o.prototype.push_back(prototype);
  o.position.push_back(model.skeleton.position[node]);
  o.turn.push_back(glm::normalize(Quat(Vec3(0, 1, 0), glm::normalize(direction))));
  o.scale.push_back(radius * Vec3(open, std::sqrt(open), open));
  o.node.push_back(node);
  o.birth.push_back(model.skeleton.birth[node]);
  o.color.push_back(0);
  o.id.push_back(id);
  if (!o.loose.empty()) o.loose.push_back(0);
  if (!o.supple.empty()) o.supple.push_back(0);
}

std::vector<float> edit_model(Model& model, std::span<const Edit> edits, std::span<const float> levers) {
  if (edits.empty()) return {};
  const std::vector<AxisNode> axes = axis_nodes(model);
  Reshaped to =
      reshape({model.skeleton.parent, axes}, model.skeleton.position, model.skeleton.radius, edits, levers);
  model.notes.insert(model.notes.end(), to.notes.begin(), to.notes.end());
  strip_model(model, edits);
  if (to.any) ModelEditor(model, to).edit();
  return to.levers;
}

void strip_model(Model& model, std::span<const Edit> edits) {
  if (std::ranges::none_of(edits, &Edit::bare)) return;
  const Skeleton& s = model.skeleton;
  const std::vector<float> from = bare_from(model, edits);
  auto stays = [&](std::int32_t node, Vec3 at) -> std::uint8_t {
    if (node == Skeleton::kRoot || from[node] > 1) return true;
    if (from[node] <= 0 || s.parent[node] == Skeleton::kRoot) return false;
    const Vec3 foot = s.position[s.parent[node]], along = s.position[node] - foot;
    const float length2 = glm::dot(along, along);
    return length2 > 0 && glm::dot(at - foot, along) / length2 < from[node];
  };
  Organs& o = model.organs;
  std::vector<std::uint8_t> stay(o.size());
  for (std::size_t i = 0; i < o.size(); ++i)
    stay[i] = model.prototypes[o.prototype[i]].name == kSawn || stays(o.node[i], o.position[i]);
  keep(stay, o.prototype, o.position, o.turn, o.scale, o.node, o.birth, o.color, o.id, o.loose, o.supple);
  Blades& b = model.blades;
  stay.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) stay[i] = stays(b.node[i], b.foot[i]);
  keep_blades(b, stay);
}

void color_barks(Model& model, std::span<const Edit> edits, std::size_t colors) {
  if (std::ranges::none_of(edits, [](const Edit& edit) { return edit.bark.has_value(); })) return;
  const std::vector<std::int32_t>& parent = model.skeleton.parent;
  const std::vector<AxisNode> axes = axis_nodes(model);
  const Branching plant{parent, axes};
  const std::vector<std::int32_t> starts = axis_starts(plant);
  model.color.resize(parent.size());
  // An index goes round and round among the plant's own colours, which are no longer all.
  for (std::int32_t& color : model.color) color = static_cast<std::int32_t>(color_index(color, colors));
  auto next = static_cast<std::int32_t>(colors);
  for (const Edit& edit : edits) {
    if (!edit.bark) continue;
    const std::int32_t own = next++;
    Result<BranchPlace> place = find_place(plant, starts, edit.at);
    if (!place) continue;
    // A segment is of one colour: that of the larger part of it.
    const std::int32_t kept = model.color[place->node];
    for_beyond(parent, place->node, [&](std::size_t i) { model.color[i] = own; });
    if (place->within >= 0.5f) model.color[place->node] = kept;
  }
}

}  // namespace frond
