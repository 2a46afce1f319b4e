#include <algorithm>
#include <cmath>
#include <optional>

#include "core/curve.h"
#include "core/parallel.h"
#include "land/plant_grid.h"
#include "scene/copies.h"
#include "scene/entry_seeds.h"
#include "scene/stand.h"

namespace frond {

namespace {

constexpr float kLeast = 0.6f;    // metres, height of the smallest trees of the library
constexpr float kTaller = 1.5f;   // from one height of the library to the next
constexpr double kBare = 4;       // years that its dead trees are dead
constexpr double kWilting = 1.5;  // years for which what was thrown keeps its leaves
constexpr double kMossy = 9;      // years after which moss covers a log
constexpr float kRotten = 0.3f;   // width that is left of a log at its end
constexpr float kFlare = 1.3f;    // how much thicker a stem is at its foot than at breast height
constexpr double kSpread = 2;     // years in which what grows below the trees comes up or dies back
constexpr float kCover = 2;       // metres: lower trees shade nothing
constexpr double kHidden = 0.75;  // share of the sky that one crown hides from what is below its middle
constexpr float kSprout = 0.02f;  // factor of the size as it comes up
constexpr double kWood = 0.8;     // share of the sky that a closed wood hides
constexpr float kOverhead = 8;    // metres: lower trees leave the light to a camera
constexpr double kLooked = 12;    // metres before the camera, and to all sides from there, that are looked at

/// A height of the library, and what trees of that height measure on average.
struct Stature {
  float height = 1, diameter = 0.01f, crown = 0.5f;  // metres
};

float middle_of(std::vector<float>& values) {
  auto at = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, at);
  return *at;
}

/// The heights that trees of a species reach.
std::vector<Stature> statures_of(const StandHistory& history, std::uint32_t species) {
  std::vector<Stature> list;
  for (float height = kLeast;; height *= kTaller) {
    std::vector<float> diameters, crowns;
    for (const TreeLife& life : history.lives) {
      if (life.species != species) continue;
      for (std::uint32_t k = life.first + 1; k < life.first + life.count; ++k) {
        const TreeSize &a = history.sizes[k - 1], &b = history.sizes[k];
        if (a.height > height || b.height <= height) continue;
        float t = (height - a.height) / (b.height - a.height);
        diameters.push_back(std::lerp(a.diameter, b.diameter, t));
        crowns.push_back(std::lerp(a.crown_radius, b.crown_radius, t));
        break;
      }
    }
    if (crowns.empty()) return list;
    list.push_back({height, middle_of(diameters), middle_of(crowns)});
  }
}

/// What a model of the library shows.
enum class Form { whole, pruned, dead };

/// When trees lose the limbs below a height, metres.
struct Pruning {
  double year = 0, below = 0;
};

/// A stretch of a life in which one model stands for it.
struct Chapter {
  std::size_t stature = 0;
  Form form = Form::whole;
  double from = 0, to = 0;  // years
};

/// From which years on a life has which stature, until it dies.
std::vector<Chapter> chapters_of(const StandHistory& history, const TreeLife& life,
                                 const std::vector<Stature>& statures) {
  std::vector<Chapter> chapters{{0, Form::whole, life.born, std::min<double>(life.died, history.years + 1)}};
  for (std::uint32_t k = life.first + 1; k < life.first + life.count; ++k) {
    const TreeSize &a = history.sizes[k - 1], &b = history.sizes[k];
    while (chapters.back().stature + 1 < statures.size()) {
      std::size_t now = chapters.back().stature;
      float next = std::sqrt(statures[now].height * statures[now + 1].height);
      if (b.height <= next) break;
      double year = std::lerp(a.year, b.year, std::max(0.0f, (next - a.height) / (b.height - a.height)));
      double end = chapters.back().to;
      if (year >= end) return chapters;
      chapters.back().to = year;
      chapters.push_back({now + 1, Form::whole, year, end});
    }
  }
  return chapters;
}

/// Places the lives of a stand's history as copies of the library's models.
class Library {
 public:
  Library(const Preset& preset, const Grounds& ground, const StandHistory& history, const StandFilm& film)
      : preset_(preset), heights_(ground.heights()), history_(history), film_(film) {}

