#include <algorithm>
#include <cmath>

#include "organisms/school/school.h"
#include "organisms/school/swimmer_shape.h"

namespace frond {

namespace {

constexpr int kLooks = 5;        // of animals that vary
constexpr double kRelief = 1.2;  // of the skin of fish

Surface shape_of(const FishParams& fish, int shape) {
  double phase = static_cast<double>(shape) / kShapes;
  switch (fish.animal) {
    case SeaAnimal::fish:
      return fish_surface(fish.form, fish.look.eye, static_cast<double>(shape % kTailPhases) / kTailPhases,
                          static_cast<double>(shape / kTailPhases) - 1.0);
    case SeaAnimal::turtle:
      return turtle_surface(phase);
    case SeaAnimal::manta:
      return manta_surface(phase);
    case SeaAnimal::jellyfish:
      return jellyfish_surface(phase);
  }
  return {};
}

std::string_view name_of(SeaAnimal animal) {
  constexpr std::string_view kNames[] = {"fish", "turtle", "manta", "jellyfish"};
  return kNames[static_cast<std::size_t>(animal)];
}

}  // namespace

int look_count(const FishParams& fish) { return fish.variation > 0 ? kLooks : 1; }

std::vector<FishLook> looks_of(const FishParams& fish) {
  if (look_count(fish) == 1) return {fish.look};
  std::vector<FishLook> all;
  for (int i = 0; i < kLooks; ++i)
    all.push_back(varied(fish.look, fish.variation, Seed{31}.child(static_cast<std::uint64_t>(i))));
  return all;
}

std::vector<Prototype> swimmer_prototypes(const FishParams& fish) {
  std::vector<std::string> pictures;
  std::vector<Color> colors;
  for (const FishLook& look : looks_of(fish)) {
    pictures.push_back(swimmer_picture_name(fish.animal, fish.form, look));
    colors.push_back(look.flank);
  }
  std::vector<Prototype> list;
  for (int shape = 0; shape < kShapes; ++shape) {
    Prototype made{std::string(name_of(fish.animal)), {}, colors, fish.look.back};
    made.parts.push_back({Tissue::leaf, shape_of(fish, shape), pictures});
    if (fish.animal == SeaAnimal::fish) made.parts[0].relief = fish_relief_name(fish.form, fish.look);
    made.luster = {.through = fish.animal == SeaAnimal::jellyfish ? 0.55 : 0.12,
                   .gloss = 0.9 * fish.look.gloss,
                   .relief = fish.animal == SeaAnimal::fish ? kRelief : 0.3 * fish.look.scales};
    list.push_back(std::move(made));
  }
  return list;
}

Organs school_organs(const SchoolParams& params, const Trajectory& trajectory, double time) {
  constexpr float kTurns = 0.7f;                    // radians a second from which its body is bent
  constexpr float kBank = 0.25f, kMostBank = 0.5f;  // radians it leans by, for one a second of turn; at most
  constexpr float kHangs = 0.35f;                   // share of its heading that a jellyfish leans by
  SeaAnimal animal = params.fish.animal;
  bool bends = animal == SeaAnimal::fish;
  int looks = look_count(params.fish);
  Organs organs;
  organs.reserve(static_cast<std::size_t>(trajectory.count));
  for (int i = 0; i < trajectory.count; ++i) {
    FishPose pose = fish_at(trajectory, i, time);
    float beats = pose.stroke - std::floor(pose.stroke);
    int phases = bends ? kTailPhases : kShapes;
    int phase = static_cast<int>(beats * static_cast<float>(phases) + 0.5f) % phases;
    int bend = !bends ? 0 : pose.turn > kTurns ? 2 : pose.turn < -kTurns ? 0 : 1;
    Vec3 ahead = pose.heading;
    if (animal == SeaAnimal::jellyfish) ahead = glm::normalize(Vec3(0, 1, 0) + kHangs * ahead);
    Vec3 side = glm::cross(ahead, Vec3(0, 1, 0));
    side = glm::length(side) > 1e-4f ? glm::normalize(side) : Vec3(1, 0, 0);
    // It leans into its turns.
    float bank = std::clamp(-kBank * pose.turn, -kMostBank, kMostBank);
    glm::mat3 axes(side, ahead, glm::cross(side, ahead));
    Quat turn = glm::normalize(glm::angleAxis(bank, ahead) * glm::quat_cast(axes));
    float length = static_cast<float>(params.fish.length) * pose.size;
    organs.prototype.push_back(static_cast<std::uint16_t>(bend * kTailPhases + phase));
    organs.position.push_back(pose.position);
    organs.turn.push_back(turn);
    organs.scale.push_back(Vec3(length));
    organs.node.push_back(Skeleton::kRoot);
    organs.birth.push_back(0);
    organs.color.push_back(i % looks);
    organs.id.push_back(0);  // all of one shade: after the film each takes another's place
  }
  return organs;
}

}  // namespace frond
