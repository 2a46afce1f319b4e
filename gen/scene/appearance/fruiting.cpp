#include "appearance/fruiting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/content.h"
#include "core/noise.h"

namespace frond {

namespace {

constexpr int kRipening = 4;  // steps from one colour to the next
constexpr int kRotting = 3;   // steps from the last to that of rot
constexpr Color kRot{0.25f, 0.17f, 0.1f};

/// Its colours while it hangs, then while it lies.
std::vector<Color> life_colors(const Fruiting& fruit) {
  std::vector<Color> list{fruit.colors.front()};
  for (std::size_t i = 0; i + 1 < fruit.colors.size(); ++i)
    for (int k = 1; k <= kRipening; ++k)
      list.push_back(
          mixed(fruit.colors[i], fruit.colors[i + 1], static_cast<float>(k) / static_cast<float>(kRipening)));
  for (int k = 1; k <= kRotting; ++k)
    list.push_back(mixed(fruit.colors.back(), kRot, static_cast<float>(k) / (kRotting + 1)));
  return list;
}

bool is_winged(const Fruiting& fruit) {
  return fruit.mesh.position.empty() && fruit.form == FruitForm::winged;
}

int ripe_step(const Fruiting& fruit) { return kRipening * (static_cast<int>(fruit.colors.size()) - 1); }

/// How far the blush has come at one of these colours.
double blush_share(const Fruiting& fruit, std::size_t color) {
  const int ripe = ripe_step(fruit), step = static_cast<int>(color);
  if (step <= ripe) return ripe == 0 ? 1 : static_cast<double>(step) / ripe;
  return 1 - static_cast<double>(step - ripe) / (kRotting + 1);
}

std::string skin_name(const Color& ground, const Color& blush, double share) {
  return fmt::format("fruit_{}.png",
                     made_id(fmt::format("{} {} {} {} {} {} {}", ground.red, ground.green, ground.blue,
                                         blush.red, blush.green, blush.blue, share)));
}

/// A skin as lay_sunward() lays it: streaks of blush from the side in the light, pale dots, russet at the
/// stalk and the dry calyx at the tip. By eye.
Raster skin_picture(const Color& ground, const Color& blush, double share) {
  constexpr int kSide = 64;
  constexpr float kShadeEnd = 0.30f, kLightEnd = 0.78f;  // where on u the blush begins, and is whole
  constexpr float kStalkEnd = 0.12f, kCalyx = 0.975f;    // on v
  constexpr Color kRusset{0.55f, 0.45f, 0.22f}, kDry{0.20f, 0.14f, 0.08f};
  Raster made(kSide, kSide, 3);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / kSide, v = 1 - (static_cast<float>(y) + 0.5f) / kSide;
      // Streaks run along the fruit; the angle, not its cosine, keeps them of one width.
      const float turn = std::acos(1 - 2 * u);
      const auto streak = static_cast<float>(fractal_noise(Vec3(9 * turn, 1.6f * v, 3), 3));
      const auto patch = static_cast<float>(fractal_noise(Vec3(1.5f * turn, 2.5f * v, 8), 2));
      float red = smooth_step(kShadeEnd, kLightEnd, u + 0.12f * streak + 0.3f * patch);
      red *= static_cast<float>(share);
      Color c = mixed(ground, blush, red);
      const Seed dot = Seed{5}.child(static_cast<std::uint64_t>(y * kSide + x));
      if (dot.unit() < 0.03) c = mixed(c, {0.93f, 0.86f, 0.62f}, 0.4f);
      c = mixed(c, kRusset, 0.45f * (1 - smooth_step(0.0f, kStalkEnd, v + 0.04f * streak)));
      if (v > kCalyx) c = mixed(c, kDry, 0.85f);
      const std::size_t at = made.index(x, y);
      made.data[at] = to_byte(c.red), made.data[at + 1] = to_byte(c.green),
      made.data[at + 2] = to_byte(c.blue);
    }
  return made;
}

/// The least angle between the plumb line and the stalks of a cluster at which its fruits do not overlap:
/// as a ring of few, as a cap that has room for many.
double crowded_angle(const Fruiting& fruit, double grown) {
  constexpr int kRing = 5;
  constexpr double kMost = radians(85.0), kLoose = 1.2;
  if (fruit.cluster < 2) return 0;
  const double wide = fruit.size * grown * fruit_width(fruit), far = fruit.stalk + 0.5 * fruit.size * grown;
  if (far <= 0) return 0;
  if (fruit.cluster <= kRing)
    return std::min(kMost, std::asin(std::min(1.0, 0.5 * wide / (far * std::sin(kPi / fruit.cluster)))));
  const double cap = 1 - kLoose * fruit.cluster * wide * wide / (8 * far * far);
  return std::min(kMost, std::acos(std::max(cap, -1.0)));
}

}  // namespace

