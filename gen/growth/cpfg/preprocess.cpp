#include "cpfg/preprocess.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/plain_text.h"
#include "cpfg/macros.h"

namespace frond::cpfg {

std::string LinePlace::text() const { return fmt::format("{}: line {}", file, line); }

std::string PlainText::where(std::size_t offset) const {
  if (places.empty()) return {};
  auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
  auto line = static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
  return places[std::min(line, places.size() - 1)].text();
}

namespace {

constexpr std::size_t kMostBytes = 8'000'000, kDeepestInclude = 20, kMostJoined = 200;
constexpr std::size_t kMostIncludes = 2'000, kMostRead = 50'000'000;  // files, and their bytes, in all

struct LogicalLine {
  std::string text;
  int line;
};

/// Lines joined by `\`, without comments.
std::vector<LogicalLine> logical_lines(std::string_view text) {
  std::vector<LogicalLine> lines{{"", 1}};
  int line = 1;
  bool in_line_comment = false, in_comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    std::string_view rest = text.substr(i);
    if (c == '\r') continue;
    if (c == '\\' && (rest.starts_with("\\\n") || rest.starts_with("\\\r\n"))) {
      i += rest[1] == '\n' ? 1 : 2;
      ++line;
    } else if (c == '\n') {
      ++line;
      if (!in_comment) lines.push_back({"", line});
      in_line_comment = false;
    } else if (in_comment) {
      if (!rest.starts_with("*/")) continue;
      in_comment = false;
      ++i;
    } else if (in_line_comment) {
      continue;
    } else if (rest.starts_with("/*")) {
      in_comment = true;
      lines.back().text += ' ';
      ++i;
    } else if (rest.starts_with("//")) {
      in_line_comment = true;
    } else if (std::size_t length = string_length(rest)) {
      lines.back().text += rest.substr(0, length);
      i += length - 1;
    } else {
      lines.back().text += c;
    }
  }
  return lines;
}

/// Reads by precedence. Whole numbers wrap around.
class ConstantReader {
 public:
  explicit ConstantReader(std::string_view text) : rest_(text) {}

  std::optional<long long> all() {
    long long value = read(0);
    if (wrong_ || !trim(rest_).empty()) return std::nullopt;
    return value;
  }

 private:
  struct Operator {
    std::string_view sign;
    int strength;
  };

  static constexpr Operator kOperators[] = {{"||", 1}, {"&&", 2}, {"==", 3}, {"!=", 3}, {"<=", 4},
                                            {">=", 4}, {"<", 4},  {">", 4},  {"+", 5},  {"-", 5},
                                            {"*", 6},  {"/", 6},  {"%", 6}};

  static long long apply(std::string_view sign, long long a, long long b) {
    auto x = static_cast<unsigned long long>(a), y = static_cast<unsigned long long>(b);
    if (sign == "||") return a || b;
    if (sign == "&&") return a && b;
    if (sign == "==") return a == b;
    if (sign == "!=") return a != b;
    if (sign == "<=") return a <= b;
    if (sign == ">=") return a >= b;
    if (sign == "<") return a < b;
    if (sign == ">") return a > b;
    if (sign == "+") return static_cast<long long>(x + y);
    if (sign == "-") return static_cast<long long>(x - y);
    if (sign == "*") return static_cast<long long>(x * y);
    if (b == 0 || b == -1) return sign == "/" ? static_cast<long long>(0 - x) * (b == -1) : 0;
    return sign == "/" ? a / b : a % b;
  }

  long long read(int strength) {
    if (++depth_ > 200) wrong_ = true;
    if (wrong_) return 0;
    long long value = unary();
    for (bool found = true; found && !wrong_;) {
      found = false;
      rest_ = trim(rest_);
      for (const Operator& op : kOperators) {
        if (!rest_.starts_with(op.sign)) continue;
        if (op.strength <= strength) break;
        rest_.remove_prefix(op.sign.size());
        value = apply(op.sign, value, read(op.strength));
        found = true;
        break;
      }
    }
    --depth_;
    return value;
  }

