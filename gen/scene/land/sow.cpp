#include "land/sow.h"

#include <algorithm>
#include <cmath>

#include "land/plant_grid.h"
#include "land/suitability.h"

namespace frond {

namespace {

constexpr int kDarts = 40;       // thrown for each plant before it is given up
constexpr int kPatience = 2000;  // plants of a kind in a row that find no room before all of it is given up
constexpr std::size_t kLayers = 3;

std::size_t layer_of(const SowOrder& order) { return static_cast<std::size_t>(order.rules.layer); }

/// Plant `index` of an order.
Seed seed_of(const SowOrder& order, int index) {
  return order.seed.child("sprout", static_cast<std::uint64_t>(index));
}
double size_of(const SowOrder& order, Seed own) { return sprout_size(order.size_variation, own); }

/// All that stands while sowing.
struct Field {
  const Land& land;
  std::vector<PlantGrid> beds;  // of each layer
  PlantGrid taken;

  explicit Field(const Land& ground)
      : land(ground), beds(kLayers, PlantGrid(ground.size)), taken(ground.size) {
    for (const Spot& spot : land.taken) taken.add(spot.at, spot.radius, spot.radius);
  }

  bool free(Vec2 at, double radius, double stem, std::size_t layer) const {
    for (std::size_t other = 0; other < kLayers; ++other)
      if (other == layer ? beds[other].crown_touches(at, radius) : beds[other].stem_touches(at, stem))
        return false;
    return !taken.stem_touches(at, stem);
  }

  void plant(Vec2 at, const SowOrder& order, double size) {
    beds[layer_of(order)].add(at, order.rules.radius * size, order.rules.stem * size);
  }
};

/// The factor of the size of plants at a place.
double grown_at(const Land& land, const SowRules& rules, Vec2 at) {
  if (!rules.warmth || !land.altitude) return 1;
  return std::lerp(rules.warmth->dwarf, 1.0, warm_share(*rules.warmth, land.altitude(at)));
}

/// A place moved to the nearest of the rows; nothing in a gap.
std::optional<Vec2> in_row(const CropRows& rows, Vec2 at, Seed rows_seed, Seed own) {
  Vec2 along(std::sin(rows.turn), std::cos(rows.turn)), across(along.y, -along.x);
  double row = std::round(glm::dot(at, across) / rows.spacing), length = glm::dot(at, along);
  auto number = [](double whole) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(whole)); };
  Seed stretch = rows_seed.child("gap", number(row)).child(number(std::floor(length / rows.gap)));
  if (stretch.unit() < rows.gaps) return {};
  double aside = row * rows.spacing + rows.wander * own.child("aside").range(-1, 1);
  return static_cast<float>(aside) * across + static_cast<float>(length) * along;
}

/// Where a plant of a size in the warmth finds room, if it does.
std::optional<Vec2> find_room(const Field& field, const Suitability& likings, const SowOrder& order, Seed own,
                              double warm_size) {
  if (likings.none()) return {};
  for (std::uint64_t i = 0; i < kDarts; ++i) {
    Seed toss = own.child("dart").child(i);
    Suitability::Dart dart = likings.dart(toss);
    if (order.rules.rows) {
      std::optional<Vec2> place = in_row(*order.rules.rows, dart.at, order.seed, toss);
      if (!place) continue;
      dart.at = *place;
    }
    double size = warm_size * grown_at(field.land, order.rules, dart.at);
    if (!field.free(dart.at, order.rules.radius * size, order.rules.stem * size, layer_of(order))) continue;
    if (likings(dart.at) > dart.likely * toss.child(3).unit()) return dart.at;
  }
  return {};
}

/// A plant that is to be sown, and when: the lowest first.
struct Turn {
  double turn;
  std::size_t order;
  int index;
};

