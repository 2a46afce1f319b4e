#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "plan/picture.h"
#include "scene/furnish.h"

namespace frond {

void draw_plans(const PlanArguments& arguments) {
  Preset preset = or_fail(load_preset(arguments.preset), kWrongInput);
  if (!preset.plan) fail({Error{arguments.preset.path, "the preset has no plan"}}, kWrongInput);
  tell_notes(preset.notes);
  std::string out = out_file(arguments.out, arguments.preset, "_plan.svg");
  std::vector<GroundPlan> plans;
  PlanText text = *preset.plan;
  for (int i = 0; i < arguments.seeds; ++i, ++text.grammar.seed)
    plans.push_back(or_fail(plan_of(text), kWrongInput));
  or_fail(write_file(out, plans_svg(text, plans)), kCouldNot);
  put(out + "\n");
}

}  // namespace frond
