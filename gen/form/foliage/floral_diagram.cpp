#include "foliage/floral_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/seed.h"
#include "foliage/organ_shapes.h"
#include "foliage/whorl_members.h"

namespace frond {

namespace {

constexpr double kShed = 0.4;        // of withering, after which what falls has fallen
constexpr double kShrivelled = 0.8;  // the same, of stamens

bool is_blade(FloralPart part) { return part != FloralPart::stamens && part != FloralPart::carpels; }

std::vector<Color> default_colors(FloralPart part) {
  switch (part) {
    case FloralPart::sepals:
      return {{0.42f, 0.55f, 0.26f}};
    case FloralPart::tepals:
    case FloralPart::petals:
      return {{0.86f, 0.62f, 0.76f}};
    case FloralPart::stamens:
      return {{0.88f, 0.88f, 0.74f}};
    case FloralPart::carpels:
      return {{0.62f, 0.70f, 0.38f}};
  }
  return {};
}

Color default_second(FloralPart part) {
  return part == FloralPart::stamens  ? Color{0.90f, 0.74f, 0.22f}
         : part == FloralPart::sepals ? Color{0.52f, 0.62f, 0.36f}
                                      : Color{0.92f, 0.90f, 0.70f};
}

/// The side of a whorl if it has colours of its own.
const MemberSide* own_look(const Whorl& w, Side side) {
  const std::optional<MemberSide>& own = side == Side::upper  ? w.upper
                                         : side == Side::side ? w.side
                                                              : w.lower;
  return own && (!own->colors.empty() || own->second) ? &*own : nullptr;
}

/// A prototype of one part of a flower, without its shapes.
Prototype piece(const FloralDiagram& diagram, const Whorl& w, const MemberSide* own, double wither) {
  Prototype made;
  made.colors = own && !own->colors.empty() ? own->colors
                : w.colors.empty()          ? default_colors(w.part)
                                            : w.colors;
  made.second = own && own->second ? *own->second : w.second.value_or(default_second(w.part));
  made.luster = w.luster;
  if (w.part == FloralPart::sepals || w.part == FloralPart::carpels) return made;
  auto share = static_cast<float>(0.85 * wither);
  for (Color& color : made.colors) color = mixed(color, diagram.faded, share);
  made.second = mixed(made.second, diagram.faded, share);
  return made;
}

/// The blades of the members that are wanted, those of one tube with normals in common.
Surface blades_surface(const WhorlBlades& blades, const Whorl& w, const std::vector<std::size_t>& members) {
  Surface s;
  int rows = 5 * w.detail, across = w.detail + (w.detail > 1);
  double fused = std::clamp(w.fused.value_or(0), 0.0, 0.98);
  std::vector<double> places;
  int tube = fused > 0 ? std::max(2, static_cast<int>(std::lround(rows * fused))) : 0;
  for (int i = 0; i < tube; ++i) places.push_back(fused * i / tube);
  for (int i = 0, n = std::max(rows - tube, 3); i <= n; ++i)
    places.push_back(fused + (1 - fused) * (1 - std::pow(1 - static_cast<double>(i) / n, 1.3)));
  auto columns = static_cast<std::uint32_t>(2 * across + 1),
       count = static_cast<std::uint32_t>(places.size());
  for (std::size_t k : members) {
    auto start = static_cast<std::uint32_t>(s.position.size());
    for (double t : places) {
      for (int c = across; c >= -across; --c) {
        double side = static_cast<double>(c) / across;
        s.position.push_back(blades.at(k, t, side));
        s.uv.emplace_back(static_cast<float>(t), static_cast<float>(0.5 + 0.5 * side));
      }
    }
    stitch_rows(s, start, count, columns);
  }
  std::erase_if(s.triangle, [&](const auto& t) { return glm::length(area_of(s, t)) < 1e-9f; });
  set_normals(s);
  std::size_t each = static_cast<std::size_t>(count) * columns, n = members.size();
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < places.size() && places[i] <= fused && fused > 0; ++i) {
      std::size_t here = k * each + i * columns, next = ((k + 1) % n) * each + i * columns + columns - 1;
      if (glm::distance(s.position[here], s.position[next]) > 1e-4f) continue;
      Vec3 both = direction_or(s.normal[here] + s.normal[next], s.normal[here]);
      s.normal[here] = s.normal[next] = both;
    }
  }
  return s;
}

