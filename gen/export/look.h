#pragma once

#include <string>
#include <string_view>

#include "dress/dress.h"
#include "export/export_scene.h"
#include "organisms/organism.h"

namespace frond {

/// A name of letters, digits, - and _ alone; `otherwise` where nothing is left of it.
std::string plain_name(const std::string& name, std::string_view otherwise);

Color scaled(Color color, double factor);

/// The colour of a coral as povinc/frond_coral.inc has it.
Color tinted(const Tint& tint, double brightness);

/// By how much more light growing tips give back than old skin, channel by channel, as povinc/ has it: of a
/// skin, or of one of a bark's colours. 1 where tips are as the rest.
Vec3 young_light(const Look& look, std::size_t color);

/// How a bark shines: its gloss, and whether it is of metal.
double bark_gloss(const Bark& bark);
bool is_metal(const Bark& bark);

/// Whether a tissue is a thin sheet, seen from both sides.
bool is_leaf(Tissue tissue);

}  // namespace frond
