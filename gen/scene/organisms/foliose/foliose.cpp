#include "organisms/foliose/foliose.h"

#include <algorithm>
#include <cmath>

#include "appearance/describe.h"
#include "core/noise.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

constexpr float kSunk = 0.012f;                // metres that sheets begin below the ground
constexpr double kSheetTurn = radians(137.5);  // from sheet to sheet: the golden angle

/// A measure that is `first` at the outermost or lowest sheet, share 0, and differs by `change` at the
/// innermost or highest one, share 1.
struct SheetTrend {
  double first, change;
  double at(double share) const { return first + change * share; }
};

Margin margin_of(const FolioseParams& params) {
  constexpr double kSlantOut = 0.75;  // of half the width: how far out a whorl's sheets end
  constexpr double kClearEdges = 2.4, kClearThicknesses = 1.6;  // between sheets, the larger of both
  bool plate = params.form == FolioseForm::plate;
  double reach = plate ? params.across / 2 : std::hypot(kSlantOut * params.across / 2, params.height);
  return {.reach = reach,
          .edge = params.edge,
          .excess = params.excess,
          .ruffle = params.ruffle,
          .stiffness = plate ? 0.5 : 0.25,
          .pitch = plate ? radians(8.0) : radians(55.0),
          .light = plate ? 2.0 : 1.2,
          .lobes = params.lobes,
          .lobe_size = 1.2 * params.ruffle,
          .clearance = std::max(kClearEdges * params.edge, kClearThicknesses * params.thickness)};
}

/// Leaves of a whorl: inner ones begin later and stand steeper.
std::vector<MarginStart> whorl(const FolioseParams& params, Seed seed) {
  // By eye, as the numbers of plates.
  constexpr SheetTrend kFootRadius{0.26, -0.22};                            // of the width
  constexpr SheetTrend kFootArc{105, 45}, kSlope{35, 45};                   // degrees
  constexpr double kLatestBegin = 0.25, kReach = 0.95, kMostShorter = 0.3;  // shares of growth
  std::vector<MarginStart> starts;
  double turn = seed.child("turn").range(-kPi, kPi);
  for (int i = 0; i < params.sheets; ++i) {
    double share = params.sheets > 1 ? static_cast<double>(i) / (params.sheets - 1) : 0;  // 0 outermost
    Seed own = seed.child("sheet", static_cast<std::uint64_t>(i));
    double away = params.across * kFootRadius.at(share);
    turn += kSheetTurn + own.child("turn").range(-0.3, 0.3);
    double arc = radians(kFootArc.at(share));
    Vec3 middle(0, -kSunk, 0);
    starts.push_back(ring_start(middle, away, turn, arc, radians(kSlope.at(share)), params.edge));
    starts.back().begins = kLatestBegin * share;
    starts.back().reach = kReach - kMostShorter * share * own.child("reach").unit() - starts.back().begins;
  }
  return starts;
}

/// Tiers about a foot: low ones are old and wide.
std::vector<MarginStart> plates(const FolioseParams& params, Seed seed) {
  constexpr double kLowestTier = 0.35;            // of the distance from tier to tier
  constexpr double kHighestTier = 0.92;           // of the height
  constexpr SheetTrend kFootRadius{0.10, -0.06};  // of the width
  constexpr double kSlope = 10;                   // degrees
  constexpr double kLatestBegin = 0.3;            // share of growth
  constexpr SheetTrend kReach{1, -0.4};           // a factor
  std::vector<MarginStart> starts;
  double turn = seed.child("turn").range(-kPi, kPi);
  for (int i = 0; i < params.sheets; ++i) {
    double share = (i + kLowestTier) / params.sheets;
    Seed own = seed.child("sheet", static_cast<std::uint64_t>(i));
    turn += kSheetTurn + own.child("turn").range(-0.5, 0.5);
    Vec3 middle(0, kHighestTier * params.height * share, 0);
    double radius = params.across * kFootRadius.at(share);
    starts.push_back(ring_start(middle, radius, turn, radians(own.child("arc").range(190, 280)),
                                radians(kSlope), params.edge));
    starts.back().begins = kLatestBegin * share;
    starts.back().reach =
        std::min(1 - starts.back().begins, own.child("reach").range(0.6, 0.8) * kReach.at(share));
  }
  return starts;
}

/// Half of the thickness, from `young` to `old` with age.
std::function<float(std::uint32_t, float)> half_thickness(double young, double old) {
  auto from = static_cast<float>(young / 2), to = static_cast<float>(old / 2);
  return [=](std::uint32_t, float age) { return from + (to - from) * std::sqrt(std::min(age, 1.0f)); };
}

