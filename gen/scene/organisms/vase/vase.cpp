#include "organisms/vase/vase.h"

#include <algorithm>

#include "organisms/kinds.h"

namespace frond {

namespace {

constexpr double kFollows = 2e-5;  // metres by which turned curves may lie off the lip and the inside
constexpr Color kMoistEarth{0.23f, 0.16f, 0.11f}, kDryEarth{0.42f, 0.34f, 0.25f};

Material material_of(const VaseParams& params, double height, Seed seed) {
  auto brighter = static_cast<float>(1 + params.variation * seed.child("tone").range(-1, 1));
  auto lit = [&](const Color& c) {
    return Color{std::min(1.0f, c.red * brighter), std::min(1.0f, c.green * brighter),
                 std::min(1.0f, c.blue * brighter)};
  };
  Material material;
  material.matter = params.material;
  material.color = params.material == Matter::glass ? params.color : lit(params.color);
  material.second = lit(params.second);
  material.scale = height;
  material.relief = params.crackle;
  material.moss = params.moss;
  material.gloss = params.gloss;
  material.bands = params.bands;
  return material;
}

}  // namespace

Result<Model> grow_vase(const VaseParams& params, Seed seed) {
  Result<VesselProfile> profile = vessel_profile(params.shape);
  if (!profile) return profile.errors();
  Model model;
  if (!profile->note.empty()) model.notes.push_back(profile->note);
  Solid vessel{vessel_surface(*profile, params.shape.sides), material_of(params, profile->rim, seed), {}};
  // Bands are painted on the mesh's places.
  bool exact = params.shape.profile.size() <= 4 && params.bands.empty();
  if (params.form == VaseForm::turned || (params.form == VaseForm::either && exact))
    vessel.turned = vessel_spans(params.shape, *profile, kFollows);
  model.solids.place(model.solids.add_shape(std::move(vessel)));
  if (params.soil > 0) {
    Soil soil = vessel_soil(*profile, params.soil, params.shape.sides, seed.child("soil"));
    Material earth;
    earth.matter = Matter::soil;
    earth.color = kMoistEarth;
    earth.second = kDryEarth;
    earth.scale = 0.02;
    model.solids.place(model.solids.add_shape({std::move(soil.surface), earth, {}}));
  }
  return model;
}

inline constexpr Choice<Matter> kVaseMaterials[] = {
    {"ceramic", Matter::ceramic, "glazed"},
    {"terracotta", Matter::terracotta, "bare fired clay"},
    {"glass", Matter::glass, "clear, with the colour of its thickness"}};

inline constexpr Choice<VaseForm> kVaseForms[] = {
    {"either", VaseForm::either,
     "turned where that is exact (degree 3 and less, no bands), a mesh elsewhere"},
    {"mesh", VaseForm::mesh, "triangles"},
    {"turned", VaseForm::turned, "Bézier curves that POV-Ray turns; bands are not drawn on them"}};

inline constexpr Choice<Motif> kMotifs[] = {{"plain", Motif::plain, "nothing but the colour"},
                                            {"zigzag", Motif::zigzag, "a line up and down"},
                                            {"waves", Motif::waves, "running waves"},
                                            {"dots", Motif::dots, "round dots"},
                                            {"meander", Motif::meander, "the Greek key"},
                                            {"petals", Motif::petals, "upright petals side by side"},
                                            {"rings", Motif::rings, "three thin lines"}};

void describe(Properties& v, Band& b) {
  v.aspect(Aspect::look);
  v.number("at", b.at, kShare, "Middle of the band, as a share of the vessel's height");
  v.number("width", b.width, {.min = 0.001, .max = 1},
           "Width of the band, as a share of the vessel's height");
  v.color("color", b.color, "Colour of the band");
  v.choice("motif", b.motif, kMotifs, "What is painted");
  v.integer("repeats", b.repeats, {.min = 1, .max = 400}, "How often the motif is repeated once round");
}

void describe(Properties& v, VaseParams& p) {
  VesselShape& s = p.shape;
  v.list("profile", s.profile, {.min = 2, .max = 21},
         "Control points [radius, height] of the Bézier curve that is turned, from the foot to the lip");
  v.number("height", s.height, metres(0, 20),
           "Height that the curve is scaled to; 0 takes its points as metres");
  v.number("wall", s.wall, metres(0.0005, 1),
           "Thickness of the wall; held to what the bends and the neck of the curve allow");
  v.number("lip", s.lip, {.min = 1, .max = 8}, "Thickness of the rounded lip, as a multiple of the wall's");
  v.number("foot", s.foot, metres(0, 2), "Height of the ring that it stands on");
  v.number("foot_radius", s.foot_radius, metres(0, 10),
           "Radius of that ring; 0 takes that of the curve's foot, or a third of its widest");
  v.integer("sides", s.sides, {.min = 3, .max = 1024}, "Number of sides of the mesh, round the vessel");
  v.integer("rings", s.rings, {.min = 24, .max = 1024}, "Number of rings of the mesh, up the curve");
  v.choice("material", p.material, kVaseMaterials, "What it is made of");
  v.color("color", p.color, "Colour of the glaze, the clay or the glass");
  v.color("second", p.second, "Colour of the bare clay under a glaze, or of the salts on clay");
  v.number("crackle", p.crackle, kShare, "How uneven the glaze is: 0 even, 1 with cracks, spots and runs");
  v.number("moss", p.moss, kShare, "How much green grows on the clay");
  v.number("gloss", p.gloss, kShare, "How glossy it is: 0 matt, 1 brilliant");
  v.number("variation", p.variation, {.min = 0, .max = 0.9},
           "How much single vessels differ in brightness, as a share");
  v.list("bands", p.bands, "Bands that are painted round it");
  v.number("soil", p.soil, kShare, "Share of its height that is filled with earth; 0 leaves it empty");
  v.choice("form", p.form, kVaseForms, "How it is handed to POV-Ray");
  v.aspect(Aspect::look, "material", "color", "second", "crackle", "moss", "gloss", "variation", "bands");
}

namespace {

class VaseGrower final : public Described<VaseParams, BodyBuilder> {
 public:
  static constexpr std::string_view kLeading[] = {"profile", "height", "wall",    "lip",
                                                  "foot",    "sides",  "rings",   "material",
                                                  "color",   "second", "crackle", "gloss"};

  Review review() const override {
    Result<VesselProfile> profile = vessel_profile(params.shape);
    return {profile ? Errors{} : profile.errors()};
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    constexpr double kTriangles = 4.4;  // a side of a ring: 2 outside, 2 inside, and what lip and foot have
    return SizeEstimate{.triangles = kTriangles * params.shape.sides * params.shape.rings, .blocks = 1};
  }
  Result<Model> grow_alone(Seed seed) const override { return grow_vase(params, seed); }
};

}  // namespace

Kind<Organism> vase_kind() {
  return make_grower<VaseGrower>("vase", "A vase, bowl or pot turned from a Bézier curve");
}

}  // namespace frond
