#include "organisms/bridge/bridge.h"

#include <algorithm>

#include "masonry/block.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

constexpr Color kCedar{0.57f, 0.45f, 0.33f}, kSilver{0.60f, 0.575f, 0.54f};
constexpr Color kSandstone{0.73f, 0.69f, 0.61f}, kMortar{0.60f, 0.57f, 0.51f};
constexpr double kRing = 0.0045;   // metres from ring to ring of the timber
constexpr std::size_t kTones = 6;  // of stone: those of one tone are one body
constexpr double kPattern = 0.30;  // metres, of the stone's own markings

/// The colour, lighter or darker and a little warmer or cooler.
Color toned(const Color& color, double variation, Seed seed) {
  auto brighter = static_cast<float>(1 + variation * seed.child("tone").range(-1, 1));
  constexpr double kWarmth = 0.35;  // of the variation in brightness
  auto warmer = static_cast<float>(1 + kWarmth * variation * seed.child("warmth").range(-1, 1));
  return {std::min(color.red * brighter * warmer, 1.0f), std::min(color.green * brighter, 1.0f),
          std::min(color.blue * brighter / warmer, 1.0f)};
}

/// Each piece shows a part of its own of the trunk that it was sawn from: the pith, which is the x axis of
/// what is drawn, lies beside it.
void add_timber(Solids& solids, const BridgeParams& params, BridgePiece piece, Seed seed) {
  constexpr double kNearestPith = 0.03, kFarthestPith = 0.14;  // metres from the middle of the piece
  constexpr double kAlongTrunk = 20;                           // metres to either side of its middle
  constexpr double kSecondVaries = 0.6;                        // of the variation
  constexpr double kWeatherVaries = 0.25;                      // to either side of the weathering
  double away = seed.child("pith").range(kNearestPith, kFarthestPith),
         around = seed.child("side").range(0, 2 * kPi);
  Vec3 shift(seed.child("along").range(-kAlongTrunk, kAlongTrunk), away * std::sin(around),
             away * std::cos(around));
  for (Vec3& p : piece.surface.position) p += shift;
  Material material{
      Matter::timber,
      toned(params.color.value_or(kCedar), params.variation, seed),
      toned(params.second.value_or(kSilver), kSecondVaries * params.variation, seed.child("second")),
      kRing,
      std::clamp(params.weathering + kWeatherVaries * seed.child("weather").range(-1, 1), 0.0, 1.0),
      params.moss,
      params.gloss};
  std::uint16_t shape = solids.add_shape({std::move(piece.surface), material});
  solids.place(shape, piece.at - piece.turn * shift, piece.turn);
}

Model wooden(const BridgeParams& params, Bridge bridge, Seed seed) {
  Model model;
  for (std::size_t i = 0; i < bridge.pieces.size(); ++i)
    add_timber(model.solids, params, std::move(bridge.pieces[i]), seed.child(i));
  return model;
}

Model stone(const BridgeParams& params, Bridge bridge, Seed seed) {
  constexpr double kToneVaries = 0.4;  // of the variation, beside what makes the tones
  // The stones of each tone, and the mortar last.
  std::vector<Surface> bodies(kTones + 1);
  for (std::size_t i = 0; i < bridge.pieces.size(); ++i) {
    BridgePiece& piece = bridge.pieces[i];
    for (Vec3& p : piece.surface.position) p = piece.at + piece.turn * p;
    for (Vec3& n : piece.surface.normal) n = piece.turn * n;
    std::size_t tone = piece.part == BridgePart::core ? kTones : seed.child(i).bits() % kTones;
    append(bodies[tone], piece.surface);
  }
  Model model;
  for (std::size_t tone = 0; tone <= kTones; ++tone) {
    bool mortar = tone == kTones;
    double share = 2.0 * static_cast<double>(tone) / (kTones - 1) - 1;
    Color color = params.color.value_or(kSandstone), second = params.second.value_or(kMortar);
    auto brighter = static_cast<float>(1 + params.variation * share);
    Color own = toned({color.red * brighter, color.green * brighter, color.blue * brighter},
                      kToneVaries * params.variation, seed.child("tone", tone));
    Material material{mortar ? Matter::bed : Matter::ashlar,
                      mortar ? second : own,
                      second,
                      kPattern,
                      params.weathering,
                      params.moss,
                      params.gloss};
    model.solids.place(model.solids.add_shape({std::move(bodies[tone]), material}));
  }
  return model;
}

}  // namespace

