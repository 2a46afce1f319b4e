#include "organisms/bridge/bridge.h"

#include <algorithm>

#include "masonry/block.h"

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
  auto warmer = static_cast<float>(1 + 0.35 * variation * seed.child("warmth").range(-1, 1));
  return {std::min(color.red * brighter * warmer, 1.0f), std::min(color.green * brighter, 1.0f),
          std::min(color.blue * brighter / warmer, 1.0f)};
}

/// Each piece shows a part of its own of the trunk that it was sawn from: the pith, which is the x axis of
/// what is drawn, lies beside it.
void add_timber(Solids& solids, const BridgeParams& params, BridgePiece piece, Seed seed) {
  double away = seed.child("pith").range(0.03, 0.14), around = seed.child("side").range(0, 2 * kPi);
  Vec3 shift(static_cast<float>(seed.child("along").range(-20, 20)),
             static_cast<float>(away * std::sin(around)), static_cast<float>(away * std::cos(around)));
  for (Vec3& p : piece.surface.position) p += shift;
  Material material{Matter::timber,
                    toned(params.color.value_or(kCedar), params.variation, seed),
                    toned(params.second.value_or(kSilver), 0.6 * params.variation, seed.child("second")),
                    kRing,
                    std::clamp(params.weathering + 0.25 * seed.child("weather").range(-1, 1), 0.0, 1.0),
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
                      0.4 * params.variation, seed.child("tone", tone));
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

}  // namespace frond
