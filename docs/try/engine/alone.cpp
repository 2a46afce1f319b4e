#include "appearance/fruiting.h"
#include "organisms/colony.h"
#include "organisms/kinds.h"

// What kinds ask of a scene, as it is where a coral stands alone on level ground.

namespace frond {

std::span<const Kind<Organism>> organism_kinds() {
  static const std::vector<Kind<Organism>> kinds{
      coral_kind(), massive_kind(), columnar_kind(), foliose_kind(), table_kind(), tube_kind(), fan_kind()};
  return kinds;
}

Surroundings::Surroundings(const World&, std::size_t, const Placement&) {}

float Surroundings::room(Vec3, float) const { return Territories::kOpen; }

float Surroundings::border(Vec3) const { return Territories::kOpen; }

float Surroundings::light(Vec3) const { return 1; }

Surroundings::Hold Surroundings::hold(Vec3 at, float) const { return {{at.x, 0, at.z}, {0, 1, 0}}; }

// Nor are there files of meshes.

Errors load_fruit_model(const NamedFile& file, Fruiting&) {
  return {{file.path.string(), "is a mesh, which is not read here"}};
}

// Nothing is grown in a world here.

std::vector<Result<Specimen>> LoneGrower::grow(std::span<const Bed>, const World&, const Step&) const {
  return {};
}

}  // namespace frond
