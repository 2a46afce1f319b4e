#include "grammar/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "core/text.h"
#include "core/vec.h"

namespace frond {

namespace {

struct Function {
  std::string_view name;
  Op op;
  std::size_t least, most;  ///< parameters
};

constexpr std::array kFunctions{
    Function{"min", Op::min, 2, 8},   Function{"max", Op::max, 2, 8},     Function{"floor", Op::floor, 1, 1},
    Function{"ceil", Op::ceil, 1, 1}, Function{"round", Op::round, 1, 1}, Function{"abs", Op::abs, 1, 1},
    Function{"fabs", Op::abs, 1, 1},  Function{"sign", Op::sign, 1, 1},   Function{"sqrt", Op::sqrt, 1, 1},
    Function{"exp", Op::exp, 1, 1},   Function{"log", Op::log, 1, 1},     Function{"sin", Op::sin, 1, 1},
    Function{"cos", Op::cos, 1, 1},   Function{"tan", Op::tan, 1, 1},     Function{"asin", Op::asin, 1, 1},
    Function{"acos", Op::acos, 1, 1}, Function{"atan", Op::atan, 1, 1},   Function{"atan2", Op::atan2, 2, 2},
    Function{"pow", Op::power, 2, 2}, Function{"rand", Op::rand, 2, 2},   Function{"nrand", Op::nrand, 2, 2},
};

/// An operator between two values; the stronger binds closer.
struct Operator {
  std::string_view sign;
  int strength;
  Op op;
};

/// Longer signs first.
constexpr Operator kOperators[] = {
    {"<=", 1, Op::less_equal}, {">=", 1, Op::greater_equal}, {"==", 1, Op::equal},   {"!=", 1, Op::not_equal},
    {"<>", 1, Op::not_equal},  {"<", 1, Op::less},           {">", 1, Op::greater},  {"=", 1, Op::equal},
    {"+", 2, Op::add},         {"-", 2, Op::subtract},       {"*", 3, Op::multiply}, {"/", 3, Op::divide},
    {"%", 3, Op::modulo},
};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Precedence climbing, writing code as it reads; constants are folded on the way.
class Parser {
 public:
  Parser(Cursor& reader, const Scope& scope) : in_(reader), scope_(scope) {}

  Expression read() {
    in_.skip_blanks();
    Expression formula;
    formula.place = static_cast<std::uint32_t>(in_.at);
    read_or();
    if (!in_.failed() && (code_.size() > 60000 || height() > kHighestStack))
      in_.fail("the formula is too long; split it with constants", in_.at);
    if (in_.failed()) return formula;
    using Form = Expression::Form;
    auto op = [&](std::size_t i) { return code_[i].op; };
    if (code_.size() == 1 && op(0) == Op::constant) {
      formula.value = code_[0].value;
    } else if (code_.size() == 1 && op(0) == Op::variable) {
      formula.form = Form::variable, formula.variable = code_[0].index;
    } else if (code_.size() == 3 && op(2) == Op::multiply && op(0) == Op::variable && op(1) == Op::constant) {
      formula.form = Form::scaled, formula.variable = code_[0].index, formula.value = code_[1].value;
    } else {
      formula.form = Form::code;
      formula.code = std::move(code_);
    }
    return formula;
  }

 private:
  void emit(Instruction instruction) {
    std::size_t n = operands(instruction.op);
    code_.push_back(instruction);
    bool pure = n > 0 && instruction.op != Op::rand && instruction.op != Op::nrand &&
                instruction.op != Op::element && instruction.op != Op::ramp &&
                code_.size() > std::max(n, barrier_);
    for (std::size_t i = 0; pure && i < n; ++i) pure = code_[code_.size() - 2 - i].op == Op::constant;
    if (pure && code_.size() - n - 1 >= barrier_) fold(n);
  }

  /// The most values that the code holds on the stack.
  std::size_t height() const {
    std::size_t now = 0, most = 0;
    for (const Instruction& instruction : code_) {
      bool jump = instruction.op == Op::jump_if_false || instruction.op == Op::jump_if_true;
      now = now + (jump ? 0 : 1) - operands(instruction.op);
      most = std::max(most, now);
    }
    return most;
  }

