#include "organisms/vase/vase.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

constexpr double kFollows = 2e-5;  // metres by which turned curves may lie off the lip and the inside

Material material_of(const VaseParams& params, double height, Seed seed) {
  auto brighter = static_cast<float>(1 + params.variation * seed.child("tone").range(-1, 1));
  auto lit = [&](const Color& c) {
    return Color{std::min(1.0f, c.red * brighter), std::min(1.0f, c.green * brighter),
                 std::min(1.0f, c.blue * brighter)};
  };
  Material material;
  switch (params.material) {
    case VaseMaterial::ceramic:
      material.matter = Matter::ceramic;
      break;
    case VaseMaterial::terracotta:
      material.matter = Matter::terracotta;
      break;
    case VaseMaterial::glass:
      material.matter = Matter::glass;
      break;
  }
  material.color = params.material == VaseMaterial::glass ? params.color : lit(params.color);
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
    earth.color = {0.23f, 0.16f, 0.11f};
    earth.second = {0.42f, 0.34f, 0.25f};
    earth.scale = 0.02;
    model.solids.place(model.solids.add_shape({std::move(soil.surface), earth, {}}));
  }
  return model;
}

}  // namespace frond
