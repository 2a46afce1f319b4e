#include <algorithm>
#include <cmath>

#include "scene/copies.h"
#include "scene/reef.h"
#include "scene/stand.h"

namespace frond {

namespace {

constexpr float kSmallest = 0.015f;  // metres, the radius of the smallest that are drawn
constexpr float kSettled = 0.02f;    // factor of the size as it settles
constexpr float kStraight = 0.06f;   // of radius and height, by which growth may differ from that of a span
constexpr double kPaling = 0.3;      // years before its death that a colony is bleached
constexpr double kWhite = 0.35;      // years for which the skeleton is white
constexpr float kEroded = 0.75f;     // share of its size that is left of a skeleton at its end
constexpr double kAfter = 1e-3;      // years for which what lives at the end is there after it
constexpr double kTumbled = 2.4;     // radians that a dislodged colony is turned over

/// Places the lives of a reef's history as copies of models.
class Colonies {
 public:
  Colonies(const Preset& preset, const Grounds& ground, const ReefHistory& history, const StandFilm& film)
      : preset_(preset), heights_(ground.heights()), history_(history), film_(film) {}

  void add(Scene& scene, std::uint32_t species, std::size_t entry) {
    std::vector<std::uint32_t> lives;
    largest_ = {};
    for (std::uint32_t i = 0; i < history_.lives.size(); ++i) {
      const ColonyLife& life = history_.lives[i];
      float radius = 0;
      for (const ColonySize& size : std::span(history_.sizes).subspan(life.first, life.count)) {
        radius = std::max(radius, size.radius);
        if (life.species == species) largest_.height = std::max(largest_.height, size.height);
      }
      if (life.species != species || radius < kSmallest) continue;
      largest_.radius = std::max(largest_.radius, radius);
      lives.push_back(i);
    }
    if (lives.empty()) return;
    std::vector<CopySet> sets;
    for (ColonyState state : {ColonyState::living, ColonyState::bleached, ColonyState::dead}) {
      CopySet set;
      set.entry = entry, set.organism = preset_.organisms[entry];
      set.organism.place.size_variation = 0;
      Sowing& sown = *set.organism.sown;
      sown.size = ModelSize{largest_.height, largest_.radius, 0.2f * largest_.radius};
      sown.state = state, sown.where.radius = largest_.radius;
      set.appearance = copy_appearance(set.organism);
      sets.push_back(std::move(set));
    }
    for (std::uint32_t i : lives) place(sets, i);
    for (CopySet& set : sets)
      if (set.copies.size() > 0) scene.copy_sets.push_back(std::move(set));
  }

 private:
  /// Where a copy lies, and how it is turned.
  struct Stance {
    Vec3 foot{0};
    Quat turn{1, 0, 0, 0};
  };

  Vec2 factors(std::uint32_t i, double year) const {
    ColonySize size = size_at(history_, i, year);
    return glm::max(Vec2(size.radius / largest_.radius, size.height / largest_.height), Vec2(kSettled));
  }

  Seed seed_of(std::uint32_t i) const { return Seed{preset_.seed}.child("colony", i); }

  Stance standing(std::uint32_t i) const {
    const ColonyLife& life = history_.lives[i];
    auto turn = static_cast<float>(seed_of(i).child("turn").range(0, 2 * kPi));
    return {Vec3(life.x, heights_(life.x, life.z), life.z), glm::angleAxis(turn, Vec3(0, 1, 0))};
  }

  /// Overturned where a storm has rolled it.
  Stance rolled(std::uint32_t i) const {
    const ColonyLife& life = history_.lives[i];
    Vec3 toward(std::sin(life.azimuth), 0, std::cos(life.azimuth));
    Stance stance = standing(i);
    Vec3 at = stance.foot + life.rolled * toward;
    ColonySize size = size_at(history_, i, life.died);
    auto turned = static_cast<float>(kTumbled + seed_of(i).child("tumble").range(-0.4, 0.4));
    // Its lowest point comes to lie on the ground.
    float lift = std::max(0.0f, -size.height * std::cos(turned)) + 0.5f * size.radius * std::sin(turned);
    return {Vec3(at.x, heights_(at.x, at.z) + lift, at.z),
            glm::angleAxis(turned, glm::cross(Vec3(0, 1, 0), toward)) * stance.turn};
  }

