#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/ground.h"
#include "geometry/plot.h"
#include "geometry/stone.h"
#include "geometry/turf.h"
#include "growth/swing.h"
#include "model/model.h"
#include "motion/motion.h"
#include "scene/preset.h"

namespace frond {

/// How a plant that grows by steps is grown anew for each frame.
struct Stages {
  PlantParams params;
  Seed seed;
  Vec3 foot{0};
  Quat turn{1, 0, 0, 0};
  float size = 1;
};

/// How a tree came to be, for films.
struct TreeLife {
  TreeParams params;
  GrownTree tree;
  int years = 0;  ///< of its grove
  Seed look;
};

/// How ivy that hangs swings in the wind.
struct Creeper {
  Strands strands;
  Breeze breeze;
};

/// One grown organism, or built body, where it stands.
struct Branches {
  std::string name;
  Skeleton rest;  ///< at its place in the world, fully grown, unmoved
  Motion motion;
  Style style;               ///< its voxel is never 0
  std::optional<Skin> skin;  ///< of a coral
  double brightness = 1;     ///< factor, its own

  std::size_t entry = 0;         ///< which of the preset's organisms it is one of
  std::optional<Bark> bark;      ///< of a plant
  std::optional<BarkCoat> coat;  ///< of a tree whose branches are meshes with a picture
  int lobes = 0;                 ///< of the trunk's cross-section, where there is a coat
  double lobe_depth = 0;
  BladeParams blade_look;
  std::vector<std::int32_t> color;  ///< of each node; empty: 0 for all
  std::vector<float> girth;         ///< as that of a Model
  std::vector<Prototype> prototypes;
  Organs organs;
  Blades blades;
  Solids solids;
  Surface hull;                          ///< what creepers hold on to where that is not the solids themselves
  std::vector<std::string> notes;        ///< of its grower
  std::optional<Creeper> creeper;        ///< of ivy: what `rest` is, and where it holds on
  std::optional<Stages> stages;          ///< of what grows by steps; all else above is how it ends
  std::shared_ptr<const TreeLife> life;  ///< of a tree that grows in the film; as for `stages`
  std::optional<Seasons> season;         ///< where given, `organs` are in full leaf
  Seed season_seed;
  std::shared_ptr<const Heights> ground;  ///< on which its leaves fall

  /// Whether it is another shape in each frame; see developed().
  bool develops() const { return stages || life || season; }
};

/// The outside of the bodies that it is, without `uv`; empty where it is none.
Surface skin_of(const Branches& branches);

/// The branches of an organism as they are at a time.
void pose_branches(const Branches& branches, double time, Pose& pose);

/// The organism as it is at a time: itself, or what its steps have come to by then, fully revealed.
Result<Branches> developed(const Branches& branches, double time);

/// A patch of grass, gravel or litter put somewhere on the ground.
struct TurfInstance {
  int shape = 0;  ///< index into Scene::turf, gravel, litter or moss
  Vec3 at{0};
  double turn = 0;  ///< radians about the vertical
  Vec2 slope{0};    ///< of the ground, along x and z
};

/// A stone shape put somewhere in the world.
struct StoneInstance {
  int shape = 0;  ///< index into Scene::stones
  Vec3 at{0};
  Vec3 size{1};     ///< factors along the stone's own axes, metres
  double turn = 0;  ///< radians about the vertical
  int look = 0;     ///< which of the rock textures
};

/// Copies of the models of a stand: a structure of arrays. Metres.
struct Copies {
  std::vector<std::uint16_t> model;
  std::vector<Vec3> foot;
  std::vector<Quat> turn;
  std::vector<float> scale;
  std::vector<std::uint8_t> tint;  ///< 0..kTints - 1

  std::size_t size() const { return model.size(); }
};
inline constexpr int kTints = 12;  ///< colours that copies of a stand come in

/// An organism that is sown: where its copies stand. Its models are grown when they are written.
struct SownStand {
  std::size_t entry = 0;  ///< which of the preset's organisms
  Organism organism;      ///< that one
  Copies copies;
};

/// All that stands before the camera, grown; nothing of it depends on the frame.
struct Scene {
  Film film;
  Stage stage;
  Surface floor;
  std::vector<Surface> stones;
  std::vector<StoneInstance> stone_instances;
  std::vector<Turf> turf;
  std::vector<TurfInstance> turf_instances;
  std::vector<Surface> gravel;  ///< of a garden's path, as squares
  std::vector<TurfInstance> gravel_instances;
  std::vector<Surface> litter;  ///< of a forest's floor: leaves and twigs
  std::vector<TurfInstance> litter_instances;
  std::vector<Surface> moss;  ///< of a forest's floor: cushions
  std::vector<TurfInstance> moss_instances;
  Plot plot;  ///< of a garden
  std::vector<Branches> branches;
  std::vector<SownStand> stands;
  std::vector<Drawing> drawings;   ///< pictures that frames name, to be put beside them
  std::vector<std::string> notes;  ///< what the user should know of how it was built

  /// Nodes of all skeletons.
  std::size_t nodes() const;
};

/// Whom build_scene tells how far it is.
struct Watch {
  std::function<void(std::string_view phase, std::size_t steps)> begin;
  std::function<void()> step;  ///< one more of the phase is done; called from several threads
};

/// Places and grows everything: the phases "place" and "grow".
Result<Scene> build_scene(const Preset& preset, const Watch& watch = {[](auto, auto) {}, [] {}});

}  // namespace frond
