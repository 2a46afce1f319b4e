#include "masonry/trellis.h"

#include <algorithm>

#include "masonry/block.h"
#include "organisms/kinds.h"

namespace frond {

/// A trellis of timber and wire.
struct TrellisParams {
  TrellisShape shape;
  Color color{0.50f, 0.40f, 0.30f};   ///< of the wood
  Color second{0.55f, 0.53f, 0.49f};  ///< of weathered wood
  Color metal{0.42f, 0.43f, 0.44f};   ///< of the wires
  double variation = 0.12;            ///< variation of brightness between pieces
  double weathering = 0.5;            ///< 0 new .. 1 old
  double moss = 0.1;                  ///< 0 none .. 1
};

namespace {

constexpr double kTrellisRing = 0.004;  // metres from ring to ring of the timber

/// It stands along x with the middle of its foot at the origin, its front toward +z; each part is closed.
Model build_trellis_model(const TrellisParams& params, Seed seed) {
  constexpr double kNearestPith = 0.03, kFarthestPith = 0.14;  // metres from the middle of a part, across
  constexpr double kPithBelow = 0.02, kAlongTrunk = 20;        // metres; to either side of the trunk's middle
  constexpr double kWeatherVaries = 0.25;                      // to either side of the weathering
  Model model;
  Material metal{Matter::plain, params.metal, params.metal};
  metal.gloss = 0.3;
  std::vector<TrellisPart> parts = trellis_parts(params.shape);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    TrellisPart& part = parts[i];
    if (part.wire) {
      model.solids.place(model.solids.add_shape({std::move(part.surface), metal}));
      continue;
    }
    Seed own = seed.child(i);
    Material wood{Matter::timber,
                  toned(params.color, 1 + params.variation * own.child("tone").range(-1, 1), 0),
                  params.second, kTrellisRing};
    wood.relief =
        std::clamp(params.weathering + kWeatherVaries * own.child("weather").range(-1, 1), 0.0, 1.0);
    wood.moss = params.moss, wood.gloss = 0.03;
    // Each shows a part of its own of the trunk that it was sawn from, whose pith is the x axis.
    Vec3 shift(own.child("along").range(-kAlongTrunk, kAlongTrunk),
               own.child("pith").range(kNearestPith, kFarthestPith), kPithBelow);
    for (Vec3& p : part.surface.position) p += shift;
    model.solids.place(model.solids.add_shape({std::move(part.surface), wood}), part.at - part.turn * shift,
                       part.turn);
  }
  return model;
}

}  // namespace

inline constexpr Choice<TrellisForm> kTrellisForms[] = {
    {"wires", TrellisForm::wires, "posts with level wires, as for espaliers and vines"},
    {"lattice", TrellisForm::lattice, "laths upright and level, crossing each other"},
    {"fan", TrellisForm::fan, "laths that spread from the foot, with level ones across"}};

void describe(Properties& v, TrellisParams& t) {
  TrellisShape& s = t.shape;
  v.choice("form", s.form, kTrellisForms, "What it is made of");
  v.number("width", s.width, metres(0.1, 100), "Length of the trellis, along x");
  v.number("height", s.height, metres(0.1, 20), "Height above the ground");
  v.integer("posts", s.posts, {.min = 2, .max = 200}, "Number of posts. Needs \"form\": \"wires\"");
  v.number("post", s.post, metres(0.01, 0.5), "Width of a post. Needs \"form\": \"wires\"");
  v.integer("wires", s.wires, {.min = 1, .max = 60}, "Number of wires, or of level laths of a fan");
  v.number("lowest", s.lowest, metres(0.01, 20), "Height of the lowest of them");
  v.number("wire", s.wire, metres(0.001, 0.03), "Thickness of a wire. Needs \"form\": \"wires\"");
  v.number("sag", s.sag, metres(0, 0.3),
           "How far a wire hangs through between two posts. Needs \"form\": \"wires\"");
  v.number("spacing", s.spacing, metres(0.05, 5), "Distance from lath to lath. Needs \"form\": \"lattice\"");
  v.integer("rays", s.rays, {.min = 1, .max = 60}, "Number of laths that spread. Needs \"form\": \"fan\"");
  v.number("lath", s.lath, metres(0.005, 0.2), "Width of a lath of a lattice or a fan; it is half as thick");
  v.color("color", t.color, "Colour of the wood");
  v.color("second", t.second, "Colour of weathered wood");
  v.color("metal", t.metal, "Colour of the wires");
  v.number("variation", t.variation, {.min = 0, .max = 0.9},
           "How much the pieces differ in brightness, as a share");
  v.number("weathering", t.weathering, kShare, "How weathered the wood is: 0 new, 1 old");
  v.number("moss", t.moss, kShare, "How much moss grows on the wood");
  v.aspect(Aspect::look, "color", "second", "metal", "variation", "weathering", "moss");
}

namespace {

class TrellisGrower final : public Described<TrellisParams, BodyBuilder> {
 public:
  static constexpr std::string_view kLeading[] = {"form",  "width",  "height",    "posts",
                                                  "wires", "lowest", "spacing",   "rays",
                                                  "color", "metal",  "weathering"};

  Review review() const override {
    const TrellisShape& s = params.shape;
    double parts = s.form == TrellisForm::lattice ? (s.width + s.height) / s.spacing : 0;
    if (parts > 5000)
      return {
          {{"/spacing", "would take more than 5000 laths; expected a larger spacing or a smaller trellis"}}};
    return {};
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    SizeEstimate trellis;
    std::vector<TrellisPart> parts = trellis_parts(params.shape);
    trellis.blocks = static_cast<double>(parts.size());
    for (const TrellisPart& part : parts)
      trellis.triangles += static_cast<double>(part.surface.triangle.size());
    return trellis;
  }
  Result<Model> grow_alone(Seed seed) const override { return build_trellis_model(params, seed); }
};

}  // namespace

Kind<Organism> trellis_kind() {
  return make_grower<TrellisGrower>("trellis",
                                    "A trellis of posts and wires, or of laths, for trained plants");
}

}  // namespace frond
