#include "preset/text_edits.h"

#include <fmt/format.h>

#include "preset/json.h"
#include "preset/tokens.h"
#include "preset/value.h"

namespace frond {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// The offset behind the value that begins at `offset`.
std::size_t value_end(std::string_view text, std::size_t offset) {
  int depth = 0;
  do {
    offset = skip_blanks(text, offset);
    if (offset >= text.size()) return offset;
    char c = text[offset];
    if (c == '"') {
      std::string ignored;
      if (read_quoted(text, offset, ignored)) return text.size();
      continue;
    }
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    ++offset;
    if (depth == 0 && c != '}' && c != ']')  // a number or a word
      offset = std::min(text.find_first_of(" \t\r\n,]}/", offset), text.size());
  } while (depth > 0);
  return offset;
}

}  // namespace

std::optional<TextEdits::Place> TextEdits::find_step(std::size_t at, std::string_view step) const {
  if (at >= text_.size() || (text_[at] != '{' && text_[at] != '[')) return std::nullopt;
  bool object = text_[at] == '{';
  Place place{.before = at + 1, .first = true};
  for (std::size_t index = 0;; ++index) {
    place.begin = skip_blanks(text_, place.before);
    if (place.begin >= text_.size() || text_[place.begin] == '}' || text_[place.begin] == ']')
      return std::nullopt;
    place.name_end = place.value = place.begin;
    std::string name = fmt::format("{}", index);
    if (object) {
      name.clear();
      if (read_quoted(text_, place.name_end, name)) return std::nullopt;
      place.value = skip_blanks(text_, skip_blanks(text_, place.name_end) + 1);
    }
    place.end = value_end(text_, place.value);
    std::size_t next = skip_blanks(text_, place.end);
    bool more = next < text_.size() && text_[next] == ',';
    place.comma = more ? std::optional(next) : std::nullopt;
    if (pointer_step("", name).substr(1) == step) return place;
    if (!more) return std::nullopt;
    place.before = next + 1;
    place.first = false;
  }
}

std::optional<TextEdits::Place> TextEdits::find(std::string_view pointer) const {
  std::size_t start = text_.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  std::optional<Place> place;
  std::size_t at = skip_blanks(text_, start);
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    std::size_t length = std::min(pointer.find('/'), pointer.size());
    place = find_step(at, pointer.substr(0, length));
    if (!place) return std::nullopt;
    pointer.remove_prefix(length);
    at = place->value;
  }
  return place;
}

std::optional<std::size_t> TextEdits::own_line(std::size_t offset) const {
  while (offset > 0 && is_blank(text_[offset - 1])) --offset;
  if (offset > 0 && text_[offset - 1] != '\n') return std::nullopt;
  return offset;
}

std::optional<std::string> TextEdits::written(std::string_view pointer) const {
  std::optional<Place> place = find(pointer);
  if (!place) return std::nullopt;
  return text_.substr(place->value, place->end - place->value);
}

void TextEdits::rename(std::string_view pointer, std::string_view name) {
  if (std::optional<Place> place = find(pointer))
    text_.replace(place->begin, place->name_end - place->begin, serialize(make_text(name)));
}

void TextEdits::replace(std::string_view pointer, std::string_view json) {
  if (std::optional<Place> place = find(pointer))
    text_.replace(place->value, place->end - place->value, json);
}

void TextEdits::remove(std::string_view pointer) {
  std::optional<Place> place = find(pointer);
  if (!place) return;
  std::size_t begin = place->begin, end = place->end;
  if (place->comma) {
    // Between value and comma there may be a comment, which stays.
    std::string between = text_.substr(end, *place->comma - end);
    end = *place->comma + 1;
    while (end < text_.size() && is_blank(text_[end])) ++end;
    bool ends_line = end == text_.size() || text_[end] == '\n';
    std::optional<std::size_t> line = own_line(begin);
    if (between.find('/') != between.npos) {
      text_.replace(begin, end - begin, between);
    } else if (line && ends_line) {
      text_.erase(*line, std::min(end + 1, text_.size()) - *line);
    } else {
      if (ends_line)
        while (begin > 0 && is_blank(text_[begin - 1])) --begin;
      text_.erase(begin, end - begin);
    }
    return;
  }
  // With the blanks before it, if no comment is among them, which may end with its line.
  if (text_.find('/', place->before) >= begin) begin = place->before;
  text_.erase(begin, end - begin);
  if (!place->first) text_.erase(place->before - 1, 1);
}

void TextEdits::insert_after(std::string_view pointer, std::string_view name, std::string_view json) {
  std::optional<Place> place = find(pointer);
  if (!place) return;
  std::string member =
      name.empty() ? std::string(json) : fmt::format("{}: {}", serialize(make_text(name)), json);
  std::optional<std::size_t> line = own_line(place->begin);
  if (!line) {
    text_.insert(place->end, ", " + member);
    return;
  }
  member = "\n" + text_.substr(*line, place->begin - *line) + member + (place->comma ? "," : "");
  // Behind what else stands on the line, which is a comment of the one before.
  std::size_t behind = place->comma ? *place->comma + 1 : place->end;
  std::size_t at = std::min(text_.find('\n', behind), text_.size());
  if (skip_blanks(text_, behind) < at || text_.find("/*", behind) < at) at = behind;
  while (at > behind && is_blank(text_[at - 1])) --at;
  text_.insert(at, member);
  if (!place->comma) text_.insert(place->end, ",");
}

}  // namespace frond
