#include <fmt/format.h>

#include <filesystem>

#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "plan/picture.h"
#include "scene/furnish.h"

namespace frond {

int draw_plans(const PlanArguments& arguments) {
  Result<Preset> preset = load_preset(arguments.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  if (!preset->plan) return fail({Error{arguments.preset.path, "the preset has no plan"}}, kWrongInput);
  tell_notes(preset->notes);
  std::string out = arguments.out.empty()
                        ? std::filesystem::path(arguments.preset.path).stem().string() + "_plan.svg"
                        : arguments.out;
  std::vector<GroundPlan> plans;
  PlanText text = *preset->plan;
  for (int i = 0; i < arguments.seeds; ++i, ++text.grammar.seed) {
    Result<GroundPlan> plan = plan_of(text);
    if (!plan) return fail(plan.errors(), kWrongInput);
    plans.push_back(std::move(*plan));
  }
  Result<bool> written = write_file(out, plans_svg(text, plans));
  if (!written) return fail(written.errors(), kCouldNot);
  put(out + "\n");
  return kDone;
}

}  // namespace frond
