#pragma once

#include <optional>
#include <string>
#include <vector>

#include "appearance/leaf_look.h"
#include "core/assets.h"
#include "core/result.h"
#include "core/seed.h"
#include "foliage/fruit_shapes.h"
#include "model/model.h"

namespace frond {

/// Fruit where leaves stand. Dates are years since the new year before it sets, of the first fruit and of the
/// last: those above 1 lie in the year after. Fruit that sets early is ripe and falls early.
struct Fruiting {
  Vec2 set{0.36f, 0.4f};
  Vec2 ripe{0.68f, 0.74f};
  Vec2 fall{0.74f, 0.86f};
  double share = 0.3;   ///< share of the leaf positions that bear fruit
  int cluster = 1;      ///< fruits at one place
  std::string organ;    ///< symbol of the plant's own organ whose places bear instead; empty: leaves'
  double stalk = 0.02;  ///< metres
  double angle = radians(20.0);  ///< between the plumb line and the outermost stalks of a ripe cluster
  double size = 0.06;            ///< metres, of a ripe one
  double size_variation = 0.12;
  double lies = 0.08;  ///< years that a fallen one lies on the ground
  FruitForm form = FruitForm::round;
  double width = 1;       ///< of the form, as a share of its length
  FileName model;         ///< of a mesh in place of the form
  Surface mesh;           ///< what that file holds
  double mesh_width = 1;  ///< of it, as a share of its longest side
  std::vector<Color> colors{{0.45f, 0.58f, 0.2f}, {0.66f, 0.12f, 0.1f}};  ///< from unripe to ripe
  std::optional<Color> blush;         ///< of a ripe one's side toward the light
  Color second{0.36f, 0.28f, 0.16f};  ///< of stalks and cups
  double gloss = 0.3;
};

/// Reads the mesh of a file in place of a form.
Errors load_fruit_model(const NamedFile& file, Fruiting& fruit);

/// What is wrong with it on something with organs of these symbols, pointers below the fruit's own.
Errors fruit_faults(const Fruiting& fruit, const std::vector<std::string>& organs);

/// Appends the prototypes of the fruit and, where it has one, of its stalk.
void add_fruit(std::vector<Prototype>& prototypes, const Fruiting& fruit);

/// The pictures that fruit with a blush wears.
std::vector<Drawing> fruit_drawings(const Fruiting& fruit);

inline constexpr std::string_view kFruit = "fruit", kFruitStalk = "fruit stalk";  ///< names of the prototypes

/// A fruit at one moment of its life.
struct FruitState {
  double size = 0;    ///< share of its ripe size; 0: not there
  double ripe = 0;    ///< share of the way from the first colour to the last
  double fallen = 0;  ///< 0 on its twig .. 1 on the ground
  double lain = 0;    ///< share of the time for which it lies
};

/// `age`: years since the new year before it sets; `drift`: years that it falls.
FruitState fruit_state(const Fruiting& fruit, double age, double drift, Seed own);

/// Its width as a share of its length, be it a form or a mesh.
inline double fruit_width(const Fruiting& fruit) {
  return fruit.mesh.position.empty() ? fruit.width : fruit.mesh_width;
}

/// How many years after that new year the last of them is gone.
double fruit_years(const Fruiting& fruit, double drift);

/// Which colour of its prototype a fruit has.
std::int32_t fruit_color(const Fruiting& fruit, const FruitState& state);

/// The direction of the stalk of fruit `k` of a cluster, of length 1: along `start` while it is small, then
/// toward the plumb line. Ripe ones are within Fruiting::angle of that, or as far as they push each other.
Vec3 fruit_direction(const Fruiting& fruit, int k, double grown, Vec3 start, Seed cluster);

/// The turn of a fruit that hangs along `down`, its +z toward the light.
Quat fruit_turn(Vec3 down, Vec3 light);

}  // namespace frond
