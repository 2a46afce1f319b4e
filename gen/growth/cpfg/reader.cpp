#include "cpfg/reader.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "core/plain_text.h"
#include "cpfg/run.h"

namespace frond::cpfg {

double string_number(int index) {
  constexpr std::uint64_t kQuietNan = 0x7FF8000000000000;
  return std::bit_cast<double>(kQuietNan | static_cast<std::uint64_t>(index + 1) << 29);
}

int string_index(float value) {
  auto bits = std::bit_cast<std::uint32_t>(value);
  return (bits & 0x7FC00000) == 0x7FC00000 ? static_cast<int>(bits & 0x3FFFFF) - 1 : -1;
}

/// As PlainText::where, but quick for places one after the other.
std::string GrammarReader::where(std::size_t position) {
  position = std::min(position, plain_.text.size());
  if (position < counted_) counted_ = counted_lines_ = 0;
  auto begin = plain_.text.begin();
  auto from = begin + static_cast<std::ptrdiff_t>(counted_),
       to = begin + static_cast<std::ptrdiff_t>(position);
  counted_lines_ += static_cast<std::size_t>(std::count(from, to, '\n'));
  counted_ = position;
  if (plain_.places.empty()) return {};
  return plain_.places[std::min(counted_lines_, plain_.places.size() - 1)].text();
}

int GrammarReader::add_place(std::size_t position) {
  code_.places.push_back(where(position));
  return static_cast<int>(code_.places.size()) - 1;
}

void GrammarReader::fail_at(std::size_t position, std::string what) {
  if (!error_) error_ = Error{where(position), std::move(what)};
  cursor_.go_to_end();
}

std::string GrammarReader::found() {
  if (cursor_.at_item_end()) return "found the end of the line";
  std::string_view rest = cursor_.rest();
  return fmt::format("found `{}`", rest.substr(0, std::min<std::size_t>(rest.find('\n'), 20)));
}

/// Consumes words with blanks between them at will and a `:` behind. `capitals` has the other case for
/// letters that may have either; blanks where they may not.
bool GrammarReader::consume_key(std::string_view words, std::string_view capitals) {
  std::size_t from = cursor_.position();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == ' ') {
      cursor_.peek();
      continue;
    }
    char c = cursor_.here(), other = i < capitals.size() && capitals[i] != ' ' ? capitals[i] : words[i];
    if (c != words[i] && c != other) {
      cursor_.go_to(from);
      return false;
    }
    cursor_.read_char();
  }
  if (cursor_.consume(":")) return true;
  cursor_.go_to(from);
  return false;
}

/// Consumes a word that may begin with a capital, its `:` and, of a section with productions, `warnings` or
/// `no warnings`. A production may follow in the line of such a section; behind other words the line ends.
bool GrammarReader::consume_section(std::string_view word, bool has_productions) {
  std::string_view rest = cursor_.rest();
  bool same =
      rest.size() >= word.size() && (rest[0] | 0x20) == word[0] && rest.substr(1).starts_with(word.substr(1));
  if (!same) return false;
  std::string_view line = rest.substr(0, rest.find('\n')), behind = trim(line.substr(word.size()));
  if (behind.starts_with(':')) behind = trim(behind.substr(1));
  for (std::string_view warnings : {"no warnings", "warnings"})
    if (behind.starts_with(warnings)) behind = trim(behind.substr(warnings.size()));
  bool spaced = line.size() == word.size() || std::string_view(" \t:").find(line[word.size()]) != line.npos;
  bool follows = has_productions && spaced && behind.find("-->") != behind.npos && !behind.starts_with("-->");
  if (!behind.empty() && !follows) return false;
  auto length = behind.empty() ? line.size() : static_cast<std::size_t>(behind.data() - line.data());
  cursor_.go_to(cursor_.position() + length);
  return true;
}

void GrammarReader::end_item(std::string_view after) {
  if (!cursor_.at_item_end()) fail(fmt::format("{}: expected the end of the line after {}", found(), after));
}

void GrammarReader::read_characters(CpfgSystem& system, bool considered) {
  system.ignored.fill(considered);
  while (!cursor_.at_item_end())
    system.ignored[static_cast<unsigned char>(cursor_.read_char())] = !considered;
}

