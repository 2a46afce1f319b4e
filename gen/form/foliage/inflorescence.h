#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/curve.h"
#include "core/function_ref.h"
#include "core/seed.h"
#include "core/vec.h"

// Inflorescences by their type, after Owens, Cieslak, Hart, Classen-Bockhoff and Prusinkiewicz 2016,
// "Modeling dense inflorescences": flowers stand by rules of phyllotaxis and then make room for each other.
// The paper lets bodies of any shape collide while they grow; here each flower is a capsule, and one stage is
// found at a time.
//
// Metres and radians. The foot is at the origin, the axis starts along +y, and it arches toward -z.

namespace frond {

enum class InflorescenceType {
  raceme,          ///< flowers on stalks along an axis
  spike,           ///< without stalks
  corymb,          ///< lower stalks longer, so that all flowers are in one plane
  umbel,           ///< all stalks from one place
  compound_umbel,  ///< umbels that stand in an umbel
  panicle,         ///< racemes along an axis
  dichasium,       ///< below each flower two branches, each with a flower
  scorpioid,       ///< a coiled axis with flowers in two rows on its back
  capitulum,       ///< a head: a disc of florets, rays at its rim
  spadix           ///< florets all over a thick axis; a catkin
};

struct Inflorescence {
  InflorescenceType type = InflorescenceType::raceme;
  double length = 0.2;  ///< of the axis; of umbels, corymbs and heads of the stalk that bears them
  std::string flower;   ///< symbol of the organ that each flower is
  std::string ray;      ///< the same at the rim of a head; empty: none
  std::string bract;    ///< the same below each flower, or round an umbel or a head; empty: none
  int flowers = 20;     ///< rays are not counted
  int rays = 13;
  int involucre = 8;      ///< bracts round an umbel or a head
  double bare = 0.15;     ///< share of the axis below the lowest flower
  double pedicel = 0.01;  ///< length of a flower's stalk; of a spike, a head and a spadix there is none
  double angle = radians(60.0);  ///< between the axis and the oldest flower's stalk; of an umbel the widest
  std::optional<double> tip_angle;  ///< the same of the youngest, or of an umbel's umbels; none: 0.4 of it
  double divergence = radians(137.50776405);  ///< between neighbours along the axis, about it
  int whorl = 1;                              ///< flowers at each node
  int branches = 8;                           ///< of a panicle or a compound umbel
  double branch = 0.05;                       ///< length of the longest of them
  double width = 0.02;                        ///< of a head's disc or a spadix
  double dome = 0.4;                          ///< height of a head's disc, of its radius
  double stem = 0.003;                        ///< diameter of the axis at its foot
  double nod = 0;                             ///< angle by which flowers are turned down from their stalks
  double sided = 0;                           ///< 0 all round .. 1 all to the side that it arches to
  double arch = 0;                            ///< angle by which the axis bends from foot to tip
  double jitter = radians(5.0);               ///< random change of stalks' angles
  bool basipetal = false;                     ///< the youngest flowers are at the foot or the rim
  Curve stages =
      Curve({{0, 0}, {0.5f, 1}, {1, 1}});  ///< stage of a flower by its age, 0 youngest .. 1 oldest
  double least = 0.45;                     ///< size of a closed bud, as a share of the open flower's
};

/// The room that an organ takes: a capsule along its heading.
struct OrganRoom {
  double from = 0, to = 0;  ///< where along the heading its middle line begins and ends
  double radius = 0;
};

enum class FloretRole { flower, ray, bract };

/// The room of an organ of unit scale at a stage.
using RoomOf = FunctionRef<OrganRoom(FloretRole role, double stage)>;

/// A flower or a bract of an inflorescence.
struct LaidFloret {
  FloretRole role = FloretRole::flower;
  Vec3 at{0}, heading{0, 1, 0}, up{0, 0, 1};  ///< directions of length 1, square to each other
  double scale = 1;                           ///< factor of the organ's size
  double stage = 1;
  std::int32_t node = -1;  ///< that bears it; -1: what bears the inflorescence
};

/// A node of its stalks; parents come first.
struct LaidNode {
  Vec3 at{0};
  double radius = 0;
  std::int32_t parent = -1;  ///< -1: what bears the inflorescence
  std::uint16_t order = 0;   ///< depth of branching
};

struct LaidInflorescence {
  std::vector<LaidNode> nodes;
  std::vector<LaidFloret> florets;
};

/// Lays an inflorescence whose flowers do not cut through each other: those that would are turned aside and
/// their stalks stretched; florets of heads and spadices, which have no stalks, are made smaller. `later` is
/// added to the stages of all flowers; `down` is the direction of gravity.
LaidInflorescence lay_inflorescence(const Inflorescence& params, double later, Vec3 down, RoomOf room,
                                    Seed seed);

/// How deep two of the florets' rooms reach into each other at most, as a share of the smaller radius. Bracts
/// do not count.
double deepest_overlap(const LaidInflorescence& laid, RoomOf room);

}  // namespace frond
