#pragma once

#include "appearance/fish_look.h"

namespace frond {

/// Animals that swim in a school.
enum class SeaAnimal { fish, turtle, manta, jellyfish };

/// Texture coordinates of a point on a turtle or a manta as seen from above or from below: `along` from its
/// nose, `aside` from its middle line, in its own units.
Vec2 plan_uv(double along, double aside, bool above);
/// Texture coordinates of eyes, which are dark.
Vec2 eye_uv();

/// The parts of a jellyfish's picture.
enum class JellyPart { bell, arm, tentacle };
/// Texture coordinates there: round the bell or across the part, and from its root 0 to its end 1, both 0..1.
Vec2 jelly_uv(JellyPart part, double across, double along);

/// Half the width of a turtle's shell at a share of its length from the front, and where it begins and ends
/// from the nose, in lengths of the turtle.
double shell_width(double share);
inline constexpr double kShellFrom = 0.2, kShellTo = 0.97;

/// The picture that an animal is painted with, and its name. The form counts for fish only.
Drawing swimmer_drawing(SeaAnimal animal, const FishForm& form, const FishLook& look);
std::string swimmer_picture_name(SeaAnimal animal, const FishForm& form, const FishLook& look);

/// The same in other colours, each of red, green and blue changed by up to `variation` of itself, and with
/// marks of other widths a little elsewhere.
FishLook varied(const FishLook& look, double variation, Seed seed);

}  // namespace frond