std::int64_t GrammarReader::read_whole(std::string_view what) {
  int formula = read_formula();
  if (failed()) return 0;
  double value = constant_of(code_, formula);
  if (std::isfinite(value) && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  fail(fmt::format("{} is {}; expected a number", what, value));
  return 0;
}

bool GrammarReader::read_section_item(ProductionSet& set) {
  if (consume_key("maximum depth", "M       D    ")) {
    std::int64_t depth = read_whole("the maximum depth");
    if (!failed() && depth > 1'000'000) fail("the maximum depth is to be at most 1,000,000");
    set.depth = static_cast<int>(std::clamp<std::int64_t>(depth, 0, 1'000'000));
  } else if (consume_key("seed", "S")) {
    set.seed = read_whole("the seed");
    set.has_seed = &set != &system_->decomposition;
  } else {
    return false;
  }
  end_item("a number");
  return true;
}

bool GrammarReader::read_item(CpfgSystem& system) {
  auto block = [&](int& into) {
    cursor_.skip_to_item();
    into = read_block();
    if (!failed()) end_item("a block");
    return true;
  };
  if (consume_section("ring lsystem")) return system.ring = true;
  if (consume_key("derivation length", "D          L")) {
    system.length = read_formula();
    if (!failed()) end_item("a number");
  } else if (consume_key("ignore", "I")) {
    read_characters(system, false);
  } else if (consume_key("consider", "C")) {
    read_characters(system, true);
  } else if (consume_key("define", "D")) {
    cursor_.skip_to_item();
    read_define();
    if (!failed()) end_item("a block");
  } else if (consume_key("start each", "S     E")) {
    return block(system.start_each);
  } else if (consume_key("start", "S")) {
    return block(system.start);
  } else if (consume_key("end each", "E   E")) {
    return block(system.end_each);
  } else if (consume_key("end", "E")) {
    return block(system.end);
  } else if (consume_key("axiom", "A")) {
    if (system.has_axiom) fail("there are two axioms");
    system.axiom = read_word(true);
    system.has_axiom = true;
    if (!failed()) end_item("the axiom");
  } else {
    return false;
  }
  return true;
}

void GrammarReader::read_system() {
  CpfgSystem& system = *system_;
  section_ = &system.rules;
  std::string_view label = trim(cursor_.read_line());
  std::size_t digits = std::min(label.find_first_not_of("0123456789"), label.size());
  system.number = digits > 0 && digits < 9 ? std::stoi(std::string(label.substr(0, digits)))
                                           : static_cast<int>(code_.systems.size());
  system.variables = {{"Z", kLengthSlot}, {"Q", kStepSlot}};
  system.slots = 2;
  for (;;) {
    cursor_.skip_to_item();
    if (failed()) return;
    if (cursor_.at_end()) return fail("the L-system has no `endlsystem`");
    if (consume_section("endlsystem") || consume_section("endLsystem")) break;
    scope_ = {};
    if (consume_section("decomposition", true)) {
      if (section_ == &system.homomorphism)
        return fail("the decomposition comes after the homomorphism; expected it before");
      section_ = &system.decomposition;
    } else if (consume_section("homomorphism", true)) {
      section_ = &system.homomorphism;
    } else if (consume_key("production", "P")) {
      return fail("cpfg has no `production:`; this is a model of L-Py or of an older program");
    } else if (!read_section_item(*section_) && (section_ != &system.rules || !read_item(system))) {
      read_production(*section_);
    }
  }
  if (!system.has_axiom) fail("the L-system has no `Axiom:`");
}

void GrammarReader::read() {
  cursor_.skip_to_item();
  while (!failed() && !cursor_.at_end()) {
    if (!consume_key("lsystem", "L"))
      return fail(fmt::format("{}: expected `Lsystem: 1`, with which a grammar of cpfg begins", found()));
    code_.systems.emplace_back();
    system_ = &code_.systems.back();
    read_system();
    cursor_.skip_to_item();
  }
  if (!failed() && code_.systems.empty()) fail("the file is empty; expected `Lsystem: 1`");
}

}  // namespace frond::cpfg
