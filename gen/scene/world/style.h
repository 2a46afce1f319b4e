#pragma once

namespace frond {

/// How branches are drawn.
enum class Build {
  sweeps,  ///< each branch separately, round
  fused,   ///< one body, rounded where branches meet
  rough,   ///< one body with the steps of a coarse grid
  voxels   ///< cubes
};

/// How the branches of an organism become a body.
struct Style {
  Build build = Build::sweeps;
  double voxel = 0;          ///< metres; 0: chosen by the size of the organism
  double blend = 1;          ///< fillets at forks, as a share of the thinner branch's radius; 0: creases
  double adaptivity = 0.05;  ///< of a fused mesh: 0 triangles of a voxel's size .. 1 few
  double roughness = 0.7;    ///< of a rough body: 0 the plain mesh of its volume .. 1 the steps of its voxels
  double limit = 4e9;        ///< bytes of memory that the volume may take
};

}  // namespace frond
