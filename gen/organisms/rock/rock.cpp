#include "organisms/rock/rock.h"

namespace frond {

Result<Model> build_rock(const RockParams& params, Seed seed) {
  if (Errors errors = check_rock(params.shape); !errors.empty()) return errors;
  Seed form = seed.child("form");
  Solid solid;
  if (params.native) {
    Blobs blobs = rock_blobs(params.shape, form);
    solid.surface = bare_rock(params.shape, blobs);
    solid.native = native_rock(params.shape, blobs);
  } else {
    solid.surface = rock_surface(params.shape, form);
  }
  if (solid.surface.triangle.empty()) return hollow_rock();
  solid.material = material_of(params.stone, seed);
  float sunk = static_cast<float>(params.buried) * height_of(solid.surface);
  Model model;
  model.solids.place(model.solids.add_shape(std::move(solid)), Vec3(0, -sunk, 0));
  return model;
}

}  // namespace frond