  void add(Scene& scene, std::uint32_t species, std::size_t entry) {
    statures_ = statures_of(history_, species);
    if (statures_.empty()) return;
    Organism organism = preset_.organisms[entry];
    organism.place.size_variation = 0;
    std::vector<float> heights;
    if (const Perennial* lived = organism.grower->perennial())
      heights = lived->heights(organism, entry_seeds(preset_, "heights")[entry]);
    prunings_.clear();
    for (const Event& event : preset_.events)
      if (event.prune && concerns(event.prune->entry, organism.name))
        prunings_.push_back({event.year, event.prune->below});
    std::vector<CopySet> sets;
    for (Form form : {Form::whole, Form::pruned, Form::dead})
      for (const Stature& stature : statures_) {
        auto reached = std::ranges::find_if(heights, [&](float h) { return h >= stature.height; });
        double years = static_cast<double>(std::min(reached - heights.begin() + 1, std::ssize(heights)));
        sets.push_back(copy_set_of(organism, entry, stature, heights.empty() ? 1 : years, form));
      }
    for (std::uint32_t i = 0; i < history_.lives.size(); ++i)
      if (history_.lives[i].species == species) place(sets, i);
    for (CopySet& set : sets)
      if (set.copies.size() > 0) scene.copy_sets.push_back(std::move(set));
  }

 private:
  CopySet copy_set_of(const Organism& organism, std::size_t entry, const Stature& stature, double years,
                      Form form) const {
    CopySet set;
    set.entry = entry, set.organism = organism;
    double clear = 0;
    if (form == Form::pruned)
      for (const Pruning& p : prunings_) clear = std::max(clear, p.below);
    if (const Perennial* lived = organism.grower->perennial())
      if (auto aged = lived->at_age(years, form == Form::dead ? kBare : 0, clear)) set.organism.grower = aged;
    set.organism.sown->size = ModelSize{stature.height, stature.crown, kFlare * stature.diameter};
    set.organism.sown->where.radius = stature.crown;
    set.appearance = copy_appearance(set.organism);
    return set;
  }

  Vec2 factors(std::uint32_t i, double year, const Stature& stature) const {
    TreeSize size = size_at(history_, i, year);
    return glm::max(Vec2(size.crown_radius / stature.crown, size.height / stature.height), Vec2(kSprout));
  }

  std::shared_ptr<const Fall> fall_of(const TreeLife& life, float height) const {
    Fall fall;
    fall.start = film_.time(life.fell);
    Vec3 toward(std::sin(life.azimuth), 0, std::cos(life.azimuth));
    fall.axis = glm::cross(Vec3(0, 1, 0), toward);
    float reach = 0.7f * height;
    double rise = heights_(life.x + reach * toward.x, life.z + reach * toward.z) - heights_(life.x, life.z);
    // A slender pole, for each kg of it.
    double weight = kGravity * height / 2;
    fall.course =
        course_of({height * height / 3, weight, 0.02, 0.02 * weight, 0.3, kPi / 2 - std::atan2(rise, reach)});
    return std::make_shared<const Fall>(std::move(fall));
  }

  /// The year in which a life loses its lower limbs.
  double pruned_in(std::uint32_t i) const {
    double year = TreeLife::kNever;
    for (const Pruning& p : prunings_)
      if (p.year > history_.lives[i].born && kMostPruned * size_at(history_, i, p.year).height >= p.below)
        year = std::min(year, p.year);
    return year;
  }