  /// Years at which the spans of a life up to a year begin and end: between them growth is nearly even.
  std::vector<double> turns_of(std::uint32_t i, double until) const {
    const ColonyLife& life = history_.lives[i];
    std::vector<ColonySize> sizes;
    for (const ColonySize& size : std::span(history_.sizes).subspan(life.first, life.count))
      if (size.year < until) sizes.push_back(size);
    sizes.push_back(size_at(history_, i, until));
    std::vector<double> years{sizes[0].year};
    std::size_t begun = 0;
    for (std::size_t k = 1; k + 1 < sizes.size(); ++k) {
      const ColonySize &a = sizes[begun], &b = sizes[k + 1];
      bool even = true;
      for (std::size_t m = begun + 1; m <= k; ++m) {
        for (float ColonySize::*of : {&ColonySize::radius, &ColonySize::height}) {
          float straight = std::lerp(a.*of, b.*of, (sizes[m].year - a.year) / (b.year - a.year));
          float least = std::min({sizes[m - 1].*of, sizes[m].*of, sizes[m + 1].*of});
          even = even && std::abs(straight - sizes[m].*of) <= kStraight * least;
        }
      }
      if (!even) years.push_back(sizes[begun = k].year);
    }
    years.push_back(until);
    return years;
  }

  void place(std::vector<CopySet>& sets, std::uint32_t i) const {
    const ColonyLife& life = history_.lives[i];
    double end = history_.years + kAfter, died = std::min<double>(life.died, end),
           gone = std::min<double>(life.gone, end);
    bool heat = life.cause == ColonyDeath::heat;
    double pales = heat ? std::max<double>(life.born, died - kPaling) : died;
    double white = heat ? std::min(died + kWhite, gone) : died;
    Stance stance = standing(i);
    std::vector<double> years = turns_of(i, pales);
    for (std::size_t k = 1; k < years.size(); ++k)
      add_copy(sets[0], i, stance, years[k - 1], years[k], factors(i, years[k - 1]), factors(i, years[k]));
    Vec2 last = factors(i, died);
    add_copy(sets[1], i, stance, pales, white, last, last);
    add_copy(sets[2], i, life.rolled > 0 ? rolled(i) : stance, white, gone, last, kEroded * last);
  }

  void add_copy(CopySet& set, std::uint32_t i, const Stance& stance, double from, double to, Vec2 first,
                Vec2 last) const {
    if (to <= from || film_.time(to) <= 0 || film_.time(from) > film_.length) return;
    Seed seed = seed_of(i);
    Copies& copies = set.copies;
    copies.model.push_back(static_cast<std::uint16_t>(seed.child("model").bits() %
                                                      static_cast<std::uint64_t>(set.organism.sown->models)));
    copies.foot.push_back(stance.foot), copies.turn.push_back(stance.turn), copies.scale.push_back(1);
    copies.tint.push_back(static_cast<std::uint8_t>(seed.child("tint").bits() % kTints));
    copies.span.push_back({film_.time(from), film_.time(to), first, last, nullptr});
  }

  const Preset& preset_;
  const Heights& heights_;
  const ReefHistory& history_;
  StandFilm film_;
  ColonySize largest_;
};

}  // namespace

void add_reef(Scene& scene, const Preset& preset, const Grounds& ground, const ReefHistory& history) {
  const ReefText& text = *preset.reef;
  Colonies colonies(preset, ground, history, stand_film(preset.film, text.shown, text.years));
  for (std::uint32_t k = 0; k < text.species.size(); ++k)
    if (auto entry = drawn_as(preset, text.species[k].organism)) colonies.add(scene, k, *entry);
}

}  // namespace frond
