#include "preset/fault.h"

#include <algorithm>
#include <tuple>

#include "preset/json.h"

namespace frond {
namespace {

/// Whether `outer` is the place of `inner` or holds it.
bool holds(std::string_view outer, std::string_view inner) {
  return inner.starts_with(outer) && (inner.size() == outer.size() || inner[outer.size()] == '/');
}

}  // namespace

Error Fault::error() const {
  std::string where = origin.text(), shown = pointer.empty() ? "/" : pointer;
  // `--set /film/fps` says the pointer itself.
  if (origin.line > 0 || !where.ends_with(" " + shown)) where += ": " + shown;
  if (!unknown) return {where, what};
  return error_at(where, "unknown property {}{}", serialize(make_text(*unknown)),
                  expected_names(*unknown, names));
}

void Faults::add(Fault fault) {
  Error error = fault.error();
  std::string place = fault.origin.text();
  // Two values of one --set have the same origin.
  if (fault.origin.line == 0) place = error.where;
  if (seen_.emplace(std::move(place), std::move(error.what)).second) list_.push_back(std::move(fault));
}

Errors Faults::errors() const {
  std::vector<const Fault*> ordered;
  for (const Fault& fault : list_) ordered.push_back(&fault);
  std::ranges::stable_sort(ordered, {}, [](const Fault* fault) {
    const Origin& origin = fault->origin;
    std::string_view source = origin.source && origin.line > 0 ? std::string_view(*origin.source) : "";
    return std::tuple(origin.line == 0, source, origin.line, origin.column);
  });
  Errors errors;
  for (const Fault* fault : ordered) errors.push_back(fault->error());
  return errors;
}

std::vector<Fault> common_faults(const std::vector<std::vector<Fault>>& readings) {
  std::vector<Fault> common;
  for (const std::vector<Fault>& reading : readings) {
    for (const Fault& fault : reading) {
      bool everywhere = std::ranges::all_of(readings, [&](const std::vector<Fault>& other) {
        return std::ranges::any_of(other, [&](const Fault& o) { return holds(o.pointer, fault.pointer); });
      });
      if (!everywhere) continue;
      auto known = std::ranges::find(common, fault.pointer, &Fault::pointer);
      if (known == common.end()) {
        common.push_back(fault);
      } else if (known->what.empty() && !fault.what.empty()) {
        *known = fault;
      } else if (known->what.empty()) {
        for (std::string_view name : fault.names) {
          if (std::ranges::find(known->names, name) == known->names.end()) known->names.push_back(name);
        }
      }
    }
  }
  return common;
}

}  // namespace frond
