#pragma once

#include "preset/describe.h"
#include "scene/preset.h"

// The outline of presets; see preset/describe.h.

namespace frond {

inline constexpr Choice<Quality> kQualities[] = {{"draft", Quality::draft, "a few seconds a frame"},
                                                 {"good", Quality::good, "smooth edges, soft shadows"},
                                                 {"best", Quality::best, "everything, slow"}};

inline constexpr Choice<Background> kBackgrounds[] = {
    {"scene", Background::scene, "the whole scene"},
    {"ground", Background::ground, "the ground, but neither sky, backdrop, haze nor far land"},
    {"transparent", Background::transparent, "nothing: what grows and stands there is alone"}};

/// The sides of a picture.
inline constexpr Range kSides{.min = 16, .max = 16384, .unit = "pixels"};

void describe(Properties& v, Film& f);
void describe_rest(KeyWriter& v, Focus& focus);
void describe(Properties& v, Orbit& o);
void describe(Properties& v, Rail& r);
void describe(Properties& v, Shake& s);
void describe(Properties& v, CameraMove& m);
void describe(Properties& v, NamedView& w);
void describe(Properties& v, Camera& c);
void describe(Properties& v, Wind& w);
void describe(Properties& v, Floor& f);
void describe(Properties& v, FarLandShape& f);
void describe(Properties& v, Snow& s);
void describe(Properties& v, Air& a);
void describe(Properties& v, Rain& r);
void describe(Properties& v, SceneSetup& s);

// The properties of plans and of stand dynamics, in files of their own.
void describe(Properties& v, RoomKind& r);
void describe(Properties& v, PlanText& p);
void describe(Properties& v, TreeText& t);
void describe(Properties& v, StandPlanting& p);
void describe(Properties& v, StandText& s);

/// Their colours count where they stand.
void describe_rest(KeyWriter&, Palettes&);

void describe(Properties& v, Preset& p);

}  // namespace frond
