#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "core/text.h"
#include "grammar/import.h"
#include "grammar/import_text.h"

namespace frond {

namespace {

using namespace import_text;

constexpr int kUsualOrder = 2;  ///< of Fractint, where none is asked for

/// One L-system of a file: the lines between its braces.
struct Entry {
  std::string name;
  std::vector<Line> lines;
};

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_numeral(char c) { return c >= '0' && c <= '9'; }

std::string upper(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) { return upper(c); });
  return out;
}

/// All L-systems of a file. A line may hold a name, a brace and more.
std::vector<Entry> entries_of(std::string_view text) {
  std::vector<Entry> entries;
  std::string name;
  bool inside = false;
  for (const Line& line : lines_of(text)) {
    std::string_view rest = line.text.substr(0, line.text.find(';'));
    while (!(rest = trim(rest)).empty()) {
      std::size_t sign = std::min(rest.find(inside ? '}' : '{'), rest.size());
      std::string_view part = trim(rest.substr(0, sign));
      if (inside && !part.empty()) entries.back().lines.push_back({part, line.number, line.whole});
      if (!inside && !part.empty()) name = part;
      if (sign == rest.size()) break;
      if (!inside) entries.push_back({std::exchange(name, {}), {}});
      inside = !inside;
      rest.remove_prefix(sign + 1);
    }
  }
  return entries;
}

Result<Entry> chosen(std::vector<Entry> entries, std::string_view system) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.push_back(entry.name);
  if (system.empty() && entries.size() == 1) return std::move(entries[0]);
  for (Entry& entry : entries)
    if (!system.empty() && upper(entry.name) == upper(system)) return std::move(entry);
  if (entries.empty()) return Error{"", "there is no L-system `Name { … }` of Fractint"};
  if (std::string_view near = nearest_name(system, names); !system.empty() && !near.empty())
    return error_at("--system", "there is no L-system `{}`; did you mean `{}`?", system, near);
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < 40; ++i) list += (i == 0 ? "" : ", ") + names[i];
  return error_at("--system", "the file holds {} L-systems; expected the name of one: {}{}", names.size(),
                  list, names.size() > 40 ? ", …" : "");
}

class FractintReader {
 public:
  Result<GrammarText> read(const Entry& entry) {
    g_.steps = kUsualOrder;
    g_.start_heading = {1, 0, 0};
    g_.axiom.clear();
    for (const Line& line : entry.lines)
      if (std::optional<Error> odd = odd_sign(line)) errors_.push_back(std::move(*odd));
    for (const Line& line : entry.lines) read_line(line);
    if (!has_axiom_) errors_.push_back(error_at("", "the L-system `{}` has no axiom", entry.name));
    if (!(angles_ > 0)) errors_.push_back(error_at("", "the L-system `{}` has no angle", entry.name));
    if (!errors_.empty()) return std::move(errors_);
    g_.angle = 360.0 / angles_;
    g_.axiom = word(axiom_, axiom_.text);
    for (const auto& [letter, parts] : rules_) add_rule(letter, parts);
    if (counted_ && absolute_)
      errors_.push_back({"",
                         "F and G turn by + and -, D and M by \\ and /, each with a heading of their own; "
                         "both in one L-system cannot be had here"});
    for (const auto& [sign, line] : meaningless_)
      g_.notes.push_back(error_at(fmt::format("line {}", line), "`{}` means nothing to Fractint", sign));
    g_.notes.push_back(
        error_at("file", "Fractint asks for the order; {} is taken, --steps sets another", kUsualOrder));
    if (!errors_.empty()) return std::move(errors_);
    return std::move(g_);
  }

 private:
  struct Part {
    Line line;
    std::string_view word;
  };

  void fail(const Line& line, std::string_view part, std::string what) {
    errors_.push_back({place_in(line, part), std::move(what)});
  }

  void read_line(const Line& line) {
    std::size_t end = std::min(line.text.find_first_of(" \t="), line.text.size());
    std::string key = upper(line.text.substr(0, end));
    std::string_view value = trim(line.text.substr(end));
    if (key == "ANGLE" || key == "AXIOM") {
      if (value.starts_with('=')) value = trim(value.substr(1));
      if (key == "AXIOM") return void((axiom_ = line, axiom_.text = value, has_axiom_ = true));
      std::optional<double> given = number(value);
      if (!given || *given < 3 || *given > 360 || *given != std::floor(*given))
        return fail(
            line, value,
            fmt::format("`{}`: the angle is a whole number from 3 on, how many turns are a full one", value));
      return void(angles_ = static_cast<int>(*given));
    }
    if (!value.starts_with('=') || key.size() != 1)
      return fail(line, line.text,
                  fmt::format("`{}` is neither `Angle n`, `Axiom word` nor a rule `A=…`", line.text));
    rules_[key[0]].push_back({line, trim(value.substr(1))});
  }

