#include "preset/override.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "core/read_as.h"
#include "core/utf8.h"

namespace frond {
namespace {

/// The steps of a pointer, unescaped; nothing where a `~` is not part of `~0` or `~1`.
std::optional<std::vector<std::string>> steps_of(std::string_view pointer) {
  std::vector<std::string> steps;
  for (std::size_t i = 0; i < pointer.size(); ++i) {
    if (pointer[i] == '/') {
      steps.emplace_back();
    } else if (pointer[i] == '~') {
      char code = i + 1 < pointer.size() ? pointer[++i] : '\0';
      if (code != '0' && code != '1') return std::nullopt;
      steps.back() += code == '0' ? '~' : '/';
    } else {
      steps.back() += pointer[i];
    }
  }
  return steps;
}

void mark(Value& value, const Origin& origin) {
  value.origin = origin;
  for (Value& item : value.items) mark(item, origin);
  for (Member& member : value.members) {
    member.origin = origin;
    mark(member.value, origin);
  }
}

/// Follows the steps through a document, making what is missing.
class Walk {
 public:
  Walk(Value& root, const Origin& origin) : here_(&root), origin_(origin) {}

  /// What is wrong with the step, or empty.
  std::string step(const std::string& name, bool next_is_list) {
    std::string problem;
    if (here_->is(Value::Type::object)) {
      enter_member(name, next_is_list);
    } else if (here_->is(Value::Type::list)) {
      problem = enter_item(name, next_is_list);
    } else {
      problem = fmt::format("found {} at {}, which has nothing inside; expected an object or a list",
                            found_text(*here_), path_.empty() ? "/" : path_);
    }
    path_ = pointer_step(path_, name);
    return problem;
  }

  void put(Value value) { *here_ = std::move(value); }

 private:
  Value fresh(bool list) const {
    Value value = list ? make_list() : make_object();
    value.origin = origin_;
    return value;
  }

  void enter_member(const std::string& name, bool next_is_list) {
    if (!here_->find(name)) here_->set(name, fresh(next_is_list));
    here_ = here_->find(name);
  }

  std::string enter_item(const std::string& name, bool next_is_list) {
    std::size_t size = here_->items.size();
    std::size_t index = size;
    if (name != "-") {
      index = read_as<std::size_t>(name).value_or(size);
      if (index >= size || fmt::to_string(index) != name) {
        std::string indices = size == 0   ? ""
                              : size == 1 ? "the index 0, or "
                                          : fmt::format("an index from 0 to {}, or ", size - 1);
        return fmt::format("found \"{}\" as the index of a list of {} at {}; expected {}- to add to it", name,
                           size, path_.empty() ? "/" : path_, indices);
      }
    }
    if (index == size) here_->items.push_back(fresh(next_is_list));
    here_ = &here_->items[index];
    return {};
  }

  Value* here_;
  Origin origin_;
  std::string path_;
};

}  // namespace

Errors apply_set(Document& document, std::string_view assignment) {
  std::size_t equals = assignment.find('=');
  std::string_view pointer = assignment.substr(0, equals);
  std::string where = fmt::format("--set {}", pointer);
  if (equals == assignment.npos)
    return {Error{where, "found no '='; expected POINTER=VALUE, as in /film/fps=24"}};
  if (!pointer.starts_with('/')) {
    return {error_at(where, "found a pointer without '/' in front; expected /{}", pointer)};
  }
  if (invalid_utf8(assignment)) return {Error{where, "bytes that are not UTF-8; expected UTF-8"}};
  std::optional<std::vector<std::string>> steps = steps_of(pointer);
  if (!steps) return {Error{where, "found a single '~'; expected ~0 for '~' and ~1 for '/'"}};
  if (steps->size() > kDeepestNesting) {
    return {error_at(where, "found {} steps; expected at most {}", steps->size(), kDeepestNesting)};
  }

  std::string_view written = assignment.substr(equals + 1);
  Result<Document> read = parse_json(written, where);
  Value value = read ? std::move(read->root) : make_text(written);
  Origin origin{std::make_shared<const std::string>(where)};
  mark(value, origin);

  Document changed = document;
  Walk walk(changed.root, origin);
  for (std::size_t i = 0; i < steps->size(); ++i) {
    bool next_is_list = i + 1 < steps->size() && (*steps)[i + 1] == "-";
    std::string problem = walk.step((*steps)[i], next_is_list);
    if (!problem.empty()) return {Error{where, problem}};
  }
  walk.put(std::move(value));
  document = std::move(changed);
  return {};
}

}  // namespace frond