/// A stalk that widens at its foot, with the past of its growth.
SheetBody stalk_body(double foot, double top, double height, Seed seed) {
  constexpr int kRound = 28, kRings = 18;
  constexpr double kStalkSunk = 0.02;                                // metres in the ground
  constexpr double kStalkUneven = 0.25, kStalkLumps = 1.5;           // of its radius; on that of its foot
  constexpr float kSmallest = 0.04f, kGrows = 0.96f, kGrown = 0.6f;  // of its size, twice; of growth
  SheetBody body;
  Vec3 lot(seed.child("lot").range(-99, 99), 0, 0);
  std::vector<float> birth;
  for (int j = 0; j <= kRings; ++j)
    for (int i = 0; i < kRound; ++i) {
      double share = static_cast<double>(j) / kRings, angle = 2 * kPi * i / kRound;
      double radius = top + (foot - top) * (1 - share) * (1 - share);
      if (j == kRings) radius *= 0.5;
      Vec3 out(std::cos(angle), 0, std::sin(angle));
      Vec3 at = out * static_cast<float>(radius) + Vec3(0, (height + kStalkSunk) * share - kStalkSunk, 0);
      at += out * static_cast<float>(kStalkUneven * radius *
                                     fractal_noise(at * static_cast<float>(kStalkLumps / foot) + lot, 3));
      body.surface.position.push_back(at);
      body.surface.uv.push_back({0.4f, static_cast<float>(0.7 * share)});
    }
  auto id = [&](int j, int i) { return static_cast<std::uint32_t>(j * kRound + i % kRound); };
  for (int j = 0; j < kRings; ++j)
    for (int i = 0; i < kRound; ++i) {
      body.surface.triangle.push_back({id(j, i), id(j + 1, i), id(j, i + 1)});
      body.surface.triangle.push_back({id(j, i + 1), id(j + 1, i), id(j + 1, i + 1)});
    }
  for (int i = 1; i + 1 < kRound; ++i) {
    body.surface.triangle.push_back({id(0, 0), id(0, i), id(0, i + 1)});
    body.surface.triangle.push_back({id(kRings, 0), id(kRings, i + 1), id(kRings, i)});
  }
  set_normals(body.surface);
  for (int k = 0; k < kSheetSteps; ++k) {
    float size = kSmallest + kGrows * smooth_step(0.0f, kGrown, static_cast<float>(k) / kSheetSteps);
    std::vector<Vec3>& then = body.past.emplace_back();
    for (Vec3 p : body.surface.position) then.push_back(p * size);
  }
  return body;
}

}  // namespace

Sheet foliose_sheets(const FolioseParams& params, const Surroundings& around, Seed seed) {
  Seed own = seed.child("sheets");
  auto starts = params.form == FolioseForm::plate ? plates(params, own) : whorl(params, own);
  return grow_margins(margin_of(params), starts, margin_world(around), own);
}

Result<Model> grow_foliose(const FolioseParams& params, const Surroundings& around, Seed seed) {
  constexpr double kLineDistance = 0.011;  // metres from growth line to growth line
  // The stalk of plates: radii of its foot and its top as shares of the width, and its share of the height.
  constexpr double kStalkFoot = 0.13, kStalkTop = 0.05, kStalkHeight = 0.9;
  Sheet sheet = foliose_sheets(params, around, seed);
  SheetSkin skin;
  skin.upper = skin.lower = half_thickness(params.rim, params.thickness);
  skin.lines = params.lines;
  skin.line = kLineDistance;
  SheetBody body = body_of(sheet, skin);
  if (params.form == FolioseForm::plate)
    append(body, stalk_body(kStalkFoot * params.across, kStalkTop * params.across,
                            kStalkHeight * params.height, seed.child("stalk")));
  return model_of(std::move(body), params.tissue, Matter::polyps, seed);
}

inline constexpr Choice<FolioseForm> kFolioseForms[] = {
    {"whorl", FolioseForm::whorl, "one round another, rising, as the leaves of a lettuce"},
    {"plate", FolioseForm::plate, "level, one above another"}};

void describe(Properties& v, FolioseParams& f) {
  v.choice("form", f.form, kFolioseForms, "How its sheets stand");
  v.number("across", f.across, metres(0.03, 5), "How wide it comes to be");
  v.number("height", f.height, metres(0.02, 5), "How high it comes to be");
  v.integer("sheets", f.sheets, {.min = 1, .max = 40}, "Number of sheets");
  v.number("excess", f.excess, {.min = 1, .max = 20},
           "How many times longer the rim comes to be than that of a flat sheet: 1 flat, 3 much ruffled");
  v.number("ruffle", f.ruffle, metres(0.005, 5), "About the distance from fold to fold");
  v.number("lobes", f.lobes, kShare, "How uneven its outline is");
  v.number("thickness", f.thickness, metres(0.0005, 0.5), "Thickness where it is old");
  v.number("rim", f.rim, metres(0.0005, 0.5), "Thickness at its rim");
  v.number("lines", f.lines, metres(0, 0.05), "Height of its growth lines");
  v.number("edge", f.edge, metres(0.001, 0.2), "Length of the sides of its triangles");
  v.object("tissue", f.tissue, "The living skin");
  v.object("growth", f.growth, "When it grows in the film");
}

namespace {

class FolioseGrower final : public BodyColony<FolioseGrower, FolioseParams, grow_foliose> {
 public:
  static constexpr std::string_view kLeading[] = {"form",   "across", "height",    "sheets",      "excess",
                                                  "ruffle", "lobes",  "thickness", "tissue/color"};

  Review review() const override { return {check_edge(params.edge, params.across, 10)}; }
  Result<SizeEstimate> estimate_size(Seed) const override {
    // The finer the edge, the finer the ruffles that it makes; as measured.
    constexpr double kEvenEdge = 0.003, kRuffles = 0.9;
    double area = 0.5 * params.sheets * params.across * (params.across / 2 + params.height) *
                  std::sqrt(params.excess) * std::pow(kEvenEdge / params.edge, kRuffles);
    return estimate_surface(area, params.edge);
  }
};

}  // namespace

Kind<Organism> foliose_kind() {
  return make_grower<FolioseGrower>("foliose", "A leafy coral: ruffled sheets or tiers of plates");
}

}  // namespace frond