Errors fruit_faults(const Fruiting& fruit, const std::vector<std::string>& organs) {
  struct Dates {
    const char* name;
    Vec2 of;
  };
  const Dates all[] = {{"set", fruit.set}, {"ripe", fruit.ripe}, {"fall", fruit.fall}};
  Errors errors;
  for (const auto& [name, of] : all)
    if (of.y < of.x)
      errors.push_back({fmt::format("/{}", name),
                        fmt::format("found the first at {:.4g}, after the last at {:.4g}; expected the first "
                                    "date, then the last; dates in the next year are above 1",
                                    of.x, of.y)});
  for (std::size_t i = 0; i + 1 < std::size(all) && errors.empty(); ++i) {
    const auto& [before, from] = all[i];
    const auto& [name, to] = all[i + 1];
    if (to.x <= from.x || to.y <= from.y)
      errors.push_back({fmt::format("/{}", name),
                        fmt::format("found {:.4g} to {:.4g}; expected later dates than those of \"{}\", "
                                    "{:.4g} to {:.4g}; dates in the next year are above 1",
                                    to.x, to.y, before, from.x, from.y)});
  }
  if (fruit.blush && is_winged(fruit))
    errors.push_back({"/blush",
                      "found a colour, but the form \"winged\" has no side toward the light; "
                      "expected none, or another form"});
  if (!fruit.organ.empty() && std::ranges::find(organs, fruit.organ) == organs.end())
    errors.push_back(
        {"/organ", fmt::format("found \"{}\"; expected {}", fruit.organ,
                               organs.empty() ? "none, since only the kind \"plant\" has organs of its own"
                                              : fmt::format("the symbol of an organ of this plant: {}",
                                                            fmt::join(organs, ", ")))});
  return errors;
}

void add_fruit(std::vector<Prototype>& prototypes, const Fruiting& fruit) {
  FruitParts parts;
  if (fruit.mesh.position.empty()) {
    parts = fruit_parts(fruit.form, fruit.width);
  } else {
    parts.body = fruit.mesh;
    parts.body.paint.clear();
    lay_sunward(parts.body);
  }
  const bool wing = is_winged(fruit);
  Prototype made{std::string(kFruit), {}, life_colors(fruit), fruit.second};
  made.parts.push_back({wing ? Tissue::petal : Tissue::fruit, std::move(parts.body)});
  if (!wing) made.luster = Luster{.through = 0, .gloss = fruit.gloss};
  if (fruit.blush && !wing)
    for (std::size_t i = 0; i < made.colors.size(); ++i)
      made.parts[0].pictures.push_back(skin_name(made.colors[i], *fruit.blush, blush_share(fruit, i)));
  if (!parts.cup.position.empty()) made.parts.push_back({Tissue::heart, std::move(parts.cup)});
  made.borne = fruit.share * fruit.cluster, made.mean = fruit.size;
  const double borne = made.borne;
  prototypes.push_back(std::move(made));
  if (fruit.stalk <= 0) return;
  Prototype stalk{std::string(kFruitStalk), {{Tissue::heart, stalk_surface()}}, {fruit.second}, fruit.second};
  stalk.borne = borne, stalk.mean = fruit.stalk;
  prototypes.push_back(std::move(stalk));
}

