#include "preset/json.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <set>

#include "preset/scanner.h"

namespace frond {
namespace {

/// A recursive descent reader over the scanner. Each read_ function returns false after a fault of syntax,
/// which ends the reading; a name that stands twice is noted and passed over.
class Parser {
 public:
  Parser(std::string_view text, std::string_view file_name)
      : scan_(text), source_(std::make_shared<const std::string>(file_name)) {}

  Result<Document> parse() {
    if (std::optional<std::size_t> bad = invalid_utf8(scan_.text())) {
      fault_at(*bad, "bytes that are not UTF-8; expected UTF-8");
      return errors_;
    }
    Document document;
    if (read_value(document.root, 0) && read_end() && errors_.empty()) return document;
    return errors_;
  }

 private:
  bool fault_at(std::size_t offset, std::string_view what) {
    Scanner::Place place = scan_.place(offset);
    std::string where = Origin{source_, place.line, place.column}.text();
    errors_.push_back(Error{where + ": " + (pointer_.empty() ? "/" : pointer_), std::string(what)});
    return false;
  }

  bool unexpected(std::string_view expected) {
    return fault_at(scan_.offset(), fmt::format("{}; expected {}", scan_.next_text(), expected));
  }

  Origin origin_here() {
    Scanner::Place place = scan_.place(scan_.offset());
    return Origin{source_, place.line, place.column};
  }

  /// Goes to the next token, over blanks and comments.
  bool skip() {
    std::size_t comment = scan_.skip_blanks();
    return comment == Scanner::kNone || fault_at(comment, "a comment without end; expected */");
  }

  bool read_end() { return skip() && (scan_.at_end() || unexpected("the end of the text")); }

  bool read_value(Value& value, int depth) {
    if (!skip()) return false;
    value.origin = origin_here();
    switch (scan_.peek()) {
      case '{':
        return read_object(value, depth + 1);
      case '[':
        return read_list(value, depth + 1);
      case '"':
        value.type = Value::Type::text;
        return read_text(value.text);
      case 't':
      case 'f':
      case 'n':
        return read_word(value);
      default:
        return read_number(value);
    }
  }

  bool read_word(Value& value) {
    std::string_view word = scan_.word();
    if (word == "true" || word == "false") {
      value.type = Value::Type::boolean;
      value.boolean = word == "true";
    } else if (word != "null") {
      return unexpected("a value");
    }
    scan_.advance(word.size());
    return true;
  }

  bool read_number(Value& value) {
    Scanner::Number number = scan_.number();
    if (number.text.empty()) return unexpected("a value");
    const char* end = number.text.data() + number.text.size();
    auto [stop, fault] = std::from_chars(number.text.data(), end, value.number);
    // Too small a number is zero; from_chars gives the same fault for too large a one.
    if (fault == std::errc::result_out_of_range && number.tiny) {
      value.number = 0;
    } else if (fault != std::errc() || stop != end) {
      return fault_at(scan_.offset(),
                      fmt::format("the number {:.40}; expected one below 1.8e308", number.text));
    }
    value.type = Value::Type::number;
    value.integer = number.integer;
    scan_.advance(number.text.size());
    return true;
  }

  bool read_text(std::string& text) {
    Scanner::TextFault fault = scan_.read_text(text);
    return fault.what.empty() || fault_at(fault.offset, fault.what);
  }

  bool deeper(int depth) {
    if (depth <= kDeepestNesting) return true;
    return fault_at(scan_.offset(),
                    fmt::format("a value {} levels deep; expected at most {}", depth, kDeepestNesting));
  }

  /// Behind an element: true at a comma (passed) with another element behind it, or at the closing bracket.
  bool read_separator(char close, std::string_view element) {
    if (!skip()) return false;
    if (scan_.peek() == close) return true;
    if (scan_.peek() != ',') return unexpected(fmt::format("',' or '{}'", close));
    std::size_t comma = scan_.offset();
    scan_.advance(1);
    if (!skip()) return false;
    if (scan_.peek() != close) return true;
    return fault_at(
        comma,
        fmt::format("a comma before the closing '{}'; expected no comma behind the last {}", close, element));
  }

  bool read_list(Value& list, int depth) {
    if (!deeper(depth)) return false;
    list.type = Value::Type::list;
    scan_.advance(1);
    if (!skip()) return false;
    while (scan_.peek() != ']') {
      std::size_t parent = pointer_.size();
      pointer_ += fmt::format("/{}", list.items.size());
      if (!read_value(list.items.emplace_back(), depth)) return false;
      pointer_.resize(parent);
      if (!read_separator(']', "element")) return false;
    }
    scan_.advance(1);
    return true;
  }

  bool read_object(Value& object, int depth) {
    if (!deeper(depth)) return false;
    object.type = Value::Type::object;
    scan_.advance(1);
    if (!skip()) return false;
    std::set<std::string> names;
    while (scan_.peek() != '}') {
      if (!read_member(object, names, depth) || !read_separator('}', "member")) return false;
    }
    scan_.advance(1);
    return true;
  }

  bool read_member(Value& object, std::set<std::string>& names, int depth) {
    if (scan_.peek() != '"') return unexpected("a name in double quotes");
    Member member;
    member.origin = origin_here();
    std::size_t start = scan_.offset();
    if (!read_text(member.name) || !skip()) return false;
    if (scan_.peek() != ':') return unexpected("':' behind the name");
    scan_.advance(1);

    std::size_t parent = pointer_.size();
    pointer_ = pointer_step(pointer_, member.name);
    bool fresh = names.insert(member.name).second;
    if (!fresh)
      fault_at(start,
               fmt::format("the name {} a second time; expected it once", serialize(make_text(member.name))));
    if (!read_value(member.value, depth)) return false;
    pointer_.resize(parent);
    if (fresh) object.members.push_back(std::move(member));
    return true;
  }

  Scanner scan_;
  std::shared_ptr<const std::string> source_;
  std::string pointer_;
  Errors errors_;
};

}  // namespace

Result<Document> parse_json(std::string_view text, std::string_view file_name) {
  return Parser(text, file_name).parse();
}

}  // namespace frond
