#pragma once

#include "core/seed.h"
#include "core/vec.h"

namespace frond {

/// Hills `hill_size` metres apart, about -1.5 to 1.5, as a sum of noises, each of half the size of the one
/// before. The rougher (0..1), the more they are folded into crests (Musgrave 1994, ridged multifractal) and
/// the more the small ones count; in valleys they count less, as what is washed down fills them. What lines
/// `spacing` metres apart cannot show is left out.
double hill_noise(Vec2 at, double hill_size, double rough, double spacing, Seed seed);

/// The hills of hill_noise() as running water leaves them: spurs and gullies lead down their flanks, smaller
/// ones down the flanks of these, and so on. `erosion` 0 is hill_noise(), 1 high mountains.
double eroded_hill_noise(Vec2 at, double hill_size, double rough, double erosion, double spacing, Seed seed);

}  // namespace frond