/// Spots that lie on the upper side, six corners each.
Surface marks_surface(const WhorlBlades& blades, const Marks& marks, double shown) {
  constexpr int kCorners = 6;
  constexpr double kAbove = 0.004;
  Surface s;
  for (std::size_t k = 0; k < blades.members().size(); ++k) {
    const WhorlMember& m = blades.members()[k];
    if (!(m.side == Side::upper ? marks.upper : m.side == Side::side ? marks.side : marks.lower)) continue;
    for (int i = 0; i < marks.count; ++i) {
      Seed own = Seed{0}.child("mark", static_cast<std::uint64_t>(i));
      double share = (i + own.child(0).unit()) / marks.count,
             t = marks.from + (marks.to - marks.from) * share;
      double s0 = marks.across * (2 * std::fmod(0.5 + 0.618034 * i, 1.0) - 1);
      double r = 0.5 * marks.size * own.child(1).range(0.6, 1.2) * shown;
      double wide = std::max(
          blades.rim_angle(k, t) * glm::length(Vec2(blades.at(k, t, 0).x, blades.at(k, t, 0).z)), 1e-3);
      auto first = static_cast<std::uint32_t>(s.position.size());
      for (int c = -1; c < kCorners; ++c) {
        double a = 2 * kPi * c / kCorners, out = c < 0 ? 0 : r;
        double tt = std::clamp(t + out * std::cos(a) / std::max(m.length, 1e-3), 0.0, 1.0);
        double ss = std::clamp(s0 + out * std::sin(a) / wide, -1.0, 1.0);
        s.position.push_back(blades.at(k, tt, ss, c < 0 ? 1.6 * kAbove : kAbove));
      }
      for (std::uint32_t c = 0; c < kCorners; ++c)
        s.triangle.push_back({first, first + 1 + (c + 1) % kCorners, first + 1 + c});
    }
  }
  set_normals(s);
  return s;
}

/// A thread along places, of that radius.
void add_thread(Surface& to, const std::vector<Vec3>& places, double radius, double taper) {
  constexpr int kSides = 5;
  auto start = static_cast<std::uint32_t>(to.position.size());
  Vec3 across(1, 0, 0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    Vec3 along =
        direction_or(places[std::min(i + 1, places.size() - 1)] - places[i > 0 ? i - 1 : 0], Vec3(0, 1, 0));
    across = direction_or(across - along * glm::dot(along, across), Vec3(0, 0, 1));
    Vec3 other = glm::cross(along, across);
    double share = static_cast<double>(i) / static_cast<double>(places.size() - 1),
           r = radius * (1 - taper * share);
    for (int k = 0; k <= kSides; ++k) {
      double a = 2 * kPi * k / kSides;
      Vec3 out = across * static_cast<float>(std::cos(a)) + other * static_cast<float>(std::sin(a));
      to.position.push_back(places[i] + out * static_cast<float>(r));
      to.normal.push_back(out);
    }
  }
  for (std::uint32_t i = 0; i + 1 < places.size(); ++i)
    for (std::uint32_t k = 0, row = kSides + 1; k < kSides; ++k)
      add_quad(to, start + i * row + k, start + i * row + k + 1, start + (i + 1) * row + k + 1,
               start + (i + 1) * row + k);
}

/// A body of revolution from a foot along a direction; its normals are those of its shape.
void add_turned(Surface& to, std::span<const float> profile, int sides, Vec3 at, Vec3 along, double length,
                double width) {
  Surface body = turned_surface(profile, sides);
  body.uv.clear();
  bool back = along.y < -0.9999f;
  Quat turn = back ? Quat(0, 1, 0, 0) : glm::normalize(Quat(Vec3(0, 1, 0), along));
  Vec3 scale(static_cast<float>(width), static_cast<float>(length), static_cast<float>(width));
  append_mapped(
      to, body, [&](Vec3 p) { return at + turn * (p * scale); },
      [&](Vec3 n) { return glm::normalize(turn * (n / scale)); });
}