  void prune(std::vector<Chapter>& chapters, double year) const {
    for (std::size_t k = 0; k < chapters.size(); ++k) {
      Chapter& c = chapters[k];
      if (c.to <= year) continue;
      Chapter after{c.stature, Form::pruned, std::max(c.from, year), c.to};
      c.to = after.from;
      chapters.insert(chapters.begin() + static_cast<std::ptrdiff_t>(++k), after);
    }
  }

  void place(std::vector<CopySet>& sets, std::uint32_t i) const {
    const TreeLife& life = history_.lives[i];
    std::vector<Chapter> chapters = chapters_of(history_, life, statures_);
    prune(chapters, pruned_in(i));
    Form form = chapters.back().form;
    std::size_t last = chapters.back().stature;
    std::shared_ptr<const Fall> fall;
    if (life.died <= static_cast<float>(history_.years) && life.cause != DeathCause::cut) {
      double rotted = std::min<double>(life.rotted, history_.years + 1),
             fell = std::min<double>(life.fell, rotted);
      if (fell < rotted) fall = fall_of(life, size_at(history_, i, life.died).height);
      double wilted = std::min(fell <= life.died ? life.died + kWilting : life.died, rotted);
      if (wilted > life.died) chapters.push_back({last, form, life.died, wilted});
      if (fell > wilted) chapters.push_back({last, Form::dead, wilted, fell}), wilted = fell;
      if (rotted > wilted) chapters.push_back({last, Form::dead, wilted, rotted});
    }
    for (const Chapter& c : chapters) add_copy(sets, i, c, c.from >= life.fell ? fall : nullptr);
  }

  void add_copy(std::vector<CopySet>& sets, std::uint32_t i, const Chapter& c,
                std::shared_ptr<const Fall> fall) const {
    const TreeLife& life = history_.lives[i];
    if (c.to <= c.from || film_.time(c.to) <= 0 || film_.time(c.from) > film_.length) return;
    const Stature& stature = statures_[c.stature];
    CopySet& set = sets[c.stature + static_cast<std::size_t>(c.form) * statures_.size()];
    Seed seed = Seed{preset_.seed}.child("life", i);
    CopySpan span{film_.time(c.from), film_.time(c.to), factors(i, c.from, stature),
                  factors(i, c.to, stature), std::move(fall)};
    if (c.form == Form::dead && span.fall) {
      span.last *= Vec2(kRotten, 1);
      auto moss = [&](double year) { return static_cast<float>(std::min((year - life.fell) / kMossy, 1.0)); };
      span.moss = {moss(c.from), moss(c.to)};
    }
    Copies& copies = set.copies;
    copies.model.push_back(static_cast<std::uint16_t>(seed.child("model").bits() %
                                                      static_cast<std::uint64_t>(set.organism.sown->models)));
    copies.foot.emplace_back(life.x, heights_(life.x, life.z), life.z);
    copies.turn.push_back(
        glm::angleAxis(static_cast<float>(seed.child("turn").range(0, 2 * kPi)), Vec3(0, 1, 0)));
    copies.scale.push_back(1);
    copies.tint.push_back(static_cast<std::uint8_t>(seed.child("tint").bits() % kTints));
    copies.span.push_back(std::move(span));
  }

