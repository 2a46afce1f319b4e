#include "appearance/leaf_health.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

constexpr int kAilSteps = 5;          // from colour to colour
constexpr float kOldFirst = 0.8f;     // health lost by when the youngest leaf begins, and the oldest is done
constexpr float kLot = 0.45f;         // of that order, what is by chance
constexpr float kDries = 0.5f;        // of a leaf's way to its last colour, from where on it dries
constexpr float kShedWithin = 0.12f;  // health lost while a leaf falls
constexpr float kAilLitter = 0.6f;    // share of the fallen leaves that come to lie
constexpr float kNarrower = 0.45f, kShorter = 0.15f, kDeeper = 0.25f;  // of a dry leaf, which has curled
constexpr float kShrunk = 0.4f;                                        // of a dry flower
constexpr int kNeedles = 10;  // pairs of leaves on a sprig, from which on they are needles
constexpr Color kStrawColor{0.62f, 0.53f, 0.33f}, kFaded{0.52f, 0.40f, 0.26f};

bool is_green(const Prototype& organ) {
  return !organ.parts.empty() &&
         (organ.parts[0].tissue == Tissue::leaf || organ.parts[0].tissue == Tissue::ivy);
}
bool is_flower(const Prototype& organ) {
  return !organ.parts.empty() && organ.parts[0].tissue == Tissue::petal;
}

/// The number of a prototype's own colours, before those of seasons.
std::size_t own_colors(const Prototype& leaf) { return leaf.summer > 0 ? leaf.summer : leaf.ailing; }

/// The index of a leaf's colour, of which one of its own is `own`, at a share of its way to the last colour.
std::size_t ailing_at(const Prototype& leaf, std::size_t own, float way) {
  const std::size_t n = own_colors(leaf), all = leaf.colors.size() - leaf.ailing;
  const std::size_t stops = all / kAilSteps - n;  // between the colours that all share
  auto step = static_cast<std::size_t>(std::lround(way * static_cast<float>(kAilSteps * (1 + stops))));
  if (step == 0) return own;
  if (step <= kAilSteps) return leaf.ailing + own * kAilSteps + step - 1;
  return std::min(leaf.ailing + n * kAilSteps + step - kAilSteps, leaf.colors.size()) - 1;
}

/// How far something is on its way to the last colour. `lot`, 0 old .. 1 young.
float way_at(float health, float lot) {
  return std::clamp((1 - health) * (1 + kOldFirst) - kOldFirst * lot, 0.0f, 1.0f);
}
/// What has dried stays so.
float way_at(const Fare& fare, float lot) {
  const float worst = way_at(fare.least, lot);
  return std::max(way_at(fare.now, lot), worst > kDries ? worst : 0.0f);
}

Color along(const Color& own, const std::vector<Color>& colors, float way) {
  const float at = way * static_cast<float>(colors.size());
  const auto k = std::min(static_cast<std::size_t>(at), colors.size() - 1);
  return mixed(k == 0 ? own : colors[k - 1], colors[k], at - static_cast<float>(k));
}

/// A leaf that has this colour between its veins, which keep more of their own until it is dry.
LeafTint tint_of(const Color& color, const LeafTint& own, bool dry) {
  return {color, mixed(color, dry ? Color{1, 0.95f, 0.8f} : own.veins, dry ? 0.25f : 0.45f),
          mixed(color, {0.4f, 0.22f, 0.09f}, dry ? 0.3f : 0.45f)};
}

/// The tints of these colours in the order in which ailing_at() finds them.
std::vector<LeafTint> tints_of(const std::vector<LeafTint>& own, const std::vector<Color>& colors) {
  std::vector<LeafTint> list, shared;
  for (std::size_t k = 0; k < colors.size(); ++k)
    shared.push_back(tint_of(colors[k], own[0], k + 1 == colors.size()));
  auto blend = [&](const LeafTint& from, const LeafTint& to) {
    for (int i = 1; i <= kAilSteps; ++i) {
      const float t = static_cast<float>(i) / kAilSteps;
      list.push_back(
          {mixed(from.color, to.color, t), mixed(from.veins, to.veins, t), mixed(from.rim, to.rim, t)});
    }
  };
  for (const LeafTint& green : own) blend(green, shared[0]);
  for (std::size_t k = 1; k < shared.size(); ++k) blend(shared[k - 1], shared[k]);
  return list;
}

bool has_needles(const LeafLook& look) { return look.sprig && look.sprigs.pairs >= kNeedles; }

