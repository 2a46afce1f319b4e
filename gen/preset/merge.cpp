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
      own.set(name, inherit(*wanted));
    } else {
      own.remove(name);
    }
    return;
  }
  if (Value* inner = own.find(name)) force_path(wanted ? *wanted : Value{}, *inner, path.substr(slash + 1));
}

}  // namespace

Value merge(const Value& defaults, const Value& own, std::span<const std::string> force) {
  if (!defaults.is(Value::Type::object) || !own.is(Value::Type::object)) return own;
  Value merged = make_object();
  merged.origin = own.origin;
  for (const Member& member : defaults.members) {
    const Value* mine = own.find(member.name);
    Value value = mine ? merge(member.value, *mine) : inherit(member.value);
    merged.members.push_back(Member{member.name, member.origin, std::move(value)});
  }
  for (const Member& member : own.members) {
    if (!defaults.find(member.name)) merged.members.push_back(member);
  }
  for (const std::string& path : force) force_path(defaults, merged, path);
  return merged;
}

}  // namespace frond
