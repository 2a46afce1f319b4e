#pragma once

#include "appearance/leaf_look.h"
#include "preset/describe.h"

namespace frond {

enum class TailShape { forked, lunate, round, square, shark };
enum class DorsalShape { spiny, sail, ribbon };
enum class FishPattern { plain, bars, lines, spots, net };

/// Outline of a fish from the side. Lengths as shares of the whole length, from the nose to the end of the
/// tail.
struct FishForm {
  double depth = 0.36;  ///< of the body, from belly to back, without fins
  double arch = 0.12;   ///< by how much the back is more arched than the belly, as a share of half the depth
  double width = 0.38;  ///< of the body, as a share of its depth
  double deepest = 0.36;   ///< position of the greatest depth, as a share of the body from the nose
  double snout = 0.3;      ///< 0 blunt .. 1 a long beak
  double peduncle = 0.26;  ///< depth of the body before the tail, as a share of the greatest depth
  TailShape tail = TailShape::forked;
  double tail_depth = 0.36;  ///< from tip to tip
  DorsalShape dorsal_shape = DorsalShape::spiny;
  double dorsal = 0.09;       ///< height of the fin on the back
  double dorsal_from = 0.28;  ///< where it begins
  double dorsal_to = 0.75;    ///< where it ends
  double sweep = 0;           ///< how far the tips of the fins on back and belly trail behind
  double anal = 0.08;         ///< height of the fin below the tail
  double pectoral = 0.14;     ///< length of the fins at the sides
  double spread = 1;          ///< how far these stand off the body, times the usual
};

void describe(Properties& v, FishForm& f);

/// Share of the length at which the body ends and the tail begins.
inline constexpr double kFishBody = 0.8;

/// Half the depth of the body as a share of the length, at a position 0..1 from the nose.
double fish_depth(const FishForm& form, double at);

/// How far the body reaches above the line from nose to tail, `side` 1, or below it, -1.
double fish_height(const FishForm& form, double at, double side);

/// How far a fin reaches beyond the body there; 0 where there is no fin.
double dorsal_height(const FishForm& form, double at);
double anal_height(const FishForm& form, double at);

/// A spot of one colour on a fish: a saddle, a band through the eye, a blotch.
struct FishPatch {
  Color color{0.04f, 0.04f, 0.05f};
  Vec2 at{0.5f, 0.5f};    ///< of its middle: share of the length; of the depth there, from below
  Vec2 size{0.1f, 0.4f};  ///< its width and height, likewise
  double slant = 0;       ///< how far its top lies behind its foot, as a share of the length
  double soft = 0.1;      ///< of its edge, as a share of its size
};

void describe(Properties& v, FishPatch& p);

/// Colours and pattern of a fish.
struct FishLook {
  Color back{0.10f, 0.30f, 0.66f};
  Color flank{0.30f, 0.66f, 0.94f};
  Color belly{0.70f, 0.90f, 0.98f};
  Color fins{0.35f, 0.62f, 0.88f};
  Color tail{0.35f, 0.62f, 0.88f};
  double tail_from = 0.84;  ///< share of the length at which the colour of the tail begins
  FishPattern pattern = FishPattern::plain;
  Color mark{0.95f, 0.95f, 0.95f};  ///< of bars or lines
  Color edge{0.04f, 0.04f, 0.05f};  ///< of the edge round them
  double edging = 0;                ///< width of the edge, as a share of a bar's
  int marks = 3;                    ///< number of bars or lines
  double mark_width = 0.07;         ///< of each, as a share of the length
  double mark_from = 0.2;           ///< position of the first; bars from the nose, lines from the belly
  double mark_to = 0.78;            ///< position of the last
  double mark_slant = 0;  ///< by how much lines rise toward the head, or bars lean forward, over the fish
  double mark_bow = 0;    ///< by how much they are bowed
  std::vector<FishPatch> patches;  ///< over all that, the last on top
  bool marked_fins = false;        ///< whether bars continue on the fins
  Color iris{0.85f, 0.80f, 0.55f};
  double eye = 0.055;   ///< its width, as a share of the length
  double scales = 0.5;  ///< strength of the scales
  double gloss = 0.16;  ///< 0 matt .. 1 wet and polished
  double clear = 0.35;  ///< how much is seen through the skin of the fins: 0 nothing .. 1 all
  int pixels = 512;     ///< of the picture, along the fish
};

void describe(Properties& v, FishLook& l);

/// Height of the picture of a fish, in its lengths, and the corner of it that holds a fin at the sides, in
/// texture coordinates.
inline constexpr double kFishSpan = 1.1;
inline constexpr struct { double left, low, wide, high; } kSideFin{0.008, 0.86, 0.12, 0.13};

/// Texture coordinates of a point on the side of a fish: `along` from the nose 0 to the tail 1, `up` from the
/// line between them.
Vec2 fish_uv(double along, double up);
/// Those of a fin of a pair at the sides, in the corner above the head: across its rays and along them, 0..1.
Vec2 side_fin_uv(double across, double along);

/// The middle of the eye: share of the length from the nose, and above the line to the tail.
Vec2 fish_eye(const FishForm& form);

/// The picture of a fish from the side, and its name. Its fins let light through between their rays.
Drawing fish_drawing(const FishForm& form, const FishLook& look);
std::string fish_picture_name(const FishForm& form, const FishLook& look);

/// Its heights, the same for all colours: scales, gill cover, lips, rays of the fins.
Drawing fish_relief(const FishForm& form, const FishLook& look);
std::string fish_relief_name(const FishForm& form, const FishLook& look);

}  // namespace frond
