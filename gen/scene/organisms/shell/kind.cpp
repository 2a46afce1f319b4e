
#include <algorithm>

#include "appearance/describe.h"
#include "organisms/colony.h"
#include "organisms/kinds.h"
#include "organisms/shell/shell.h"

namespace frond {

inline constexpr Choice<ShellForm> kShellForms[] = {
    {"univalve", ShellForm::univalve, "one shell, coiled, as snails and nautilus have"},
    {"bivalve", ShellForm::bivalve, "two valves on a hinge, as clams have"},
    {"valve", ShellForm::valve, "one valve of a clam"}};

void describe(Properties& v, ShellRibs& r) {
  v.integer("count", r.count, {.min = 0, .max = 120}, "Number of cords or ribs round the edge; 0 is none");
  v.number("height", r.height, {.min = 0, .max = 0.4},
           "Height from the middle to a crest, as a share of the last whorl's radius or the valve's height");
  v.number("broad", r.broad, {.min = 0.2, .max = 5},
           "Below 1 narrow ribs between broad grooves, above 1 broad ones between narrow grooves");
}

void describe(Properties& v, ShellCostae& c) {
  v.integer("count", c.count, {.min = 0, .max = 120},
            "Number on a whorl, or on a valve from its beak to its margin; 0 is none");
  v.number("height", c.height, {.min = 0, .max = 0.4},
           "Height, as a share of the last whorl's radius or the valve's height");
  v.number("sharp", c.sharp, {.min = 0.2, .max = 20}, "How narrow they are: 1 round waves, 10 thin blades");
}

void describe(Properties& v, ShellScutes& s) {
  v.integer("count", s.count, {.min = 0, .max = 60},
            "Number along each rib on a whorl, or on a valve from its beak to its margin; 0 is none");
  v.number("height", s.height, kShare, "Height, as a share of the last whorl's radius or the valve's height");
}

void describe(Properties& v, MantleParams& m) {
  describe(v, m.look);
  v.aspect(Aspect::shape);
  v.number("swell", m.swell, {.min = 0, .max = 0.5},
           "How far it rises over the margins, as a share of the valve's height");
  v.number("ruffle", m.ruffle, {.min = 0, .max = 0.2},
           "How far its edge undulates, as a share of the valve's height");
}

void describe(Properties& v, ShellParams& p) {
  v.choice("form", p.form, kShellForms, "What shell it is");
  v.number("size", p.size, metres(0.001, 5), "Length of its longest side, as it lies closed");
  v.number(
      "expansion", p.expansion, {.min = 1.02, .max = 1e12},
      "Raup's W: the factor by which it grows in a whorl; 1.2 to 4 for snails, from 10 on for valves: the "
      "more, the flatter");
  v.number("distance", p.distance, {.min = 0, .max = 0.95},
           "Raup's D: distance of the edge from the axis, its inner side's by its outer side's");
  v.number("translation", p.translation, {.min = -5, .max = 20},
           "Raup's T: how far it moves along the axis, by its distance from it; 0 coils in a plane");
  v.number("aspect", p.aspect, {.min = 0.1, .max = 8}, "Raup's S: the edge along the axis by across it");
  v.number("whorls", p.whorls, {.min = 0.02, .max = 30}, "Number of whorls; of a valve less than half a one");
  v.list("edge", p.edge, {.min = 0, .max = 64},
         "The growing edge as a closed curve through points [from the axis, along it], in place of distance "
         "and aspect");
  v.number("wall", p.wall, {.min = 0.005, .max = 0.3}, "Thickness, as a share of the last whorl's radius");
  v.number("flare", p.flare, {.min = 0, .max = 1.5},
           "How far the outer lip turns outward in its last part, as a share of the last whorl's radius");
  v.number("hollow", p.hollow, {.min = 0.05, .max = 10}, "Whorls that the inside goes back from the lip");
  v.object("ribs", p.ribs, "Relief along growth: cords of a snail, ribs and folds of a valve");
  v.object("costae", p.costae, "Relief across growth");
  v.object("scutes", p.scutes, "Scales that stand on the ribs");
  v.animated("gape", p.gape, {.min = 0, .max = 120, .unit = "degrees"},
             "Angle between the valves; keyframes open and close them");
  v.object("mantle", p.mantle, "Tissue between the margins, as of a giant clam");
  v.angle("tilt", p.tilt, {.min = -180, .max = 180},
          "How it lies: 0 with its tip, or the margins of its valves, up, 90 on its side");
  v.angle("roll", p.roll, {.min = -360, .max = 360}, "Turn about its axis, before it is tilted");
  v.number("detail", p.detail, {.min = 2000, .max = 2e6}, "Number of triangles, about");
  v.object("look", p.look, "Its colours and its pattern");
  v.object("growth", p.growth, "When it grows in the film");
}

namespace {

class ShellGrower final : public Described<ShellParams, ColonyGrower> {
 public:
  static constexpr std::string_view kLeading[] = {"form",        "size",         "expansion",  "distance",
                                                  "translation", "aspect",       "whorls",     "ribs/count",
                                                  "ribs/height", "look/pattern", "look/color", "look/second"};

