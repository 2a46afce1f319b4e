#include "preset/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/text.h"
#include "preset/json.h"

namespace frond {

std::string Origin::text() const {
  std::string name = source ? *source : std::string();
  return line == 0 ? name : fmt::format("{}:{}:{}", name, line, column);
}

const Value* Value::find(std::string_view name) const {
  auto at = std::ranges::find(members, name, &Member::name);
  return at == members.end() ? nullptr : &at->value;
}

Value* Value::find(std::string_view name) { return const_cast<Value*>(std::as_const(*this).find(name)); }

Value& Value::set(std::string_view name, Value value) {
  if (Value* old = find(name)) {
    *old = std::move(value);
  } else {
    Origin from = value.origin;
    members.push_back(Member{std::string(name), std::move(from), std::move(value)});
  }
  return *this;
}

void Value::remove(std::string_view name) {
  std::erase_if(members, [&](const Member& member) { return member.name == name; });
}

Value make_boolean(bool boolean) {
  Value value;
  value.type = Value::Type::boolean;
  value.boolean = boolean;
  return value;
}

Value make_number(double number) {
  Value value;
  value.type = Value::Type::number;
  value.number = number;
  return value;
}

Value make_text(std::string_view text) {
  Value value;
  value.type = Value::Type::text;
  value.text = text;
  return value;
}

Value make_list(std::vector<Value> items) {
  Value value;
  value.type = Value::Type::list;
  value.items = std::move(items);
  return value;
}

Value make_object(std::vector<Member> members) {
  Value value;
  value.type = Value::Type::object;
  value.members = std::move(members);
  return value;
}

std::string found_text(const Value& value) {
  constexpr std::size_t kLongest = 40;
  switch (value.type) {
    case Value::Type::text: {
      std::size_t end = std::min(value.text.size(), kLongest);
      while (end < value.text.size() && (value.text[end] & 0xc0) == 0x80) --end;
      std::string shown = serialize(make_text(std::string_view(value.text).substr(0, end)));
      if (end < value.text.size()) shown.insert(shown.size() - 1, "...");
      return "the text " + shown;
    }
    case Value::Type::list:
      return value.items.empty() ? "an empty list" : fmt::format("a list of {}", value.items.size());
    case Value::Type::object:
      return "an object";
    case Value::Type::null:
    case Value::Type::boolean:
    case Value::Type::number:
      break;
  }
  return serialize(value);
}

std::string pointer_step(std::string_view pointer, std::string_view name) {
  std::string text(pointer);
  text += '/';
  for (char c : name) {
    if (c == '~' || c == '/')
      text += c == '~' ? "~0" : "~1";
    else
      text += c;
  }
  return text;
}

Origin origin_at(const Value& root, std::string_view pointer) {
  const Value* here = &root;
  while (pointer.starts_with('/')) {
    std::string_view step = pointer.substr(0, pointer.find('/', 1));
    const Value* next = nullptr;
    for (const Member& member : here->members) {
      if (pointer_step("", member.name) == step) next = &member.value;
    }
    for (std::size_t i = 0; i < here->items.size(); ++i) {
      if (fmt::format("/{}", i) == step) next = &here->items[i];
    }
    if (!next) break;
    here = next;
    pointer.remove_prefix(step.size());
  }
  return here->origin;
}

std::string expected_names(std::string_view found, std::span<const std::string_view> names) {
  constexpr std::size_t kShort = 8;
  constexpr std::size_t kLong = 24;
  constexpr std::size_t kLongestName = 64;  // none that is known is longer
  if (names.empty()) return "; expected no further name";
  found = found.substr(0, kLongestName);
  std::string_view near = nearest_name(found, names);
  std::vector<std::string_view> shown(names.begin(), names.end());
  if (shown.size() > (near.empty() ? kLong : kShort))
    std::ranges::stable_sort(shown, {}, [&](std::string_view name) { return edit_distance(found, name); });
  std::size_t more = shown.size() > kLong ? shown.size() - kLong : 0;
  shown.resize(shown.size() - more);
  std::string text =
      fmt::format("; expected {}{}", names.size() > 1 ? "one of " : "", fmt::join(shown, ", "));
  if (more > 0) text += fmt::format(" and {} more", more);
  if (!near.empty()) text += fmt::format("; did you mean \"{}\"?", near);
  return text;
}

}  // namespace frond