constexpr std::array<float, 6> kEgg{0, 0.36f, 0.5f, 0.46f, 0.3f, 0};
constexpr std::array<float, 6> kAnther{0, 0.4f, 0.5f, 0.5f, 0.4f, 0};

/// The middle line of a stamen or a free carpel.
std::vector<Vec3> thread_of(const WhorlMember& m, double open) {
  constexpr int kSteps = 6;
  Vec3 out(static_cast<float>(std::sin(m.azimuth)), 0, static_cast<float>(std::cos(m.azimuth)));
  double radius = m.foot_radius, height = m.foot_height;
  std::vector<Vec3> places;
  for (int i = 0; i <= kSteps; ++i) {
    places.push_back(out * static_cast<float>(radius) + Vec3(0, static_cast<float>(height), 0));
    double angle = (m.open + m.bend * i / kSteps) * open;
    radius = std::max(radius + std::sin(angle) * m.length / kSteps, 0.0),
    height += std::cos(angle) * m.length / kSteps;
  }
  return places;
}

void add_stamens(Prototype& to, const FloralDiagram& diagram, std::size_t whorl, double stage) {
  const Whorl& w = diagram.whorls[whorl];
  Opening opening = opening_of(w.part, stage);
  Surface threads, anthers;
  double head = w.head.value_or(0.1) * (1 - 0.4 * opening.wither);
  for (const WhorlMember& m : members_of(diagram, whorl, stage)) {
    std::vector<Vec3> places = thread_of(m, opening.open);
    add_thread(threads, places, m.half, 0.3);
    Vec3 along = direction_or(places.back() - places[places.size() - 2], Vec3(0, 1, 0));
    auto low = static_cast<float>(0.3 * head);
    if (head > 0) add_turned(anthers, kAnther, 6, places.back() - along * low, along, head, 0.36 * head);
  }
  to.parts = {{Tissue::fruit, std::move(threads)}, {Tissue::heart, std::move(anthers)}};
}

void add_carpels(Prototype& to, const FloralDiagram& diagram, std::size_t whorl, double stage) {
  constexpr double kOvary = 0.36;  // of the length
  const Whorl& w = diagram.whorls[whorl];
  Opening opening = opening_of(w.part, stage);
  double head = w.head.value_or(0.05), style = 1 - 0.9 * smooth_step(0.3, 1.0, opening.wither);
  std::vector<WhorlMember> members = members_of(diagram, whorl, stage);
  Surface body, stigmas;
  if (w.fused.value_or(1) > 0.5) {
    const WhorlMember& m = members[0];
    Vec3 foot(0, static_cast<float>(m.foot_height), 0), up(0, 1, 0);
    double ovary = kOvary * m.length, top = ovary + (m.length - ovary) * style;
    add_turned(body, kEgg, 10, foot, up, ovary, 2 * m.half);
    Vec3 tip = foot + up * static_cast<float>(top);
    if (style > 0.3)
      add_thread(body, {foot + up * static_cast<float>(0.9 * ovary), glm::mix(foot, tip, 0.6f), tip},
                 0.016 + 0.1 * head, 0.2);
    for (const WhorlMember& each : members) {
      Vec3 out(static_cast<float>(std::sin(each.azimuth)), 0, static_cast<float>(std::cos(each.azimuth)));
      if (head <= 0 || style <= 0.3) break;
      Vec3 along = w.count > 1 ? glm::normalize(out * static_cast<float>(std::sin(m.open)) +
                                                up * static_cast<float>(std::cos(m.open)))
                               : up;
      add_turned(stigmas, kEgg, 6, tip - up * 0.005f, along, w.count > 1 ? head * 1.6 : head,
                 w.count > 1 ? 0.5 * head : head);
    }
  } else {
    for (const WhorlMember& m : members) {
      std::vector<Vec3> places = thread_of(m, opening.open);
      Vec3 along = direction_or(places.back() - places[0], Vec3(0, 1, 0));
      add_turned(body, kEgg, 6, places[0], along, m.length * 0.8, 2 * m.half);
      if (head > 0)
        add_turned(stigmas, kEgg, 5, places[0] + along * static_cast<float>(0.7 * m.length), along,
                   m.length * 0.3, head);
    }
  }
  to.parts = {{Tissue::fruit, std::move(body)}, {Tissue::heart, std::move(stigmas)}};
}