/// A leaf of an organ's number `i`, which has this index of its own colours.
class AilingLeaf {
 public:
  AilingLeaf(Organs& organs, std::size_t i) : o_(organs), i_(i) {}

  /// Turned toward straight down by an angle.
  void hang(float angle) {
    const Vec3 along = o_.turn[i_] * Vec3(0, 1, 0), down(0, -1, 0);
    Vec3 axis = glm::cross(along, down);
    float sine = glm::length(axis);
    if (sine < 1e-4f) {
      if (glm::dot(along, down) > 0) return;
      axis = o_.turn[i_] * Vec3(1, 0, 0), sine = 1;  // from straight up any way is down
    }
    const float whole = std::atan2(sine, glm::dot(along, down));
    o_.turn[i_] = glm::normalize(glm::angleAxis(std::min(angle, whole), axis / sine) * o_.turn[i_]);
  }

  void fall(float fallen, Seed seed, const GroundAt& ground) {
    const Flight at = flight(o_.position[i_], o_.turn[i_], fallen, seed, ground);
    o_.position[i_] = at.position, o_.turn[i_] = at.turn;
    if (o_.loose.empty()) o_.loose.assign(o_.size(), 0);
    o_.loose[i_] = at.loose;
    if (!o_.supple.empty()) o_.supple[i_] *= 1 - at.loose;
  }

 private:
  Organs& o_;
  std::size_t i_;
};

/// Takes away the organs that are so small that they are not there.
void drop_gone(Organs& o) {
  constexpr float kLeast = 1e-5f;  // metres
  std::size_t kept = 0;
  for (std::size_t i = 0; i < o.size(); ++i) {
    if (std::max({o.scale[i].x, o.scale[i].y, o.scale[i].z}) < kLeast) continue;
    auto keep = [&](auto& list) {
      if (!list.empty()) list[kept] = list[i];
    };
    keep(o.prototype), keep(o.position), keep(o.turn), keep(o.scale), keep(o.node), keep(o.birth);
    keep(o.color), keep(o.id), keep(o.loose), keep(o.supple);
    ++kept;
  }
  auto cut = [&](auto& list) {
    if (!list.empty()) list.resize(kept);
  };
  cut(o.prototype), cut(o.turn), cut(o.scale), cut(o.node), cut(o.birth), cut(o.color), cut(o.id);
  cut(o.loose), cut(o.supple), cut(o.position);
}

}  // namespace

std::vector<Color> ailing_colors(const Health& health, bool needles) {
  if (!health.colors.empty()) return health.colors;
  if (needles) return {{0.56f, 0.47f, 0.20f}, {0.56f, 0.29f, 0.14f}};
  return {{0.78f, 0.69f, 0.24f}, {0.45f, 0.33f, 0.19f}};
}

void add_ailing(Prototype& leaf, const std::vector<Color>& colors) {
  if (leaf.ailing > 0 || leaf.piece || !is_green(leaf) || !leaf.parts[0].pictures.empty()) return;
  std::vector<LeafTint> own;
  const std::size_t n = leaf.summer > 0 ? leaf.summer : leaf.colors.size();
  for (std::size_t i = 0; i < n; ++i) own.push_back({leaf.colors[i], leaf.colors[i], leaf.colors[i]});
  leaf.ailing = leaf.colors.size();
  for (const LeafTint& tint : tints_of(own, colors)) leaf.colors.push_back(tint.color);
}

LeafLook ail_look(LeafLook look, const Health& health) {
  std::vector<LeafTint> own;
  for (const Color& c : look.colors) own.push_back({c, look.veins, look.rim});
  for (const LeafTint& tint : tints_of(own, ailing_colors(health, has_needles(look))))
    look.turned.push_back(tint);
  return look;
}

bool ail_pictures(Prototype& leaf, const LeafLook& worn, const LeafLook& ailing) {
  if (leaf.ailing > 0 || leaf.parts.empty() || leaf.parts[0].pictures.empty()) return false;
  const std::vector<std::string>& pictures = leaf.parts[0].pictures;
  if (pictures.size() != worn.looks()) return false;
  for (const LeafLook& look : variants(ailing)) {
    if (picture_name(look, 0) != pictures[0]) continue;
    leaf.ailing = worn.looks();
    for (std::size_t i = worn.looks(); i < ailing.looks(); ++i) {
      leaf.parts[0].pictures.push_back(picture_name(look, i));
      leaf.colors.push_back(ailing.turned[i - ailing.colors.size()].color);
    }
    return true;
  }
  return false;
}

