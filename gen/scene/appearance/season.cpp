#include "appearance/season.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "foliage/organ_shapes.h"

namespace frond {

namespace {

constexpr int kSteps = 5;              // from colour to colour
constexpr float kLeast = 0.02f;        // share of its size below which a leaf is not there
constexpr double kUnfold = 0.06;       // years in which a leaf unfolds
constexpr double kDarken = 0.11;       // years until it is dark
constexpr double kWither = 0.12;       // years in which what lies takes the last colour
constexpr double kBeforeFirst = 0.02;  // years from where a turn begins to the first that comes
constexpr std::string_view kBlossom = "blossom";

LeafTint mix(const LeafTint& a, const LeafTint& b, float t) {
  return {mixed(a.color, b.color, t), mixed(a.veins, b.veins, t), mixed(a.rim, b.rim, t)};
}

/// A colour of autumn, with paler veins and a browner rim: by eye.
LeafTint autumn_tint(const Color& c) {
  return {c, mixed(c, {1, 0.95f, 0.8f}, 0.3f), mixed(c, {0.4f, 0.2f, 0.08f}, 0.25f)};
}

/// The colours of other seasons in the order in which color_at() finds them: for each own colour from that of
/// a bud; for each to the first of autumn; from each of autumn to the next.
std::vector<LeafTint> season_tints(const std::vector<LeafTint>& own, const Seasons& seasons) {
  std::vector<LeafTint> list;
  if (seasons.evergreen || seasons.autumn.empty()) return list;
  auto add_blend = [&](const LeafTint& from, const LeafTint& to) {
    for (int i = 1; i <= kSteps; ++i) list.push_back(mix(from, to, static_cast<float>(i) / kSteps));
  };
  const Color& y = seasons.young;
  for (const LeafTint& green : own) add_blend(green, {y, mixed(y, {1, 1, 0.8f}, 0.3f), y});
  for (const LeafTint& green : own) add_blend(green, autumn_tint(seasons.autumn[0]));
  for (std::size_t a = 0; a + 1 < seasons.autumn.size(); ++a)
    add_blend(autumn_tint(seasons.autumn[a]), autumn_tint(seasons.autumn[a + 1]));
  return list;
}

std::int32_t color_at(const Prototype& leaf, std::int32_t own, float hue) {
  auto n = static_cast<std::int32_t>(leaf.summer);
  if (n == 0) return own;
  own = (own % n + n) % n;
  auto step = static_cast<std::int32_t>(std::lround(std::abs(hue) * kSteps));
  if (step == 0) return own;
  if (hue < 0) return n + own * kSteps + step - 1;
  if (step <= kSteps) return n + (n + own) * kSteps + step - 1;
  return std::min(n + 2 * n * kSteps + step - kSteps, static_cast<std::int32_t>(leaf.colors.size())) - 1;
}

/// Where in its life something is that comes once a year: the whole part says which one of them it is.
struct Turn {
  std::uint64_t which;
  double age;  ///< years since shortly before the first of its kind came
};

Turn turn_of(double year, double first) {
  double since = year - first;
  return {static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(since))), glm::fract(since)};
}

/// Builds the organs of a moment.
class Moment {
 public:
  Moment(const Organs& full, const std::vector<Prototype>& prototypes, const Seasons& seasons, double time,
         const GroundAt& ground)
      : full_(full), prototypes_(prototypes), s_(seasons), year_(seasons.at.at(time)), ground_(ground) {
    for (std::size_t p = 0; p < prototypes.size(); ++p)
      if (prototypes[p].name == kBlossom) blossom_ = static_cast<int>(p);
    for (std::size_t p = 0; seasons.fruit && p < prototypes.size(); ++p) {
      if (prototypes[p].name == kFruit) fruit_ = static_cast<int>(p);
      if (prototypes[p].name == kFruitStalk) stalk_ = static_cast<int>(p);
    }
    if (fruit_ < 0) return;
    for (const Vec3& at : full.position) middle_ += at / static_cast<float>(full.size());
  }

