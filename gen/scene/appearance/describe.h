#pragma once

#include "appearance/appearance.h"
#include "appearance/health.h"
#include "geometry/girth.h"
#include "preset/describe.h"

// The properties of the appearance and motion of organisms as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, Polyps& p);
void describe(Properties& v, Pores& p);
void describe(Properties& v, ColorCourse& t);
void describe(Properties& v, Health& h);
void describe(Properties& v, Tint& t);
void describe(Properties& v, Skin& s);
void describe(Properties& v, Growth& g);
void describe(Properties& v, Wave& w);
void describe(Properties& v, FoodPlace& f);
void describe(Properties& v, Food& f);
void describe(Properties& v, Girth& g);
void describe(Properties& v, Bark& b);
void describe(Properties& v, BarkChange& b);
void describe(Properties& v, BladeLook& b);
void describe(Properties& v, Sprig& s);
void describe(Properties& v, Luster& l);
void describe(Properties& v, LeafLook& l);
void describe(Properties& v, BarkImage& b);
void describe(Properties& v, BarkCoat& c);
void describe(Properties& v, Blossom& b);
void describe(Properties& v, Flowering& f);
void describe(Properties& v, Fruiting& f);
void describe(Properties& v, Seasons& s);
void describe(Properties& v, TreeAppearance& d);

}  // namespace frond