void ail(Organs& organs, const std::vector<Prototype>& prototypes, const Health& health, const Fare& fare,
         Seed seed, const GroundAt& ground) {
  bool gone = false;
  for (std::size_t i = 0; i < organs.size(); ++i) {
    const Prototype& shape = prototypes[organs.prototype[i]];
    const bool green = shape.ailing > 0, petals = shape.piece || is_flower(shape);
    if (!green && !petals) continue;
    if (!organs.loose.empty() && organs.loose[i] > 0) continue;  // its season has taken it
    Seed own = seed.child("ails", organs.id[i]);
    if (!shape.piece) own = own.child(organs.prototype[i]);
    const float lot =
        std::lerp(std::clamp(organs.birth[i], 0.0f, 1.0f), static_cast<float>(own.child("lot").unit()), kLot);
    const float way = way_at(fare, lot), dry = smooth_step(kDries, 1.0f, way);
    if (green) {
      const std::size_t at = color_index(organs.color[i], shape.ailing);
      organs.color[i] = static_cast<std::int32_t>(at < own_colors(shape) ? ailing_at(shape, at, way) : at);
    }
    if (way <= 0) continue;
    AilingLeaf leaf(organs, i);
    leaf.hang(static_cast<float>(health.droop) * smooth_step(0.1f, 0.9f, way));
    if (green)
      organs.scale[i] *= Vec3(1 - kNarrower * dry, 1 - kShorter * dry, 1 + kDeeper * dry);
    else
      organs.scale[i] *= 1 - kShrunk * dry;
    if (!green || health.sheds <= 0) continue;
    const float from = static_cast<float>(health.sheds * own.child("falls").range(0.3, 1.0));
    const float fallen = std::clamp((from - fare.least) / (kShedWithin * from), 0.0f, 1.0f);
    if (fallen <= 0) continue;
    leaf.fall(fallen, own, ground);
    if (ground && own.child("lies").unit() < kAilLitter) continue;
    organs.scale[i] *= 1 - smooth_step(0.6f, 1.0f, fallen);
    gone = gone || fallen >= 1;
  }
  if (gone) drop_gone(organs);
}

void fade(Prototype& organ, const Health& health, const Fare& fare, bool together) {
  if (organ.parts.empty()) return;
  const Tissue tissue = organ.parts[0].tissue;
  if (organ.ailing > 0 && together) {
    const std::size_t n = own_colors(organ);
    Prototype all = organ;
    organ.colors.resize(organ.ailing);
    for (OrganPart& part : organ.parts)
      if (part.pictures.size() > organ.ailing) part.pictures.resize(organ.ailing);
    for (std::size_t k = 0; k < n; ++k) {
      const float lot = (static_cast<float>(k) + 0.5f) / static_cast<float>(n);
      const std::size_t at = ailing_at(all, k, way_at(fare, lot));
      organ.colors[k] = all.colors[at];
      for (std::size_t p = 0; p < organ.parts.size(); ++p)
        if (!all.parts[p].pictures.empty()) organ.parts[p].pictures[k] = all.parts[p].pictures[at];
    }
  }
  const float way = way_at(fare, 0.3f);
  if (is_green(organ)) {
    organ.second = along(organ.second, ailing_colors(health), way);
    return;
  }
  // Fruit keeps its colour for longest.
  const bool fruit = tissue == Tissue::fruit || tissue == Tissue::skin;
  const float faded = smooth_step(fruit ? 0.6f : 0.25f, 1.0f, way) * (fruit ? 0.7f : 0.85f);
  for (Color& color : organ.colors) color = mixed(color, kFaded, faded);
  organ.second = mixed(organ.second, kFaded, faded);
}

Bark bark_in(const Bark& bark, const Fare& fare) {
  if (bark.kind != BarkKind::stem && bark.young_length <= 0) return bark;
  Bark now = bark;
  const float dry = smooth_step(0.35f, 1.0f, way_at(fare, 0.6f));
  now.young = mixed(bark.young, kStrawColor, dry);
  if (bark.kind != BarkKind::stem) return now;
  for (Color& color : now.colors) color = mixed(color, kStrawColor, dry);
  now.second = mixed(bark.second, kStrawColor, 0.8f * dry);
  return now;
}

std::vector<Color> blades_in(const std::vector<Color>& colors, const Health& health, const Fare& fare) {
  std::vector<Color> now = colors;
  for (std::size_t k = 0; k < now.size(); ++k) {
    const float lot = (static_cast<float>(k) + 0.5f) / static_cast<float>(now.size());
    now[k] = along(colors[k], ailing_colors(health), way_at(fare, lot));
  }
  return now;
}

}  // namespace frond
