#include "preset/merge.h"

namespace frond {
namespace {

Value inherit(Value value) {
  value.inherited = true;
  for (Value& item : value.items) item = inherit(std::move(item));
  for (Member& member : value.members) member.value = inherit(std::move(member.value));
  return value;
}

/// Makes `own` agree with the defaults in the property of that path.
void force_path(const Value& defaults, Value& own, std::string_view path) {
  if (!own.is(Value::Type::object)) return;
  std::size_t slash = path.find('/');
  std::string_view name = path.substr(0, slash);
  const Value* wanted = defaults.find(name);
  if (slash == path.npos) {
    if (wanted) {
      own.set(name, *wanted);
    } else {
      own.remove(name);
    }
    return;
  }
  if (Value* inner = own.find(name)) force_path(wanted ? *wanted : Value{}, *inner, path.substr(slash + 1));
}

}  // namespace

Value overlay(const Value& below, const Value& own) {
  if (!below.is(Value::Type::object) || !own.is(Value::Type::object)) return own;
  Value merged = make_object();
  merged.origin = own.origin;
  for (const Member& member : below.members) {
    const Value* mine = own.find(member.name);
    merged.members.push_back(
        Member{member.name, member.origin, mine ? overlay(member.value, *mine) : member.value});
  }
  for (const Member& member : own.members) {
    if (!below.find(member.name)) merged.members.push_back(member);
  }
  return merged;
}

Value merge(const Value& defaults, const Value& own, std::span<const std::string> force) {
  Value scene = inherit(defaults);
  Value merged = overlay(scene, own);
  for (const std::string& path : force) force_path(scene, merged, path);
  return merged;
}

}  // namespace frond