void add_blades(std::vector<Prototype>& made, const FloralDiagram& diagram, std::size_t whorl, double stage) {
  const Whorl& w = diagram.whorls[whorl];
  double wither = opening_of(w.part, stage).wither;
  bool there = !(w.falls && wither > kShed);
  WhorlBlades blades(diagram, whorl, stage);
  auto add = [&](const MemberSide* look, auto&& wanted) {
    Prototype one = piece(diagram, w, look, wither);
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < blades.members().size(); ++k)
      if (wanted(blades.members()[k].side)) members.push_back(k);
    if (members.empty()) return;
    one.parts.push_back({w.part == FloralPart::sepals ? Tissue::leaf : Tissue::petal,
                         there ? blades_surface(blades, w, members) : Surface{}});
    made.push_back(std::move(one));
  };
  add(nullptr, [&](Side side) { return !own_look(w, side); });
  for (Side side : {Side::upper, Side::side, Side::lower})
    if (const MemberSide* look = own_look(w, side)) add(look, [&](Side each) { return each == side; });
  if (!w.marks) return;
  Prototype spots{{}, {}, {w.marks->color}, w.marks->color};
  spots.parts.push_back(
      {Tissue::fruit, there ? marks_surface(blades, *w.marks, opening_of(w.part, stage).grown) : Surface{}});
  spots.luster = Luster{.through = 0, .gloss = 0};
  made.push_back(std::move(spots));
}

}  // namespace

int pieces_of(const FloralDiagram& diagram, std::size_t whorl) {
  const Whorl& w = diagram.whorls[whorl];
  if (!is_blade(w.part)) return 1;
  std::array<bool, 4> there{};  // the whorl's own look, then those of its sides
  for (double azimuth : azimuths(diagram, whorl)) {
    Side side = side_of(azimuth);
    there[own_look(w, side) ? static_cast<std::size_t>(side) + 1 : 0] = true;
  }
  return static_cast<int>(std::ranges::count(there, true)) + (w.marks ? 1 : 0);
}

std::vector<Prototype> flower_prototypes(const FloralDiagram& diagram, double stage) {
  std::vector<Prototype> made;
  for (std::size_t i = 0; i < diagram.whorls.size(); ++i) {
    const Whorl& w = diagram.whorls[i];
    if (is_blade(w.part)) {
      add_blades(made, diagram, i, stage);
      continue;
    }
    double wither = std::clamp(stage - 1, 0.0, 1.0);
    Prototype one = piece(diagram, w, nullptr, wither);
    if (w.part == FloralPart::stamens)
      add_stamens(one, diagram, i, stage);
    else
      add_carpels(one, diagram, i, stage);
    if (w.part == FloralPart::stamens && wither > (w.falls ? kShed : kShrivelled))
      for (OrganPart& part : one.parts) part.surface = {};
    made.push_back(std::move(one));
  }
  for (Prototype& one : made)
    std::erase_if(one.parts, [](const OrganPart& part) { return part.surface.triangle.empty(); });
  const Receptacle& foot = diagram.receptacle;
  if (foot.radius <= 0 || foot.height <= 0) return made;
  Prototype dome{{}, {}, {foot.color}, foot.color};
  std::array<float, 6> profile;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    double high = static_cast<double>(i) / (static_cast<double>(profile.size()) - 1);
    profile[i] = static_cast<float>(0.5 * std::sqrt(std::max(0.0, 1 - high * high)));
  }
  Surface body;
  add_turned(body, profile, 12, Vec3(0), Vec3(0, 1, 0), foot.height, 2 * foot.radius);
  dome.parts.push_back({Tissue::fruit, std::move(body)});
  made.push_back(std::move(dome));
  return made;
}

}  // namespace frond