/// The largest kinds first. Those of about one size take turns, each kind its largest first, so that those of
/// each that find no room are as large a share.
std::vector<Turn> turns_of(std::span<const SowOrder> orders, std::size_t layer) {
  constexpr double kAlike = 1.5;  // times as large
  std::vector<std::size_t> kinds;
  for (std::size_t o = 0; o < orders.size(); ++o)
    if (layer_of(orders[o]) == layer) kinds.push_back(o);
  auto radius = [&](std::size_t o) { return orders[o].rules.radius; };
  std::stable_sort(kinds.begin(), kinds.end(),
                   [&](std::size_t a, std::size_t b) { return radius(a) > radius(b); });
  std::vector<Turn> turns;
  double round = 0, largest = 0;
  for (std::size_t o : kinds) {
    if (radius(o) * kAlike < largest) round += 1;
    if (radius(o) * kAlike < largest || largest == 0) largest = radius(o);
    std::vector<std::pair<double, int>> sizes;
    for (int i = static_cast<int>(orders[o].at.size()); i < orders[o].count; ++i)
      sizes.emplace_back(-size_of(orders[o], seed_of(orders[o], i)), i);
    std::sort(sizes.begin(), sizes.end());
    for (std::size_t rank = 0; rank < sizes.size(); ++rank) {
      double share = static_cast<double>(rank) + seed_of(orders[o], sizes[rank].second).child("turn").unit();
      turns.push_back({round + share / static_cast<double>(sizes.size()), o, sizes[rank].second});
    }
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
    return a.turn != b.turn ? a.turn < b.turn : std::pair(a.order, a.index) < std::pair(b.order, b.index);
  });
  return turns;
}

using Places = std::vector<std::vector<std::optional<Vec2>>>;  // of each plant of each order

void sow_layer(std::span<const SowOrder> orders, std::size_t layer, Field& field, Places& places) {
  std::vector<std::optional<Suitability>> likings(orders.size());
  for (std::size_t o = 0; o < orders.size(); ++o)
    if (layer_of(orders[o]) == layer)
      likings[o].emplace(orders[o].rules, field.land, std::span(field.beds).first(layer), orders[o].seed);
  std::vector<int> missed(orders.size());  // in a row
  for (const Turn& turn : turns_of(orders, layer)) {
    if (missed[turn.order]++ >= kPatience) continue;
    const SowOrder& order = orders[turn.order];
    Seed own = seed_of(order, turn.index);
    double size = size_of(order, own);
    std::optional<Vec2> at = find_room(field, *likings[turn.order], order, own, size);
    if (!at) continue;
    missed[turn.order] = 0;
    field.plant(*at, order, size * grown_at(field.land, order.rules, *at));
    places[turn.order][static_cast<std::size_t>(turn.index)] = at;
  }
}

/// The nearest other of each, the first of those that are equally near.
std::vector<std::size_t> nearest_of(const std::vector<Sprout>& sprouts) {
  Vec2 low = sprouts[0].at, high = low;
  for (const Sprout& s : sprouts) low = glm::min(low, s.at), high = glm::max(high, s.at);
  // Cells that hold about one each, numbered row by row.
  auto most = std::max(1.0, std::sqrt(static_cast<double>(sprouts.size())));
  double side = std::max({high.x - low.x, high.y - low.y, 1e-3f}) / most;
  auto rows = static_cast<std::ptrdiff_t>(most) + 1;
  auto row_of = [&](float at, float from) {
    return std::min(static_cast<std::ptrdiff_t>((at - from) / side), rows - 1);
  };
  std::vector<std::vector<std::size_t>> cells(static_cast<std::size_t>(rows * rows));
  for (std::size_t i = 0; i < sprouts.size(); ++i)
    cells[static_cast<std::size_t>(row_of(sprouts[i].at.y, low.y) * rows + row_of(sprouts[i].at.x, low.x))]
        .push_back(i);
  std::vector<std::size_t> nearest(sprouts.size());
  for (std::size_t i = 0; i < sprouts.size(); ++i) {
    Vec2 at = sprouts[i].at;
    std::ptrdiff_t row = row_of(at.y, low.y), column = row_of(at.x, low.x);
    float best = 1e30f;
    // Ring after ring of cells, until none farther out can be nearer.
    for (std::ptrdiff_t ring = 0; ring <= rows && best >= side * static_cast<double>(ring - 1); ++ring)
      for (std::ptrdiff_t r = std::max<std::ptrdiff_t>(row - ring, 0); r <= std::min(row + ring, rows - 1);
           ++r) {
        std::ptrdiff_t stride = std::abs(r - row) == ring ? 1 : std::max<std::ptrdiff_t>(2 * ring, 1);
        for (std::ptrdiff_t c = column - ring; c <= column + ring; c += stride) {
          if (c < 0 || c >= rows) continue;
          for (std::size_t k : cells[static_cast<std::size_t>(r * rows + c)]) {
            float away = glm::distance(at, sprouts[k].at);
            if (k == i || away > best || (away == best && k > nearest[i])) continue;
            best = away;
            nearest[i] = k;
          }
        }
      }
  }
  return nearest;
}