  Organs make(Seed seed) {
    out_.reserve(full_.size());
    for (std::size_t i = 0; i < full_.size(); ++i) {
      const Prototype& shape = prototypes_[full_.prototype[i]];
      const bool named = fruit_ >= 0 && !s_.fruit->organ.empty() && shape.name == s_.fruit->organ;
      const bool leaf =
          !named && !shape.piece && !shape.parts.empty() && shape.parts[0].tissue == Tissue::leaf;
      Seed own = seed.child("leaf", full_.id[i]);
      if (!shape.piece) own = own.child(full_.prototype[i]);
      // Two sprigs at one place are one that bears.
      const bool again =
          i > 0 && full_.id[i] == full_.id[i - 1] && full_.position[i] == full_.position[i - 1];
      const bool bears = fruit_ >= 0 && !again && (named || (leaf && s_.fruit->organ.empty()));
      if (bears && own.child("bears").unit() < s_.fruit->share) add_crops(i, own.child("fruit"));
      if (named && !s_.flowering) continue;  // it only tells the place
      if (!leaf && s_.flowering && shape.name != kBlossom)
        add_own_flower(i, own);
      else if (!leaf || s_.evergreen)
        add(i, full_.prototype[i], {full_.position[i], full_.turn[i], 0}, full_.scale[i], full_.color[i]);
      else
        add_leaf(i, shape, own);
      if (leaf && s_.blossom && blossom_ >= 0 && own.child("bears").unit() < s_.blossom->share)
        for (int k = 0; k < s_.blossom->cluster; ++k)
          add_flower(i, own.child("flower", static_cast<std::uint64_t>(k)));
    }
    return std::move(out_);
  }

 private:
  void add(std::size_t i, std::size_t prototype, const Flight& at, Vec3 scale, std::int32_t color,
           std::optional<std::uint32_t> id = {}) {
    out_.prototype.push_back(static_cast<std::uint16_t>(prototype));
    out_.position.push_back(at.position);
    out_.turn.push_back(at.turn);
    out_.scale.push_back(scale);
    out_.node.push_back(full_.node[i]);
    out_.birth.push_back(full_.birth[i]);
    out_.color.push_back(color);
    out_.id.push_back(id.value_or(full_.id[i]));
    out_.loose.push_back(at.loose);
    if (!full_.supple.empty()) out_.supple.push_back(full_.supple[i] * (1 - at.loose));
  }

  /// The share of its size, 0..1, that a thing on its way down still has; one that comes to lie keeps it all.
  float left(float fallen, Seed own) const {
    constexpr float kWhole = 0.6f;  // share of the fall, up to which it is
    bool lies = ground_ && own.child("lies").unit() < s_.litter;
    return lies ? 1 : 1 - smooth_step(kWhole, 1.0f, fallen);
  }

  void add_leaf(std::size_t i, const Prototype& shape, Seed own) {
    LeafState state = leaf_state(s_, year_, own);
    float size = state.size * left(state.fallen, own);
    // A sprig loses single leaves: it becomes smaller as it begins to fall.
    constexpr float kLost = 0.55f, kLostBy = 0.3f;  // share of its size, and of its fall
    if (shape.name == "sprig") size *= 1 - kLost * smooth_step(0.0f, kLostBy, state.fallen);
    if (size < kLeast) return;
    Flight at{full_.position[i], full_.turn[i], 0};
    if (state.fallen > 0) at = flight(at.position, at.turn, state.fallen, own, ground_);
    add(i, full_.prototype[i], at, full_.scale[i] * size, color_at(shape, full_.color[i], state.hue));
  }

  /// A flower or fruit of the plant itself.
  void add_own_flower(std::size_t i, Seed own) {
    constexpr double kOpen = 0.02;  // years in which it opens, and in which it withers
    double half = s_.spread / 2;
    Turn turn = turn_of(year_, s_.flowering->at - half);
    double opens = half * (1 + own.child(turn.which).range(-1, 1));
    double withers = std::min(opens + kOpen + s_.flowering->lasts, 1 - kOpen);
    double size =
        smooth_step(opens, opens + kOpen, turn.age) * (1 - smooth_step(withers, withers + kOpen, turn.age));
    if (size < static_cast<double>(kLeast)) return;
    add(i, full_.prototype[i], {full_.position[i], full_.turn[i], 0},
        full_.scale[i] * static_cast<float>(size), full_.color[i]);
  }