  void fold(std::size_t n) {
    Expression part;
    part.form = Expression::Form::code;
    part.code.assign(code_.end() - static_cast<std::ptrdiff_t>(n) - 1, code_.end());
    Evaluation nothing;
    double value = run(part, nothing);
    if (nothing.failed()) return in_.fail("division by zero", nothing.fault_place);
    code_.resize(code_.size() - n - 1);
    code_.push_back({Op::constant, 0, 0, value});
  }

  /// `a or b` is 1 as soon as a is true; `a and b` 0 as soon as a is false: the rest is not evaluated.
  void read_or() {
    read_and();
    while (!in_.failed() && (in_.consume("||") || consume_word("or")))
      read_second(Op::jump_if_true, &Parser::read_and);
  }

  void read_and() {
    read_comparison();
    while (!in_.failed() && (in_.consume("&&") || consume_word("and")))
      read_second(Op::jump_if_false, &Parser::read_comparison);
  }

  void read_comparison() { read_binary(1); }

  void read_second(Op jump, void (Parser::*side)()) {
    std::size_t from = code_.size();
    code_.push_back({jump});
    barrier_ = code_.size();
    (this->*side)();
    code_.push_back({Op::truth});
    code_[from].index = static_cast<std::uint16_t>(code_.size());
    barrier_ = code_.size();
  }

  /// Reads values with operators between them that bind at least so strongly, from the left.
  void read_binary(int strength) {
    read_sign();
    while (!in_.failed()) {
      in_.skip_blanks();
      auto place = static_cast<std::uint32_t>(in_.at);
      const Operator* found = std::ranges::find_if(
          kOperators, [&](const Operator& o) { return in_.text.substr(place).starts_with(o.sign); });
      if (found == std::end(kOperators) || found->strength < strength) return;
      in_.consume(found->sign);
      read_binary(found->strength + 1);
      emit({found->op, 0, place});
    }
  }

  void read_sign() {
    if (++depth_ > 40) in_.fail("the formula is nested too deeply; split it with constants", in_.at);
    if (!in_.failed()) {
      if (in_.consume("-"))
        read_sign(), emit({Op::negate});
      else if (in_.consume("+"))
        read_sign();
      else if (in_.consume("!") || consume_word("not"))
        read_sign(), emit({Op::logical_not});
      else
        read_power();
    }
    --depth_;
  }

  void read_power() {
    read_value();
    if (!in_.failed() && in_.consume("^")) read_sign(), emit({Op::power});
  }

  void read_value() {
    in_.skip_blanks();
    std::size_t start = in_.at;
    if (in_.consume("(")) {
      read_or();
      if (!in_.failed() && !in_.consume(")")) in_.fail("a `)` is missing for the `(` here", start);
      return;
    }
    char c = start < in_.text.size() ? in_.text[start] : '\0';
    if (is_digit(c) || c == '.') return read_number();
    std::string_view name = consume_identifier(in_);
    if (name.empty()) return in_.fail("a number, a name or `(` is expected", start);
    if (in_.at < in_.text.size() && in_.text[in_.at] == '(') return read_call(name, start);
    if (in_.at < in_.text.size() && in_.text[in_.at] == '[') return read_element(name, start);
    read_name(name, start);
  }

  void read_number() {
    double value = 0;
    const char* first = in_.text.data() + in_.at;
    auto [end, error] = std::from_chars(first, in_.text.data() + in_.text.size(), value);
    if (error != std::errc{}) return in_.fail("this is not a number", in_.at);
    in_.at += static_cast<std::size_t>(end - first);
    emit({Op::constant, 0, 0, value});
  }

  void read_name(std::string_view name, std::size_t start) {
    for (std::size_t i = scope_.variables.size(); i-- > 0;)
      if (scope_.variables[i] == name) return emit({Op::variable, static_cast<std::uint16_t>(i)});
    if (const Constant* constant = find(name)) {
      if (constant->array)
        return in_.fail(fmt::format("`{0}` is an array; write {0}[i] or ramp({0}, t)", name), start);
      return emit({Op::constant, 0, 0, constant->values[0]});
    }
    if (name == "step") return emit({Op::step_number});
    if (name == "pi") return emit({Op::constant, 0, 0, kPi});
    std::vector<std::string_view> known(scope_.variables.begin(), scope_.variables.end());
    for (const Constant& constant : scope_.constants) known.push_back(constant.name);
    in_.fail(fmt::format("`{}` is not a parameter of the rule, nor a constant; {}", name,
                         known.empty() ? "declare it in `constants`" : hint(name, known)),
             start);
  }