/// Gives each its model. Who is nearest to whom runs in chains toward ever nearer pairs, so that from the end
/// of a chain on each can take another model than its nearest.
void choose_models(std::vector<Sprout>& sprouts, int models) {
  constexpr std::uint16_t kNone = UINT16_MAX;
  auto any = [&](std::size_t i, int of) {
    return static_cast<std::uint16_t>(sprouts[i].seed.child("model").bits() % static_cast<unsigned>(of));
  };
  if (models < 2 || sprouts.size() < 2) {
    for (std::size_t i = 0; i < sprouts.size(); ++i) sprouts[i].model = any(i, models);
    return;
  }
  std::vector<std::size_t> nearest = nearest_of(sprouts), chain;
  for (Sprout& sprout : sprouts) sprout.model = kNone;
  for (std::size_t start = 0; start < sprouts.size(); ++start) {
    chain.clear();
    for (std::size_t i = start; sprouts[i].model == kNone; i = nearest[i]) {
      chain.push_back(i);
      if (nearest[nearest[i]] == i && sprouts[nearest[i]].model == kNone) {
        sprouts[i].model = any(i, models);
        chain.pop_back();
        break;
      }
    }
    for (; !chain.empty(); chain.pop_back()) {
      std::size_t i = chain.back();
      std::uint16_t other = sprouts[nearest[i]].model, own = any(i, models - 1);
      sprouts[i].model = static_cast<std::uint16_t>(own + (own >= other));
    }
  }
}

}  // namespace

double warm_share(const Warmth& warmth, double altitude) {
  constexpr double kLapse = 0.006;  // kelvin a metre
  double now = warmth.lowest - kLapse * altitude;
  return std::clamp((now - warmth.least) / std::max(warmth.full - warmth.least, 1e-6), 0.0, 1.0);
}

double sprout_size(double size_variation, Seed own) {
  return 1 + size_variation * own.child("size").range(-1, 1);
}

double hidden_sky(double distance, double radius) {
  return 1 - smooth_step(0.6 * radius, 2.2 * radius, distance);
}

std::vector<std::vector<Sprout>> sow(std::span<const SowOrder> orders, const Land& land) {
  Field field(land);
  Places places(orders.size());
  for (std::size_t o = 0; o < orders.size(); ++o) {
    const SowOrder& order = orders[o];
    places[o].resize(std::max(order.at.size(), static_cast<std::size_t>(std::max(order.count, 0))));
    for (std::size_t i = 0; i < order.at.size(); ++i) {
      places[o][i] = order.at[i];
      field.plant(order.at[i], order, size_of(order, seed_of(order, static_cast<int>(i))));
    }
  }
  for (std::size_t layer = 0; layer < kLayers; ++layer) sow_layer(orders, layer, field, places);

  std::vector<std::vector<Sprout>> sown(orders.size());
  for (std::size_t o = 0; o < orders.size(); ++o) {
    for (std::size_t i = 0; i < places[o].size(); ++i) {
      if (!places[o][i]) continue;
      Seed own = seed_of(orders[o], static_cast<int>(i));
      double size = size_of(orders[o], own);
      if (i >= orders[o].at.size()) size *= grown_at(land, orders[o].rules, *places[o][i]);
      sown[o].push_back({*places[o][i], static_cast<float>(size), 0, own});
    }
    choose_models(sown[o], orders[o].models);
  }
  return sown;
}

}  // namespace frond