std::vector<Drawing> fruit_drawings(const Fruiting& fruit) {
  constexpr double kPixels = 64 * 64, kSecondsAPixel = 4e-7;
  std::vector<Drawing> all;
  if (!fruit.blush || is_winged(fruit)) return all;
  const std::vector<Color> colors = life_colors(fruit);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double share = blush_share(fruit, i);
    all.push_back(drawing_of(
        skin_name(colors[i], *fruit.blush, share), kPixels, kSecondsAPixel,
        [ground = colors[i], blush = *fruit.blush, share] { return skin_picture(ground, blush, share); }));
  }
  return all;
}

FruitState fruit_state(const Fruiting& fruit, double age, double drift, Seed own) {
  constexpr double kSwelling = 1.5;        // power, see below
  constexpr double kColoursFrom = 0.62;    // share of the time from setting to ripeness
  constexpr double kLeastColoured = 0.75;  // share of the way to the last colour that a ripe one has come
  const double lot = own.unit();
  auto date = [&](Vec2 of) { return glm::mix(static_cast<double>(of.x), static_cast<double>(of.y), lot); };
  const double set = date(fruit.set), ripe = date(fruit.ripe), falls = date(fruit.fall);
  FruitState state;
  if (age <= set) return state;
  const double grown = std::clamp((age - set) / (ripe - set), 0.0, 1.0);
  // So the weight grows evenly after a slow start, as that of apples does (Lakso et al. 1995).
  state.size = 1 - std::pow(1 - grown, kSwelling);
  state.ripe = std::max(0.0, (grown - kColoursFrom) / (1 - kColoursFrom)) *
               own.child("colour").range(kLeastColoured, 1);
  state.fallen = std::clamp((age - falls) / drift, 0.0, 1.0);
  if (age > falls + drift)
    state.lain = fruit.lies > 0 ? std::min(1.0, (age - falls - drift) / fruit.lies) : 1;
  return state;
}

double fruit_years(const Fruiting& fruit, double drift) {
  return static_cast<double>(fruit.fall.y) + drift + fruit.lies;
}

std::int32_t fruit_color(const Fruiting& fruit, const FruitState& state) {
  const int ripe = ripe_step(fruit);
  const auto hung = static_cast<std::int32_t>(std::lround(state.ripe * ripe));
  if (state.lain <= 0) return hung;
  // On the ground it goes through the colours that it has not had.
  const int steps = ripe - hung + kRotting;
  return hung + std::min(steps, static_cast<int>(state.lain * (steps + 1)));
}

Vec3 fruit_direction(const Fruiting& fruit, int k, double grown, Vec3 start, Seed cluster) {
  constexpr double kHangs = 0.6;  // of its size, from which its weight has bent the stalk
  const double out = std::sqrt((k + 0.5) / fruit.cluster);
  const double loose = fruit.cluster > 1 ? out : cluster.child("aside").unit();
  const double crowded = crowded_angle(fruit, grown) * (fruit.cluster > 5 ? out : 1);
  const double aside = std::max(fruit.angle * loose, crowded);
  const double step = fruit.cluster > 5 ? kGoldenAngle : 2 * kPi / fruit.cluster;
  const double turn = 2 * kPi * cluster.child("turn").unit() + k * step;
  const Vec3 hangs(std::sin(aside) * std::cos(turn), -std::cos(aside), std::sin(aside) * std::sin(turn));
  const auto bent = static_cast<float>(smooth_step(0.0, kHangs, grown));
  const Vec3 along = glm::mix(start, hangs, bent);
  return glm::length(along) > 1e-3f ? glm::normalize(along) : hangs;
}

Quat fruit_turn(Vec3 down, Vec3 light) {
  Vec3 face = light - down * glm::dot(light, down);
  if (glm::length(face) < 1e-3f) face = glm::cross(down, Vec3(0.3f, 0.1f, 1));
  face = glm::normalize(face);
  return glm::normalize(glm::quat_cast(glm::mat3(glm::cross(down, face), down, face)));
}

}  // namespace frond