  long long unary() {
    rest_ = trim(rest_);
    if (rest_.empty() || ++depth_ > 200) wrong_ = true;
    if (wrong_) return 0;
    char c = rest_[0];
    long long value = 0;
    if (c == '!' || c == '-' || c == '+' || c == '(') {
      rest_.remove_prefix(1);
      value = c == '(' ? read(0) : unary();
      if (c == '!') value = !value;
      if (c == '-') value = static_cast<long long>(0 - static_cast<unsigned long long>(value));
      rest_ = trim(rest_);
      if (c == '(' && !rest_.starts_with(')')) wrong_ = true;
      if (c == '(' && !wrong_) rest_.remove_prefix(1);
    } else {
      std::size_t length = name_length(rest_);
      if (length == 0) wrong_ = true;
      std::from_chars(rest_.data(), rest_.data() + length, value);
      rest_.remove_prefix(length);
    }
    --depth_;
    return value;
  }

  std::string_view rest_;
  int depth_ = 0;
  bool wrong_ = false;
};

/// A `#if` that is open: whether its lines are kept, and whether one of its parts has been.
struct OpenCondition {
  bool kept, any, around;
};

class Preprocessor {
 public:
  Preprocessor(const std::vector<Predefined>& names, const IncludeReader& include) : include_(include) {
    for (const Predefined& name : names) table_.macros[name.name] = {false, {}, name.text};
  }

  void read(const std::string& file, std::string_view text, std::size_t depth) {
    std::size_t open_before = conditions_.size();
    if (depth > kDeepestInclude) return fail({file, 1}, "files include each other more than 20 deep");
    std::vector<LogicalLine> lines = logical_lines(text);
    if (lines.back().text.empty()) lines.pop_back();
    for (std::size_t i = 0; i < lines.size() && !error_; ++i) {
      LinePlace place{file, lines[i].line};
      std::string& line = lines[i].text;
      if (read_directive(place, line, depth)) {
        put("", place);
      } else if (keeps()) {
        std::size_t last = std::min(i + kMostJoined, lines.size() - 1);
        while (i < last && (table_.is_open(line) || begins_call(line, lines, i + 1)))
          line += '\n' + lines[++i].text;
        std::string expanded = table_.expanded(line);
        if (table_.error.empty()) put(expanded, place);
      }
      if (!table_.error.empty()) fail(place, table_.error);
    }
    if (!error_ && conditions_.size() > open_before)
      fail({file, lines.empty() ? 1 : lines.back().line}, "an #if has no #endif");
  }

  Result<PlainText> result() {
    if (error_) return *error_;
    return std::move(out_);
  }

 private:
  void fail(const LinePlace& place, std::string what) {
    if (!error_) error_ = Error{place.text(), std::move(what)};
  }

  /// Whether a line ends with the name of a macro whose arguments begin in a later line.
  bool begins_call(std::string_view line, const std::vector<LogicalLine>& lines, std::size_t next) const {
    if (!table_.ends_in_call(line)) return false;
    for (; next < lines.size(); ++next)
      if (std::string_view behind = trim(lines[next].text); !behind.empty()) return behind.starts_with('(');
    return false;
  }

  bool keeps() const { return conditions_.empty() || conditions_.back().kept; }

  void put(std::string_view line, const LinePlace& place) {
    if (out_.text.size() + line.size() > kMostBytes) return fail(place, "the text becomes longer than 8 MB");
    out_.text += line;
    out_.text += '\n';
    out_.places.resize(out_.places.size() + 1 + static_cast<std::size_t>(std::ranges::count(line, '\n')),
                       place);
  }

  /// Whether the line is a directive, which it carries out.
  bool read_directive(const LinePlace& place, std::string_view line, std::size_t depth) {
    std::string_view text = trim(line);
    if (!text.starts_with('#')) return false;
    text = trim(text.substr(1));
    std::size_t length = name_length(text);
    std::string_view name = text.substr(0, length), rest = trim(text.substr(length));
    if (text.empty()) return true;
    if (read_condition(place, name, rest)) return true;
    constexpr std::string_view kWithoutEffect[] = {"pragma",  "line",   "ident",
                                                   "warning", "assert", "unassert"};
    if (name == "define") {
      if (keeps()) table_.define(rest);
    } else if (name == "undef") {
      if (auto macro = table_.macros.find(rest.substr(0, name_length(rest)));
          keeps() && macro != table_.macros.end())
        table_.macros.erase(macro);
    } else if (name == "include") {
      if (keeps()) read_include(place, rest, depth);
    } else if (name == "error") {
      if (keeps()) fail(place, fmt::format("#error {}", rest));
    } else {
      return std::ranges::find(kWithoutEffect, name) != std::end(kWithoutEffect);
    }
    return true;
  }

