#include "organisms/coral/coral.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "geometry/smooth.h"
#include "grammar/figure.h"
#include "grammar/review.h"

namespace frond {

namespace {

GrammarText coral_text(const CoralParams& params) {
  GrammarText text = params.form == CoralForm::own ? params.grammar : GrammarText{};
  text.where = params.grammar.where;
  if (params.form != CoralForm::own) {
    text.axiom = "A";
    text.steps = params.steps;
    text.numbers = {{"pitch", degrees(params.pitch)}, {"roll", degrees(params.roll)}};
    auto rules = [&](std::initializer_list<std::string> list) {
      for (const std::string& rule : list) text.rules.emplace_back().text = rule;
    };
    const std::string turn = "/(roll)/(roll)/(roll)/(roll)";
    if (params.form == CoralForm::branching) {
      rules({"A -> !\"[B]" + turn + "[B]" + turn + "B", "B -> &(pitch)FFFA"});
      text.steps *= 2;  // a whole fork takes both rules
    } else {
      rules({"A -> \"[&(pitch)FFFA]" + turn + "[&(pitch)FFFA]" + turn + "[&(pitch)FFFA]"});
    }
    text.length = params.internode;
    text.width = 1;
    text.width_scale = params.width_scale;
    text.length_scale = params.length_scale;
    text.angle_jitter = degrees(params.angle_jitter);
    text.length_jitter = params.length_jitter;
    text.tropism = DVec3(0, 1, 0);
    text.elasticity = params.lift;
  }
  return text;
}

void scale_to_height(Skeleton& s, double height) {
  float top = 0;
  for (const Vec3& p : s.position) top = std::max(top, p.y);
  if (height <= 0 || top <= 0) return;
  float factor = static_cast<float>(height) / top;
  for (Vec3& p : s.position) p *= factor;
}

/// C8: the noise counts more the farther along the branch, so that the foot stays planted.
void distort(Skeleton& s, const Distortion& distortion, Seed seed) {
  if (distortion.strength <= 0) return;
  Vec3 shift(seed.child("x").range(-99, 99), seed.child("y").range(-99, 99), seed.child("z").range(-99, 99));
  float longest = std::max(s.longest(), 1e-6f), frequency = static_cast<float>(1 / distortion.scale);
  for (std::size_t i = 0; i < s.size(); ++i) {
    float share = s.distance[i] / longest;
    s.position[i] +=
        noise3(s.position[i] * frequency + shift) * (static_cast<float>(distortion.strength) * share);
  }
}

/// The turtle's width, relative to the one it starts with, counts as a factor.
void thicken(Skeleton& s, const Thickness& thickness, float start_radius) {
  float longest = std::max(s.longest(), 1e-6f), base = static_cast<float>(thickness.radius);
  constexpr float kKnobLength = 3, kFootHeight = 2.5f;  // radii: of the branch, of the foot
  float knob = static_cast<float>(thickness.knob), flare = static_cast<float>(thickness.flare);
  for (std::size_t i = 0; i < s.size(); ++i) {
    float left = 1 - s.distance[i] / longest;
    float radius = base * static_cast<float>(thickness.curve(left)) * s.radius[i] / start_radius;
    radius *= 1 + (knob - 1) * (1 - smooth_step(0.0f, kKnobLength * radius, s.to_tip[i]));
    radius *= 1 + flare * (1 - smooth_step(0.0f, kFootHeight * base, s.distance[i]));
    s.radius[i] = std::max(radius, 1e-4f);
  }
}

}  // namespace

Result<Grammar> coral_grammar(const CoralParams& params) { return compile(coral_text(params)); }

Result<Skeleton> grow_coral(const CoralParams& params, Seed seed, const Environment& environment) {
  Result<Grammar> grammar = coral_grammar(params);
  if (!grammar) return grammar.errors();
  grammar->environment = environment;
  const GrammarText& text = grammar->text;
  Result<Word> word = derive(*grammar, text.steps, seed.child("derive"), text.limits);
  if (!word) return placed(word.errors(), text);
  Result<Skeleton> drawn = skeleton_of(*grammar, *word, seed.child("turtle"));
  if (!drawn) return placed(drawn.errors(), text);
  *word = {};
  Skeleton coarse = std::move(*drawn);
  if (coarse.size() == 0) return Error{text.where, "the grammar draws nothing: its turtle never meets an F"};
  float start_radius = static_cast<float>(text.width / 2);
  scale_to_height(coarse, params.height);
  set_distances(coarse);
  distort(coarse, params.distortion, seed.child("distort"));
  Skeleton fine = smooth(coarse, params.smoothing);
  coarse = {};
  set_tip_distances(fine);
  thicken(fine, params.thickness, start_radius);
  set_births(fine);
  for (std::size_t i = 0; i < fine.size(); ++i)
    if (!std::isfinite(glm::dot(fine.position[i], fine.position[i])) || !std::isfinite(fine.radius[i]))
      return placed(out_of_range(), text);
  return fine;
}

}  // namespace frond
