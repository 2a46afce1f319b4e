#include "cpfg/constant.h"

#include <charconv>

#include "cpfg/macros.h"

namespace frond::cpfg {

namespace {

/// Reads by precedence. Whole numbers wrap around.
class ConstantReader {
 public:
  explicit ConstantReader(std::string_view text) : rest_(text) {}

  std::optional<long long> all() {
    long long value = read(0);
    if (wrong_ || !without_blanks(rest_).empty()) return std::nullopt;
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
      rest_ = without_blanks(rest_);
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
    rest_ = without_blanks(rest_);
    if (rest_.empty() || ++depth_ > 200) wrong_ = true;
    if (wrong_) return 0;
    char c = rest_[0];
    long long value = 0;
    if (c == '!' || c == '-' || c == '+' || c == '(') {
      rest_.remove_prefix(1);
      value = c == '(' ? read(0) : unary();
      if (c == '!') value = !value;
      if (c == '-') value = static_cast<long long>(0 - static_cast<unsigned long long>(value));
      rest_ = without_blanks(rest_);
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

}  // namespace

std::optional<long long> constant_value(std::string_view text) { return ConstantReader(text).all(); }

}  // namespace frond::cpfg