  static std::string hint(std::string_view name, const std::vector<std::string_view>& known) {
    std::string_view near = nearest_name(name, known);
    return near.empty() ? fmt::format("known are {}", fmt::join(known, ", "))
                        : fmt::format("did you mean `{}`?", near);
  }

  const Constant* find(std::string_view name) const {
    for (const Constant& constant : scope_.constants)
      if (constant.name == name) return &constant;
    return nullptr;
  }

  void read_element(std::string_view name, std::size_t start) {
    const Constant* constant = find(name);
    if (!constant || !constant->array) return in_.fail(fmt::format("`{}` is not an array", name), start);
    in_.consume("[");
    read_or();
    if (!in_.failed() && !in_.consume("]")) return in_.fail("a `]` is missing", in_.at);
    emit({Op::element, constant->table, static_cast<std::uint32_t>(start)});
  }

  void read_ramp(std::size_t start) {
    std::string_view name = consume_identifier(in_);
    const Constant* constant = find(name);
    if (!constant || !constant->array)
      return in_.fail("ramp(array, position from 0 to 1) needs an array among the constants", start);
    if (!in_.consume(",")) return in_.fail("ramp(array, position from 0 to 1) takes 2 parameters", start);
    read_or();
    if (!in_.failed() && !in_.consume(")")) return in_.fail("a `)` is missing", in_.at);
    emit({Op::ramp, constant->table});
  }

  void read_call(std::string_view name, std::size_t start) {
    in_.consume("(");
    if (name == "ramp") return read_ramp(start);
    const Function* function =
        std::find_if(kFunctions.begin(), kFunctions.end(), [&](const Function& f) { return f.name == name; });
    if (function == kFunctions.end()) {
      std::vector<std::string_view> names{"ramp"};
      for (const Function& f : kFunctions) names.push_back(f.name);
      return in_.fail(fmt::format("there is no function `{}`; {}", name, hint(name, names)), start);
    }
    std::size_t count = 0;
    if (!in_.consume(")")) {
      do {
        read_or();
        if (++count > 2 && function->most > 2) emit({function->op});
      } while (!in_.failed() && in_.consume(","));
      if (!in_.failed() && !in_.consume(")")) in_.fail("a `)` is missing", in_.at);
    }
    if (in_.failed()) return;
    if (count < function->least || count > function->most)
      return in_.fail(fmt::format("`{}` takes {} parameter{}, {} given", name, function->least,
                                  function->least == 1 ? "" : "s", count),
                      start);
    emit({function->op});
  }

  bool consume_word(std::string_view word) {
    in_.skip_blanks();
    std::size_t end = in_.at + word.size();
    if (in_.text.substr(in_.at, word.size()) != word) return false;
    if (end < in_.text.size() && (is_letter(in_.text[end]) || is_digit(in_.text[end]))) return false;
    in_.at = end;
    return true;
  }

  Cursor& in_;
  const Scope& scope_;
  std::vector<Instruction> code_;
  std::size_t barrier_ = 0;  ///< code before it may be jumped over: not folded
  int depth_ = 0;
};

}  // namespace

void Cursor::skip_blanks() {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\t' || text[at] == '\n' || text[at] == '\r'))
    ++at;
}

bool Cursor::consume(std::string_view word) {
  skip_blanks();
  if (text.substr(at, word.size()) != word) return false;
  at += word.size();
  return true;
}

void Cursor::fail(std::string what, std::size_t where) {
  if (failed()) return;
  mistake = std::move(what);
  mistake_at = where;
}

bool is_identifier(std::string_view name) {
  if (name.empty() || !is_letter(name[0])) return false;
  return std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

std::string_view consume_identifier(Cursor& reader) {
  reader.skip_blanks();
  std::size_t end = reader.at;
  while (end < reader.text.size() &&
         (is_letter(reader.text[end]) || (end > reader.at && is_digit(reader.text[end]))))
    ++end;
  std::string_view name = reader.text.substr(reader.at, end - reader.at);
  reader.at = end;
  return name;
}

Expression read_expression(Cursor& reader, const Scope& scope) { return Parser(reader, scope).read(); }

}  // namespace frond