  void add_flower(std::size_t i, Seed own) {
    constexpr double kOpen = 0.03;                    // years in which it opens
    constexpr double kLieFrom = 0.03, kLieTo = 0.10;  // years after its fall in which it goes
    constexpr float kLost = 0.5f, kLostBy = 0.25f;    // of its size, as it falls in petals; share of the fall
    const Blossom& b = *s_.blossom;
    double half = s_.spread / 2;
    Turn turn = turn_of(year_, b.at - half - kBeforeFirst);
    Seed lot = own.child(turn.which);
    double opens = half + half * lot.child(0).range(-1, 1),
           falls = opens + b.lasts + half * lot.child(1).unit();
    auto fallen = static_cast<float>(std::clamp((turn.age - falls) / s_.drift, 0.0, 1.0));
    auto size = static_cast<float>(smooth_step(opens, opens + kOpen, turn.age));
    size *= (1 - kLost * smooth_step(0.0f, kLostBy, fallen)) * left(fallen, own);
    size *= static_cast<float>(1 - smooth_step(kLieFrom, kLieTo, turn.age - falls - s_.drift));
    if (size < kLeast) return;
    auto wide = static_cast<float>(b.size);
    Vec3 out = glm::normalize(
        Vec3(own.child(2).range(-1, 1), own.child(3).range(-0.4, 1.2), own.child(4).range(-1, 1)) +
        Vec3(0, 0.01f, 0));
    Flight at{full_.position[i] + out * wide, Quat(Vec3(0, 1, 0), out), 0};
    if (fallen > 0) at = flight(at.position, at.turn, fallen, lot, ground_);
    add(i, static_cast<std::size_t>(blossom_), at, Vec3(wide * size), 0);
  }

  /// All fruit of a place: that of this year, and what still hangs or lies of those before.
  void add_crops(std::size_t i, Seed own) {
    const auto year = static_cast<std::int64_t>(std::floor(year_));
    const double years = fruit_years(*s_.fruit, s_.drift);
    for (std::int64_t crop = year; year_ - static_cast<double>(crop) < years; --crop)
      for (int k = 0; k < s_.fruit->cluster; ++k)
        add_fruit(i, k, year_ - static_cast<double>(crop), own.child(static_cast<std::uint64_t>(crop)));
  }

  void add_fruit(std::size_t i, int k, double age, Seed cluster) {
    const Fruiting& f = *s_.fruit;
    const Seed own = cluster.child("one", static_cast<std::uint64_t>(k));
    const FruitState state = fruit_state(f, age, s_.drift, own.child(0));
    if (state.size < static_cast<double>(kLeast) || state.lain >= 1) return;
    const Vec3 from = full_.position[i];
    const Vec3 start =
        f.organ.empty() ? Vec3(own.child(1).range(-1, 1), own.child(2).range(0, 1), own.child(3).range(-1, 1))
                        : full_.turn[i] * Vec3(0, 1, 0);
    const Vec3 along = fruit_direction(f, k, state.size, glm::normalize(start + Vec3(0, 0.01f, 0)), cluster);
    const Vec3 light = from - middle_ + Vec3(0, 0.3f * glm::length(from - middle_) + 0.01f, 0);
    const Quat turn = fruit_turn(along, light);
    const double long_by = smooth_step(0.0, 0.25, state.size) * own.child(4).range(0.85, 1.15);
    const auto stalk = static_cast<float>(f.stalk * long_by);
    const auto size =
        static_cast<float>(f.size * state.size * (1 + f.size_variation * own.child(5).range(-1, 1)));
    const auto fallen = static_cast<float>(state.fallen);
    const auto id = static_cast<std::uint32_t>(own.bits());
    if (stalk_ >= 0 && fallen <= 0 && stalk > 0) {
      const float thick = std::clamp(0.04f * size, 0.0007f, 0.004f);
      add(i, static_cast<std::size_t>(stalk_), {from, turn, 0}, Vec3(thick, stalk, thick), 0, id);
    }
    Flight at{from + along * stalk, turn, 0};
    float left = 1;
    if (fallen > 0) {
      at = dropped(at.position, turn, fallen, 0.5f * size * static_cast<float>(fruit_width(f)), own, ground_);
      const bool lies = ground_ && f.lies > 0;
      left -=
          lies ? smooth_step(0.7f, 1.0f, static_cast<float>(state.lain)) : smooth_step(0.6f, 1.0f, fallen);
    }
    if (left > 0) add(i, static_cast<std::size_t>(fruit_), at, Vec3(size * left), fruit_color(f, state), id);
  }

  const Organs& full_;
  const std::vector<Prototype>& prototypes_;
  const Seasons& s_;
  double year_;
  const GroundAt& ground_;
  int blossom_ = -1, fruit_ = -1, stalk_ = -1;  // among the prototypes
  Vec3 middle_{0};                              // of the crown
  Organs out_;
};

/// Appends the prototype of the flowers.
void add_blossom(std::vector<Prototype>& prototypes, const Blossom& b) {
  BladeShape petal;
  petal.width = 0.85, petal.widest = 0.62, petal.stalk = 0, petal.round = 0.85, petal.fold = radians(8.0);
  Surface petals = corolla_surface(petal, b.petals, radians(62.0));
  for (Vec3& p : petals.position) p *= 0.5f;
  prototypes.push_back({std::string(kBlossom),
                        {{Tissue::petal, std::move(petals)}, {Tissue::heart, heart_surface(0.08, 0.5, 12)}},
                        {b.color},
                        b.heart});
}

}  // namespace