  bool read_condition(const LinePlace& place, std::string_view name, std::string_view rest) {
    bool defined = table_.macros.contains(rest.substr(0, name_length(rest)));
    if (name == "if" || name == "ifdef" || name == "ifndef") {
      bool around = keeps();
      bool kept = around && (name == "if" ? holds(place, rest) : defined == (name == "ifdef"));
      conditions_.push_back({kept, kept, around});
      if (conditions_.size() > 1000) fail(place, "more than 1000 #if in each other");
      return true;
    }
    if (name != "else" && name != "elif" && name != "endif") return false;
    if (conditions_.empty()) {
      fail(place, fmt::format("#{} without an #if", name));
    } else if (name == "endif") {
      conditions_.pop_back();
    } else {
      OpenCondition& open = conditions_.back();
      open.kept = open.around && !open.any && (name == "else" || holds(place, rest));
      open.any = open.any || open.kept;
    }
    return true;
  }

  bool holds(const LinePlace& place, std::string_view text) {
    std::string plain;  // `defined NAME` is answered before names are replaced
    for (std::size_t at = 0; at < text.size();) {
      std::size_t length = std::max<std::size_t>(name_length(text.substr(at)), 1);
      std::string_view word = text.substr(at, length);
      at += length;
      if (word != "defined") {
        plain += word;
        continue;
      }
      at = std::min(text.find_first_not_of(" \t(", at), text.size());
      std::size_t name = name_length(text.substr(at));
      plain += table_.macros.contains(text.substr(at, name)) ? " 1 " : " 0 ";
      std::size_t closing = text.find_first_not_of(" \t", at + name);
      bool in_brackets = text.substr(0, at).ends_with('(');
      at = in_brackets && closing != text.npos && text[closing] == ')' ? closing + 1 : at + name;
    }
    std::string expanded = table_.expanded(plain);
    std::optional<long long> value = constant_value(expanded);
    if (!value) fail(place, fmt::format("`#if {}`: expected a formula of whole numbers", text));
    return value.value_or(0) != 0;
  }

  void read_include(const LinePlace& place, std::string_view rest, std::size_t depth) {
    std::string expanded = table_.expanded(rest);
    std::string_view named = trim(expanded);
    std::size_t length = string_length(named);
    if (length < 3) return fail(place, fmt::format("`#include {}`: expected a file's name in quotes", rest));
    std::string name(named.substr(1, length - 2));
    if (++includes_ > kMostIncludes || read_ > kMostRead)
      return fail(place,
                  "more than 2,000 files or 50 MB are included in all; expected fewer, as where files "
                  "do not include each other again and again");
    Result<std::string> text = include_(name);
    if (!text) return fail(place, fmt::format("#include \"{}\": {}", name, text.errors()[0].what));
    read_ += text->size();
    read(name, *text, depth + 1);
  }

  const IncludeReader& include_;
  MacroTable table_;
  PlainText out_;
  std::vector<OpenCondition> conditions_;
  std::size_t includes_ = 0, read_ = 0;
  std::optional<Error> error_;
};

}  // namespace

std::optional<long long> constant_value(std::string_view text) { return ConstantReader(text).all(); }

Result<PlainText> preprocess(const std::string& file, std::string_view text,
                             const std::vector<Predefined>& names, const IncludeReader& include) {
  if (text.size() > kMostBytes) return Error{file, "the file is longer than 8 MB"};
  Preprocessor preprocessor(names, include);
  preprocessor.read(file, text, 0);
  return preprocessor.result();
}

}  // namespace frond::cpfg