  GrowerTraits traits() const override {
    return colony({.stands_on_rock = false,
                   .rebuilt = moves() ? Rebuilt::in_films : Rebuilt::never,
                   .tallest = params.size});
  }
  Review review() const override {
    Errors errors;
    if (!params.coiled() && params.whorls >= 0.5)
      errors.push_back(
          error_at("/whorls", "found a valve of {} whorls; expected less than half of one", params.whorls));
    if (!params.edge.empty() && params.edge.size() < 4)
      errors.push_back(
          error_at("/edge", "found {} points; expected 4 at least, or none", params.edge.size()));
    if (std::ranges::any_of(params.edge, [](Vec2 p) { return p.x < 0; }))
      errors.push_back({"/edge", "goes beyond the axis; expected distances of 0 and more"});
    if (!params.edge.empty() && std::ranges::max(params.edge, {}, &Vec2::x).x <= 0)
      errors.push_back({"/edge", "lies on the axis; expected a point beside it"});
    if (params.mantle && params.form != ShellForm::bivalve)
      errors.push_back({"/mantle", "needs the two valves of \"form\": \"bivalve\""});
    return {errors};
  }
  std::shared_ptr<const Grower> coarse(double share) const override {
    return changed(*this,
                   [&](ShellParams& p) { p.detail = std::max(share * p.detail, std::min(p.detail, 5e3)); });
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    double triangles =
        params.detail * (params.form == ShellForm::bivalve ? 2 : 1) + (params.mantle ? 52000 : 0);
    return SizeEstimate{.triangles = triangles, .blocks = params.mantle ? 2.0 : 1.0};
  }
  Appearance appearance() const override {
    Appearance appearance;
    appearance.look.pictures.push_back(shell_drawing_of(params));
    if (params.mantle) appearance.look.pictures.push_back(mantle_drawing(params.mantle->look));
    appearance.motion.growth = params.growth;
    return appearance;
  }
  /// What lives keeps its place free.
  std::optional<Spread> spread() const override {
    if (!params.mantle) return std::nullopt;
    return Spread{static_cast<float>(0.6 * params.size), static_cast<float>(params.size)};
  }
  std::function<Result<Model>(double)> develop(const Motion& motion, Seed seed) const override {
    if (!moves()) return {};
    return [params = params, growth = motion.growth, seed](double time) -> Result<Model> {
      double share = growth.duration > 0 || growth.start > 0
                         ? std::min(growth_front(growth, time) / (1 + growth.ripen), 1.0)
                         : 1;
      return grow_shell(params, share, radians(params.gape.at(time)), seed);
    };
  }
  Result<Model> grow_at(const Surroundings&, Seed seed) const override {
    return grow_shell(params, 1, radians(params.gape.at(0)), seed);
  }

 private:
  bool moves() const {
    return params.growth.duration > 0 || params.growth.start > 0 || !params.gape.constant();
  }
};

}  // namespace

Kind<Organism> shell_kind() {
  return make_grower<ShellGrower>("shell", "The shell of a snail or a clam, wound on a logarithmic spiral");
}

}  // namespace frond
