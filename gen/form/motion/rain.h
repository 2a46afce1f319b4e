#pragma once

// Rain as a law: how many drops of which size are in the air, how fast they fall, and how much light they
// take. `rate` is mm/h: 1 a drizzle, 5 steady rain, 20 a shower, 100 a cloudburst. Diameters are millimetres.

namespace frond {

/// Drops in a cubic metre, by millimetre of their diameter: 8000 exp(-4.1 R^-0.21 D) (Marshall and Palmer
/// 1948). 0 where it does not rain.
double drop_density(double rate, double diameter);

/// Those of them that are thicker than a diameter.
double drops_thicker(double rate, double diameter);

/// The diameter that a drop among those thicker than `least` has, `order` of which are thicker still, 0..1.
double drop_diameter(double rate, double least, double order);

/// Metres a second at which a drop falls in still air: 9.65 - 10.3 exp(-0.6 D) (Atlas, Srivastava and Sekhon
/// 1973); at least 0.1, as the law is one of drops of 0.6 to 5.8 mm.
double terminal_speed(double diameter);

/// Drops thicker than a diameter that land on a square metre in a second.
double drops_landing(double rate, double diameter);

/// Light that is lost along a metre, by twice the cross sections of the drops.
double rain_extinction(double rate);

/// Share of the sky that the clouds of such a rain take, 0..1: all of it from 1 mm/h on.
double rain_clouds(double rate);

/// How wet things are in the open on which so many millimetres have fallen, 0..1.
double wetness(double fallen);

}  // namespace frond