Model grow_bridge(const BridgeParams& params, Seed seed) {
  Bridge bridge = build_bridge(params.shape, seed.child("build"));
  return params.shape.style == BridgeStyle::wood ? wooden(params, std::move(bridge), seed.child("wood"))
                                                 : stone(params, std::move(bridge), seed.child("stone"));
}

inline constexpr Choice<BridgeStyle> kBridgeStyles[] = {
    {"wood", BridgeStyle::wood, "planks on stringers, a railing of posts and rails"},
    {"stone", BridgeStyle::stone, "a vault of voussoirs, walls, paving and a parapet with piers"}};

void describe(Properties& v, BridgeParams& b) {
  BridgeShape& s = b.shape;
  v.choice("style", s.style, kBridgeStyles, "What it is built of");
  v.number("length", s.length, metres(1, 60), "Length from foot to foot");
  v.number("width", s.width, metres(0.6, 12), "Width of the deck, over all");
  v.number("height", s.height, metres(0.05, 20), "Height of the deck at mid-span above its feet");
  v.number("crown", s.crown, {.min = 0, .max = 0.5},
           "Where the middle control point of each half of the arch lies, as a share of the length: 0.1 "
           "nearly pointed, 0.5 upright at its feet; 0 is at random between the two");
  v.number("thickness", s.thickness, metres(0.05, 5),
           "Thickness of the deck at mid-span; held to what the bend of the arch allows");
  v.integer("posts", s.posts, {.min = 1, .max = 60}, "Number of posts of each railing on each half");
  v.number("post", s.post, metres(0.02, 1.5), "Width of a post");
  v.number("rail_height", s.rail_height, metres(0.15, 3), "Height of the hand rail above the deck");
  v.number("rail", s.rail, metres(0.02, 0.6), "Width of the hand rail");
  v.number("lower_rail", s.lower_rail, metres(0, 2),
           "Height of the lower rail above the deck; 0 leaves it out. Needs \"style\": \"wood\"");
  v.integer("balusters", s.balusters, {.min = 0, .max = 30},
            "Number of thin bars between each two posts. Needs \"style\": \"wood\"");
  v.number("plank", s.plank, metres(0.04, 1), "Width of a plank, or length of a paving stone");
  v.number("gap", s.gap, metres(0.001, 0.1), "Gap between planks or stones");
  v.number("foundation", s.foundation, metres(0, 10), "How deep it reaches below its feet");
  v.color("color", b.color, "Colour of the wood or the stone; without it that of the style");
  v.color("second", b.second, "Colour of weathered wood, or of the mortar");
  v.number("variation", b.variation, {.min = 0, .max = 0.9},
           "How much planks or stones differ in brightness, as a share");
  v.number("weathering", b.weathering, kShare, "How weathered it is: 0 new, 1 old");
  v.number("moss", b.moss, kShare, "How much moss grows on it");
  v.number("gloss", b.gloss, kShare, "How glossy the wood is: 0 raw, 1 oiled");
  v.aspect(Aspect::look, "color", "second", "variation", "weathering", "moss", "gloss");
}

namespace {

class BridgeGrower final : public Described<BridgeParams, BodyBuilder> {
 public:
  static constexpr std::string_view kLeading[] = {"style", "length",     "width",       "height",
                                                  "crown", "posts",      "rail_height", "balusters",
                                                  "color", "weathering", "moss"};

  Review review() const override { return {}; }
  Result<SizeEstimate> estimate_size(Seed) const override {
    constexpr double kStoneTriangles = 2.2e5, kPieceTriangles = 260;  // of a whole bridge; of a piece of wood
    const BridgeShape& b = params.shape;
    double pieces = b.length / (b.plank + b.gap) + 4.0 * b.posts * (2 + b.balusters);
    double triangles = b.style == BridgeStyle::stone ? kStoneTriangles : kPieceTriangles * pieces;
    return SizeEstimate{.triangles = triangles, .blocks = pieces};
  }
  Result<Model> grow_alone(Seed seed) const override { return grow_bridge(params, seed); }
};

}  // namespace

Kind<Organism> bridge_kind() {
  return make_grower<BridgeGrower>("bridge", "A humped garden bridge of wood or stone");
}

}  // namespace frond
