#include "appearance/describe.h"
#include "organisms/asking.h"
#include "organisms/colony.h"
#include "organisms/coral/coral.h"
#include "organisms/describe_grammar.h"
#include "organisms/grammar_faults.h"
#include "organisms/kinds.h"

namespace frond {

inline constexpr Choice<CoralForm> kCoralForms[] = {
    {"branching", CoralForm::branching, "A -> !\"[B]////[B]////B, B -> &FFFA"},
    {"tufted", CoralForm::tufted, "A -> \"[&FFFA]////[&FFFA]////[&FFFA]"},
    {"own", CoralForm::own, "the rules under grammar"}};

void describe(Properties& v, Thickness& t) {
  v.number("radius", t.radius, {.min = 0, .max = 5, .above_min = true, .unit = "m"}, "Radius at the base");
  v.curve("curve", t.curve,
          "Share of the radius by the way to the farthest tip, from 0 at that tip to 1 at the base");
  v.number("knob", t.knob, {.min = 0.1, .max = 4},
           "Factor of the thickness right at each tip; above 1 makes knobs");
  v.number("flare", t.flare, {.min = 0, .max = 4},
           "How much wider the foot is than the stem above it, as a share");
}

void describe(Properties& v, Distortion& d) {
  v.number("strength", d.strength, metres(0, 10), "How far noise bends the tips");
  v.number("scale", d.scale, {.min = 0, .max = 100, .above_min = true, .unit = "m"},
           "Distance from one bend to the next");
}

void describe(Properties& v, CoralParams& c) {
  v.choice("form", c.form, kCoralForms, "The rules that it grows by");
  v.integer("steps", c.steps, {.min = 1, .max = 12},
            "How often it forks; each step makes three branches of one. Not with \"form\": \"own\", whose "
            "grammar has steps of its own");
  v.angle("pitch", c.pitch, {.min = -180, .max = 180},
          "Angle by which & turns a new branch away from its parent");
  v.angle("roll", c.roll, {.min = -180, .max = 180},
          "Angle by which one of the four / between branches rolls");
  v.angle("angle_jitter", c.angle_jitter, {.min = 0, .max = 90}, "Random change of each turn, either way");
  v.number("length_jitter", c.length_jitter, {.min = 0, .max = 0.95},
           "Random change of each internode, as a share of it");
  v.number("internode", c.internode, metres(0.0001, 100), "Length that one F draws");
  v.number("length_scale", c.length_scale, {.min = 0.2, .max = 3}, "Factor by which \" multiplies lengths");
  v.number("width_scale", c.width_scale, {.min = 0.2, .max = 2},
           "Factor by which ! multiplies the thickness");
  v.number("lift", c.lift, {.min = -1, .max = 1},
           "How much each internode turns upward; negative turns it down");
  v.number("height", c.height, metres(0, 1000),
           "Height that the whole is scaled to; 0 leaves it as it grows");
  v.integer("smoothing", c.smoothing, {.min = 1, .max = 16},
            "Number of nodes that each internode is rounded with");
  v.origin(c.grammar.where, "steps");
  v.given("grammar", c.own_rules);
  v.object("grammar", c.grammar, "Rules of your own. Needs \"form\": \"own\", and no other form may have it");
  v.object("thickness", c.thickness, "Thickness along the branches");
  v.object("distortion", c.distortion, "Noise that bends the shape");
  v.object("skin", c.skin, "Pores and colours of the skin");
  v.object("wave", c.wave, "Swaying in the current");
  v.object("food", c.food, "What the branches bend toward");
  v.object("growth", c.growth, "When it grows in the film");
  if (asks(c.grammar)) v.aspect(Aspect::shape, "food", "growth");
}

namespace {

Result<SizeEstimate> word_size(const CoralParams& params, Seed seed) {
  return estimate_word(coral_grammar(params), seed, params.smoothing);
}

class CoralGrower final : public Described<CoralParams, ColonyGrower> {
 public:
  static constexpr std::string_view kLeading[] = {
      "form",           "steps",     "height",       "pitch",       "roll",
      "angle_jitter",   "internode", "length_scale", "width_scale", "thickness/radius",
      "thickness/knob", "lift"};

  GrowerTraits traits() const override { return colony({.branches = true}); }
  Review review() const override {
    bool own = params.form == CoralForm::own;
    if (own && params.grammar.where.ends_with("/steps"))
      return {{{"/form", "found \"own\" and no rules; expected a \"grammar\""}}};
    if (!own && params.own_rules)
      return {{{"/grammar",
                "found rules, but the coral grows by those of its form; expected \"form\": \"own\""}}};
    Result<Grammar> grammar = coral_grammar(params);
    if (grammar)
      if (Errors errors = check_asking(*grammar, params.height); !errors.empty()) return {errors};
    Errors errors = grammar ? size_faults(*grammar) : grammar.errors();
    if (own)
      errors = pointed(params.grammar, std::move(errors));
    else
      for (Error& error : errors) error.where.clear();  // its rules are ours
    return {errors, grammar ? pointed(params.grammar, grammar->warnings) : Errors{}};
  }
  Result<SizeEstimate> estimate_size(Seed seed) const override {
    Result<SizeEstimate> coral = word_size(params, seed);
    if (coral) coral->riding = true;
    return coral;
  }
  std::shared_ptr<const Grower> coarse(double share) const override {
    constexpr auto steps = [](CoralParams& p) -> int& { return p.own_rules ? p.grammar.steps : p.steps; };
    return fewer_steps<CoralGrower, CoralParams>(*this, share, steps, word_size);
  }
  Appearance appearance() const override {
    Appearance appearance;
    appearance.look.branches = {.skin = params.skin};
    appearance.motion = {params.growth, params.wave, params.food, 1};
    appearance.variation = params.skin.tint.variation;
    return appearance;
  }
  std::optional<Result<Grammar>> grammar() const override { return coral_grammar(params); }
  std::optional<Spread> spread() const override {
    Result<Skeleton> one = grow_coral(params, Seed{});
    if (!one) return std::nullopt;
    Spread spread{0.01f, 0.01f};
    for (const Vec3& p : one->position) {
      spread.across = std::max(spread.across, glm::length(Vec2(p.x, p.z)));
      spread.up = std::max(spread.up, p.y);
    }
    return spread;
  }
  Result<Model> grow_at(const Surroundings& around, Seed seed) const override {
    Result<Skeleton> skeleton = grow_coral(params, seed, environment_of(around, params.food, params.growth));
    if (!skeleton) return skeleton.errors();
    Model model;
    model.skeleton = std::move(*skeleton);
    keep_to_room(model.skeleton, around);
    return model;
  }
};

}  // namespace

Kind<Organism> coral_kind() {
  return make_grower<CoralGrower>("coral", "A branching coral from an L-system");
}

}  // namespace frond