  const Preset& preset_;
  const Heights& heights_;
  const StandHistory& history_;
  StandFilm film_;
  std::vector<Stature> statures_;
  std::vector<Pruning> prunings_;
};

/// The crowns of a stand, and those of them that are over a camera.
struct Crowns {
  PlantGrid all, overhead;
};

Crowns crowns_at(const StandHistory& history, double year) {
  PlantGrid none(std::max(history.area.x, history.area.y));
  Crowns crowns{none, none};
  for (std::uint32_t i : living_at(history, year)) {
    const TreeLife& life = history.lives[i];
    TreeSize size = size_at(history, i, year);
    for (auto [grid, lowest] : {std::pair(&crowns.all, kCover), std::pair(&crowns.overhead, kOverhead)})
      if (size.height > lowest) grid->add({life.x, life.z}, size.crown_radius, size.diameter / 2);
  }
  return crowns;
}

/// The share of the sky that crowns hide from a place.
double hidden(const PlantGrid& crowns, Vec2 at) {
  double open = 1;
  crowns.each_within(at, 1, [&](const PlantGrid::Plant& crown) {
    double far = glm::distance(at, crown.at) / std::max(crown.radius, 0.1f);
    open *= 1 - kHidden * (1 - smooth_step(0.7, 1.0, far));
  });
  return 1 - open;
}

/// The share of the sky, of what a closed wood hides, that crowns hide where the camera looks.
Animated<double> closed_over(const std::vector<Crowns>& crowns, const Camera& camera, const StandFilm& film) {
  std::vector<Animated<double>::Key> keys;
  for (std::size_t k = 0; k < crowns.size(); ++k) {
    double time = film.time(film.from + kSpread * static_cast<double>(k)), sum = 0;
    Vec3 eye = camera.location.at(time), way = camera.look_at.at(time) - eye;
    Vec2 toward = Vec2(way.x, way.z) / std::max(std::hypot(way.x, way.z), 1e-3f);
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j)
        sum += hidden(crowns[k].overhead,
                      Vec2(eye.x, eye.z) + static_cast<float>(kLooked) * (toward + Vec2(i, j) / 2.0f));
    keys.push_back({time, std::min(1.0, sum / 25 / kWood)});
  }
  return Animated<double>(std::move(keys));
}

/// The copies of a set that is sown below the trees: each shows in the years in which it gets the shade
/// that it likes, and comes up and dies back within kSpread years.
Copies undergrowth(const CopySet& set, const std::vector<Crowns>& crowns, const StandFilm& film) {
  const Copies& all = set.copies;
  Vec2 likes = set.organism.sown->where.shade;
  std::vector<std::vector<CopySpan>> spans(all.size());
  parallel_for(all.size(), [&](std::size_t i) {
    Vec2 at(all.foot[i].x, all.foot[i].z);
    std::optional<double> since;
    for (std::size_t k = 0; k <= crowns.size(); ++k) {
      double year = film.from + kSpread * static_cast<double>(k);
      bool suits = k < crowns.size();
      if (suits) {
        double shade = hidden(crowns[k].all, at);
        suits = shade >= likes.x && shade <= likes.y;
      }
      if (suits && !since) since = year - (k == 0 ? kSpread : 0);
      if (suits || !since) continue;
      double up = film.time(*since), grown = film.time(*since + kSpread);
      double down = film.time(year), gone = film.time(year + kSpread);
      spans[i].push_back({up, grown, Vec2(kSprout), Vec2(1), nullptr});
      spans[i].push_back({grown, down, Vec2(1), Vec2(1), nullptr});
      spans[i].push_back({down, gone, Vec2(1), Vec2(kSprout), nullptr});
      since.reset();
    }
  });
  Copies now;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (CopySpan& span : spans[i])
      if (span.end > span.begin) now.add(all, i, std::move(span));
  return now;
}

}  // namespace

void add_stand(Scene& scene, const Preset& preset, const Grounds& ground, const StandHistory& history) {
  const StandText& text = *preset.stand;
  StandFilm film = stand_film(preset.film, text.shown, text.years);
  std::vector<Crowns> crowns;
  for (double year = film.from; year < film.to + kSpread; year += kSpread)
    crowns.push_back(crowns_at(history, std::min<double>(year, history.years)));
  scene.setup.closed = closed_over(crowns, scene.setup.camera, film);
  for (CopySet& set : scene.copy_sets)
    if (set.organism.sown->where.layer != Layer::canopy) set.copies = undergrowth(set, crowns, film);
  Library library(preset, ground, history, film);
  for (std::uint32_t k = 0; k < text.species.size(); ++k)
    if (auto entry = drawn_as(preset, text.species[k].organism)) library.add(scene, k, *entry);
}

}  // namespace frond
