#pragma once

#include <optional>
#include <vector>

#include "core/curve.h"
#include "model/model.h"

// A flower by its floral diagram (Ijiri, Owens, Okabe and Igarashi 2005, "Floral diagrams and
// inflorescences"): whorls of members round one axis, from outside to inside. We depart from the paper in
// that a member's shape is given by numbers, not drawn, and in that one diagram holds for all stages from the
// bud to the withered flower.
//
// Lengths are shares of the flower's size, angles are radians. The flower's foot is at the origin, its axis
// is +y, and its median plane is x = 0: +z is the upper side, which is next to the axis that bears it. The
// azimuth of a member is its angle about the axis from +z toward +x.

namespace frond {

/// What the members of a whorl are.
enum class FloralPart { sepals, tepals, petals, stamens, carpels };

/// How neighbours of a whorl lie in the bud, and where they overlap when it is open.
enum class Aestivation {
  valvate,    ///< edge to edge, none over another
  imbricate,  ///< some outside, some inside; of two sides of a bilateral whorl, the upper outside
  contorted   ///< each over its neighbour on one side and under that on the other
};

/// What the members on one side of the median plane have otherwise than the rest of their whorl.
struct MemberSide {
  double length = 1, width = 1;  ///< factors
  std::optional<double> open, bend, fold, cup;
  std::vector<Color> colors;  ///< empty: those of the whorl
  std::optional<Color> second;
};

/// Spots on the upper side of a whorl's members.
struct Marks {
  int count = 12;               ///< on each member
  double size = 0.02;           ///< diameter
  double from = 0.2, to = 0.7;  ///< where along the member
  double across = 0.7;          ///< of its half width, from the midrib
  Color color{0.35f, 0.06f, 0.22f};
  bool upper = true, side = true, lower = true;  ///< which sides of a bilateral whorl bear them
};

/// Members that stand in the spiral of the golden angle: what the innermost has; those between are between.
struct Spiral {
  double length = 0.6;  ///< factor of the outermost's length
  double open = radians(10.0);
  double rise = 0.05;  ///< how much higher it stands
};

/// Members of one kind round the axis.
struct Whorl {
  FloralPart part = FloralPart::petals;
  int count = 5;
  double length = 1;
  std::optional<double> at;  ///< height above the flower's foot, may be below; none: above the whorl before
  std::optional<double>
      radius;  ///< distance of its members' feet from the axis; none: the receptacle's there
  std::optional<double>
      open;  ///< angle between the axis and a member's foot in the open flower; none: as usual
  double bend = radians(15.0);  ///< from there to its tip, outward
  std::optional<double> turn;   ///< against the whorl before; none: half a step, so that they alternate
  std::optional<double> width;  ///< of its length; none: default of the part
  double widest = 0.6;          ///< where along it
  double round = 0.8;           ///< 0 drawn out to a tip .. 1 round
  double notch = 0;             ///< depth of a notch in the tip
  double fold = 0;              ///< by which each half is raised
  double cup = 0.2;             ///< how much it is hollowed like a spoon, 0..1
  double wave = 0;              ///< of the rim, 0..1
  int detail = 2;               ///< 1..3
  std::optional<double> fused;  ///< share of the length that is one tube; none: carpels all, others nothing
  std::optional<Curve> tube;    ///< radius, of the whorl's length, over the share of the tube; none: a funnel
  double slant = 0;             ///< how much longer the lower side of the tube is, of the length
  std::optional<double> head;   ///< length of anthers, width of stigmas; none: default of the part
  Aestivation aestivation = Aestivation::imbricate;
  std::optional<Spiral> spiral;
  std::optional<MemberSide> upper, side, lower;  ///< any of them makes the whorl bilateral
  bool falls = false;                            ///< its members are gone once the flower has withered
  std::vector<Color> colors;                     ///< empty: default of the part
  std::optional<Color> second;  ///< at the foot of a petal, veins of a sepal, anthers, stigmas
  std::optional<Luster> luster;
  std::optional<Marks> marks;

  bool bilateral() const { return upper || side || lower; }
};

/// The end of the stalk that bears the whorls: a dome.
struct Receptacle {
  double radius = 0.04, height = 0.04;
  Color color{0.45f, 0.55f, 0.25f};
};

struct FloralDiagram {
  std::vector<Whorl> whorls;  ///< from outside to inside
  Receptacle receptacle;
  double bud = 0.3;  ///< width of the closed bud
  int stages = 8;    ///< steps from the bud to the open flower, and half as many until it has withered
  Color faded{0.50f, 0.36f, 0.20f};  ///< what petals turn to as they wither
};

/// A stage of a flower: 0 a closed bud, 1 open, 2 withered.
inline constexpr double kWithered = 2;

/// Azimuths of a whorl's members; the first whorl has one on the upper side.
std::vector<double> azimuths(const FloralDiagram& diagram, std::size_t whorl);

/// Which side of the median plane a member of that azimuth is on.
enum class Side { upper, side, lower };
Side side_of(double azimuth);

/// How many prototypes a whorl is: one or, where its sides have colours of their own, some, and its marks.
int pieces_of(const FloralDiagram& diagram, std::size_t whorl);

/// The shapes of a flower at a stage, one unit in size: the pieces of each whorl, last the receptacle if it
/// has a radius. How many there are, and their colours' number, depend on no stage; what has fallen has no
/// triangles.
std::vector<Prototype> flower_prototypes(const FloralDiagram& diagram, double stage);

}  // namespace frond