void add_seasons(Prototype& leaf, const Seasons& seasons) {
  if (leaf.piece || leaf.parts.empty() || leaf.parts[0].tissue != Tissue::leaf ||
      !leaf.parts[0].pictures.empty())
    return;
  std::vector<LeafTint> own;
  for (const Color& c : leaf.colors) own.push_back({c, c, c});
  leaf.summer = leaf.colors.size();
  for (const LeafTint& tint : season_tints(own, seasons)) leaf.colors.push_back(tint.color);
  if (leaf.colors.size() == leaf.summer) leaf.summer = 0;
}

LeafLook with_seasons(LeafLook look, const Seasons& seasons) {
  std::vector<LeafTint> own;
  for (const Color& c : look.colors) own.push_back({c, look.veins, look.rim});
  look.turned = season_tints(own, seasons);
  return look;
}

void add_seasonal(std::vector<Prototype>& prototypes, const Seasons& seasons) {
  if (seasons.blossom) add_blossom(prototypes, *seasons.blossom);
  if (seasons.fruit) add_fruit(prototypes, *seasons.fruit);
}

Errors season_faults(const std::optional<Seasons>& seasons, const std::vector<std::string>& organs) {
  if (!seasons || !seasons->fruit) return {};
  Errors errors = fruit_faults(*seasons->fruit, organs);
  for (Error& error : errors) error.where = "/season/fruit" + error.where;
  return errors;
}

LeafState leaf_state(const Seasons& s, double year, Seed leaf) {
  // In years. All of it happens within a year, whatever was asked for.
  constexpr double kLeastLife = 0.15,
                   kLatestFall = 0.88;    // from unfolding to falling, and when it has fallen
  constexpr double kLeastTurning = 0.02;  // from green to falling
  constexpr double kGoesFrom = 0.90, kGoes = 0.04, kGone = 0.98;  // when what lies begins to go, and is gone
  constexpr double kLeastTurned = 0.3;  // share of the way to the last colour on the twig
  double half = s.spread / 2, first = s.opening - half - kBeforeFirst;
  Turn turn = turn_of(year, first);
  Seed lot = leaf.child(turn.which);
  auto early = [&](double at, std::uint64_t k) {
    return glm::fract(at - first) + half * lot.child(k).range(-1, 1);
  };
  double age = turn.age, opens = early(s.opening, 0);
  double falls = std::clamp(early(s.fall, 2), opens + kLeastLife, kLatestFall - s.drift);
  double turns = std::clamp(early(s.turning, 1), opens + kDarken, falls - kLeastTurning);
  double goes = kGoesFrom + kGoes * lot.child(3).unit(), to = lot.child(4).range(kLeastTurned, 1.0);

  LeafState state;
  state.fallen = static_cast<float>(std::clamp((age - falls) / s.drift, 0.0, 1.0));
  state.size =
      static_cast<float>(smooth_step(opens, opens + kUnfold, age) * (1 - smooth_step(goes, kGone, age)));
  double turned = std::clamp((age - turns) / (falls - turns), 0.0, 1.0);
  double withered = std::clamp((age - falls) / kWither, 0.0, 1.0);
  state.hue = static_cast<float>(static_cast<double>(s.autumn.size()) * (to * turned + (1 - to) * withered) -
                                 (1 - smooth_step(opens, opens + kDarken, age)));
  return state;
}

double leaf_area_share(const Seasons& seasons, double year) {
  constexpr int kLeaves = 64;
  if (seasons.evergreen) return 1;
  double sum = 0;
  for (std::uint64_t i = 0; i < kLeaves; ++i) {
    LeafState state = leaf_state(seasons, year, Seed{i});
    sum += static_cast<double>(state.size * state.size * (1 - state.fallen));
  }
  return sum / kLeaves;
}

void in_season(Organs& organs, const std::vector<Prototype>& prototypes, const Seasons& seasons, double time,
               Seed seed, const GroundAt& ground) {
  organs = Moment(organs, prototypes, seasons, time, ground).make(seed);
}

void in_season(Model& model, const Seasons& seasons, double time, Seed seed, const GroundAt& ground) {
  in_season(model.organs, model.prototypes, seasons, time, seed, ground);
}

}  // namespace frond