  /// Several rules of a letter are one, joined.
  void add_rule(char letter, const std::vector<Part>& parts) {
    std::string name = name_of(letter), successor;
    if (name.empty())
      return fail(parts[0].line, parts[0].line.text,
                  fmt::format("a rule for `{}` cannot be had here; give it a letter of its own", letter));
    for (const Part& part : parts) successor += word(part.line, part.word);
    g_.rules.push_back({fmt::format("{} -> {}", name, successor.empty() ? "*" : successor),
                        GrammarText::kUnlimited, fmt::format("line {}", parts[0].line.number)});
  }

  /// A character as a symbol of ours; empty where it is none.
  static std::string name_of(char c) {
    if (c == 'G' || c == 'M') return "f";
    if (c == 'D') return "F";
    bool plain = (c >= 'A' && c <= 'Z') || is_numeral(c) || c == '+' || c == '-' || c == '|';
    return plain ? std::string(1, c) : "";
  }

  std::string word(const Line& line, std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
      std::string_view here = text.substr(at);
      std::size_t length = 1;
      out += module_of(line, here, length);
      at += length;
    }
    return out;
  }

  /// The number behind a command, with the letters that change it: `I` one divided by it, `Q` its root.
  static std::optional<double> number_behind(std::string_view text, std::size_t& length, bool letters) {
    std::size_t at = 1;
    bool inverse = false, root = false;
    for (; letters && at < text.size() && (upper(text[at]) == 'I' || upper(text[at]) == 'Q'); ++at)
      (upper(text[at]) == 'I' ? inverse : root) = true;
    double value = 0;
    auto [end, error] =
        std::from_chars(text.data() + at, text.data() + text.size(), value, std::chars_format::fixed);
    if (error != std::errc{} || value < 0) return std::nullopt;
    length = static_cast<std::size_t>(end - text.data());
    if (root) value = std::sqrt(value);
    if (inverse) value = 1 / value;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }

  std::string module_of(const Line& line, std::string_view text, std::size_t& length) {
    char c = upper(text[0]);
    if (c == ' ' || c == '\t') return "";
    absolute_ = absolute_ || c == 'D' || c == 'M' || c == '\\' || c == '/';
    counted_ = counted_ || c == 'F' || c == 'G' || c == '+' || c == '-' || c == '|';
    if (c == '[' || c == ']') return std::string(1, c);
    if (is_numeral(c) && !rules_.contains(c)) return turns(text, length);
    if (c == '|' && angles_ % 2 == 1) return fmt::format("+({:.9g})", angles_ / 2 * 360.0 / angles_);
    if (c == '!')
      return fail(line, text, "`!` exchanges left and right from there on, which cannot be had here"), "";
    std::optional<double> value = std::string_view("@\\/C<>").find(c) == std::string_view::npos
                                      ? std::nullopt
                                      : number_behind(text, length, c == '@');
    if (std::string_view("@\\/").find(c) != std::string_view::npos && !value)
      return fail(line, text, fmt::format("`{}` needs a number behind it", c)), "";
    if (c == '@') return fmt::format("\"({:.9g})", *value);
    if (c == '\\' || c == '/') return fmt::format("{}({:.9g})", c == '/' ? '-' : '+', *value);
    if (c == 'C' && value) return fmt::format("'({:.9g})", *value);
    if (c == '<' || c == '>')
      return std::string(static_cast<std::size_t>(std::clamp(value.value_or(1), 0.0, 255.0)),
                         c == '<' ? '\'' : ',');
    std::string name = name_of(c);
    if (name.empty()) meaningless_.try_emplace(c, line.number);
    return name;
  }

  /// `4+` turns four times. Digits that stand elsewhere mean nothing.
  static std::string turns(std::string_view text, std::size_t& length) {
    std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    length = digits;
    if (digits == text.size() || digits > 3 || (text[digits] != '+' && text[digits] != '-')) return "";
    int count = 0;
    std::from_chars(text.data(), text.data() + digits, count);
    ++length;
    return std::string(static_cast<std::size_t>(count), text[digits]);
  }

  GrammarText g_;
  Line axiom_;
  std::map<char, std::vector<Part>> rules_;
  std::map<char, int> meaningless_;
  Errors errors_;
  int angles_ = 0;
  bool has_axiom_ = false, counted_ = false, absolute_ = false;
};

}  // namespace

Result<GrammarText> import_fractint(std::string_view text, std::string_view system) {
  Result<Entry> entry = chosen(entries_of(text), system);
  if (!entry) return entry.errors();
  return FractintReader().read(*entry);
}

}  // namespace frond
