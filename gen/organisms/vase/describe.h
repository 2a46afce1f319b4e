#pragma once

#include "organisms/vase/vase.h"
#include "preset/reader.h"

// The properties of vessels, as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr Choice<VaseMaterial> kVaseMaterials[] = {
    {"ceramic", VaseMaterial::ceramic, "glazed"},
    {"terracotta", VaseMaterial::terracotta, "bare fired clay"},
    {"glass", VaseMaterial::glass, "clear, with the colour of its thickness"}};

inline constexpr Choice<VaseForm> kVaseForms[] = {
    {"either", VaseForm::either,
     "turned where that is exact (degree 3 and less, no bands), a mesh elsewhere"},
    {"mesh", VaseForm::mesh, "triangles"},
    {"turned", VaseForm::turned, "Bézier curves that POV-Ray turns; bands are not drawn on them"}};

inline constexpr Choice<Motif> kMotifs[] = {{"plain", Motif::plain, "nothing but the colour"},
                                            {"zigzag", Motif::zigzag, "a line up and down"},
                                            {"waves", Motif::waves, "running waves"},
                                            {"dots", Motif::dots, "round dots"},
                                            {"meander", Motif::meander, "the Greek key"},
                                            {"petals", Motif::petals, "upright petals side by side"},
                                            {"rings", Motif::rings, "three thin lines"}};

template <class Visitor>
void describe(Visitor& v, Band& b) {
  v.number("at", b.at, {.min = 0, .max = 1}, "Its middle, as a share of the vessel's height");
  v.number("width", b.width, {.min = 0.001, .max = 1}, "As a share of the vessel's height");
  v.color("color", b.color, "Colour");
  v.choice("motif", b.motif, kMotifs, "What is painted");
  v.integer("repeats", b.repeats, {.min = 1, .max = 400}, "How often, once round");
}

template <class Visitor>
void describe(Visitor& v, VaseParams& p) {
  VesselShape& s = p.shape;
  v.list("profile", s.profile, {.min = 2, .max = 21},
         "Control points [radius, height] of the Bézier curve that is turned, from the foot to the lip");
  v.number("height", s.height, {.min = 0, .max = 20, .unit = "m"},
           "What the curve is scaled to; 0: its points are metres");
  v.number("wall", s.wall, {.min = 0.0005, .max = 1, .unit = "m"},
           "Thickness; held to what the bends and the neck of the curve allow");
  v.number("lip", s.lip, {.min = 1, .max = 8}, "Thickness of the rounded lip, as a multiple of the wall's");
  v.number("foot", s.foot, {.min = 0, .max = 2, .unit = "m"}, "Height of the ring that it stands on");
  v.number("foot_radius", s.foot_radius, {.min = 0, .max = 10, .unit = "m"},
           "Of that ring; 0: that of the curve's foot, or a third of its widest");
  v.integer("sides", s.sides, {.min = 3, .max = 1024}, "Of the mesh, round it");
  v.integer("rings", s.rings, {.min = 24, .max = 1024}, "Of the mesh, up the curve");
  v.choice("material", p.material, kVaseMaterials, "What it is made of");
  v.color("color", p.color, "Of glaze, clay or glass");
  v.color("second", p.second, "Of the bare clay under a glaze, of the salts on clay");
  v.number("crackle", p.crackle, {.min = 0, .max = 1},
           "0 an even glaze to 1 one with cracks, spots and runs");
  v.number("moss", p.moss, {.min = 0, .max = 1}, "Green on clay");
  v.number("gloss", p.gloss, {.min = 0, .max = 1}, "0 matt to 1 brilliant");
  v.number("variation", p.variation, {.min = 0, .max = 0.9}, "How much single ones differ in brightness");
  v.list("bands", p.bands, "Painted round it");
  v.number("soil", p.soil, {.min = 0, .max = 1}, "Share of its height that is filled with earth; 0: empty");
  v.choice("form", p.form, kVaseForms, "How it is handed to POV-Ray");
}

}  // namespace frond
