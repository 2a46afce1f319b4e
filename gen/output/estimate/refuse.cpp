
#include "core/figures.h"
#include "estimate/estimate_cost.h"

// What a machine cannot bear.

namespace frond {

namespace {

Errors refuse_memory(double memory, std::size_t largest, const Machine& machine) {
  if (memory <= machine.memory) return {};
  return {error_at("",
                   "the run would take about {} of memory, and {} can be had; /organisms/{} takes most of "
                   "it: fewer or smaller ones, or fewer steps or years",
                   bytes_text(memory), bytes_text(machine.memory), largest)};
}

}  // namespace

Errors refuse(const CostEstimate& f, const Machine& machine) {
  Errors errors = refuse_memory(f.memory(1), f.largest, machine);
  if (f.resolve_memory > machine.memory)
    errors.push_back(error_at("/film/size",
                              "resolving the pictures would take about {} of memory, and {} can be had; "
                              "expected a smaller size, or --no-resolve, by which POV-Ray draws all samples",
                              bytes_text(f.resolve_memory), bytes_text(machine.memory)));
  if (f.disk() > machine.disk)
    errors.push_back(error_at(
        "",
        "the run would write about {}, {} frames of {} and {} beside them, and {} of the disk are free; "
        "fewer frames (film.frames, --frames), or another --out; /organisms/{} takes most of it",
        bytes_text(f.disk()), f.frames, bytes_text(f.frame_bytes + f.picture_bytes),
        bytes_text(f.shared_bytes), bytes_text(machine.disk), f.largest));
  else if (f.disk() + f.tracing_disk > machine.disk)
    errors.push_back(error_at("/film/size",
                              "POV-Ray would take about {} of the disk while it traces a picture, beside the "
                              "{} of the run, and {} are free; expected a smaller size, or another --out",
                              bytes_text(f.tracing_disk), bytes_text(f.disk()), bytes_text(machine.disk)));
  return errors;
}

Errors refuse(const ViewCostEstimate& view, const Machine& machine) {
  return refuse_memory(view.memory, view.largest, machine);
}

}  // namespace frond
