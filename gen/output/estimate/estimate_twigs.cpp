#include "estimate/estimate_twigs.h"

#include "draw/eyes.h"
#include "draw/twig_kinds.h"
#include "organisms/organism.h"

namespace frond {

double share_of_twigs(const Preset& preset, const Organism& organism, const Appearance& appearance,
                      double organs) {
  constexpr double kLeft = 0.33, kLeastPixel = 0.012;  // metres, of leaves that are small in the picture
  const Camera& camera = preset.setup.camera;
  double pixel = eye_at(preset.film, camera, 0).pixel *
                 static_cast<double>(glm::distance(camera.location.at(0), camera.look_at.at(0)));
  bool still = appearance.motion.growth.duration <= 0 && !appearance.season && !organism.courses.health &&
               !organism.courses.tint && !organism.grower->traits().develops(preset.film.frames > 1);
  bool whole =
      organism.style.build == Build::sweeps && appearance.look.branches.plant() && appearance.look.leaves;
  return preset.film.twigs > 0 && organs >= kManyOrgans && still && whole && pixel > kLeastPixel ? kLeft : 1;
}

}  // namespace frond
