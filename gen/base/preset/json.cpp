#include "preset/json.h"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <utility>

#include "core/utf8.h"
#include "preset/tokens.h"

namespace frond {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// Turns offsets into lines and columns; cheap for offsets that grow from call to call.
class Places {
 public:
  Places(std::string_view text, std::size_t first, std::string_view file_name)
      : text_(text), first_(first), source_(std::make_shared<const std::string>(file_name)), offset_(first) {}

  Origin at(std::size_t offset) {
    if (offset < offset_) offset_ = first_, line_ = column_ = 1;
    for (; offset_ < offset; ++offset_) {
      bool continues = (static_cast<unsigned char>(text_[offset_]) & 0xc0) == 0x80;
      if (text_[offset_] == '\n') {
        ++line_;
        column_ = 1;
      } else if (!continues) {
        ++column_;
      }
    }
    return Origin{source_, line_, column_};
  }

 private:
  std::string_view text_;
  std::size_t first_;
  std::shared_ptr<const std::string> source_;
  std::size_t offset_;
  int line_ = 1;
  int column_ = 1;
};

/// Reads a text by recursive descent. The first fault ends the reading, except that a name which stands twice
/// is noted and the reading goes on.
class Parser {
 public:
  Parser(std::string_view text, std::string_view file_name)
      : text_(text),
        at_(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0),
        places_(text, at_, file_name) {}

  Result<Document> parse() {
    Document document;
    if (std::optional<std::size_t> bad = invalid_utf8(text_)) {
      note(*bad, "", "bytes that are not UTF-8; expected UTF-8");
    } else if (std::size_t zero = text_.find('\0'); zero != text_.npos) {
      note(zero, "", "a zero byte; expected a text");
    } else if (read_value(document.root) && next() != '\0') {
      unexpected(About::container, "the end of the text");
    }
    if (!errors_.empty()) return errors_;
    return document;
  }

 private:
  /// Whether a fault is about the element or member that is being read or about the list or object that has
  /// it.
  enum class About { element, container };

  // Each of these reads what begins at the next token and stands behind it then. False: a fault was noted.

  bool read_value(Value& value) {
    char first = next();
    value.origin = places_.at(at_);
    if (first == '{' || first == '[') return read_container(value, first);
    if (first == '"') {
      value.type = Value::Type::text;
      return passed(read_quoted(text_, at_, value.text), About::element);
    }
    if (first == '-' || (first >= '0' && first <= '9')) return read_number_value(value);
    auto word = [&](std::string_view name) {
      if (!text_.substr(at_).starts_with(name)) return false;
      at_ += name.size();
      return true;
    };
    if (word("null")) return true;
    value.boolean = word("true");
    if (!value.boolean && !word("false")) return unexpected(About::element, "a value");
    value.type = Value::Type::boolean;
    return true;
  }

  bool read_number_value(Value& value) {
    NumberToken token;
    value.type = Value::Type::number;
    if (!passed(read_number(text_, at_, token), About::element)) return false;
    value.number = token.number;
    value.integer = token.integer;
    return true;
  }

  bool read_container(Value& value, char bracket) {
    if (open_.size() == kDeepestNesting) {
      note(at_, pointer(About::element),
           fmt::format("a value {} levels deep; expected at most {}", kDeepestNesting + 1, kDeepestNesting));
      return false;
    }
    value.type = bracket == '{' ? Value::Type::object : Value::Type::list;
    open_.push_back(&value);
    ++at_;
    bool good = value.is(Value::Type::object) ? read_members(value) : read_items(value);
    open_.pop_back();
    return good;
  }

  bool read_items(Value& list) {
    if (next() == ']') return ++at_, true;
    for (;;) {
      if (!read_value(list.items.emplace_back())) return false;
      std::size_t end = at_;
      if (next() == ']') return ++at_, true;
      if (!read_comma(end, ']', "\"{[-0123456789tfn", "',' or ']'", "element")) return false;
    }
  }

  bool read_members(Value& object) {
    std::set<std::string, std::less<>> names;
    if (next() == '}') return ++at_, true;
    for (;;) {
      if (!read_name(object, names)) return false;
      if (next() != ':') return unexpected(About::container, "':' behind the name");
      ++at_;
      if (!read_value(object.members.back().value)) return false;
      std::size_t end = at_;
      if (next() == '}') return ++at_, true;
      if (!read_comma(end, '}', "\"", "',' or '}'", "member")) return false;
    }
  }

  bool read_name(Value& object, std::set<std::string, std::less<>>& names) {
    if (next() != '"') return unexpected(About::container, "a name in double quotes");
    std::size_t start = at_;
    std::string name;
    if (!passed(read_quoted(text_, at_, name), About::container)) return false;
    object.members.push_back({name, places_.at(start), {}});
    if (!names.insert(name).second)
      note(start, pointer(About::element),
           fmt::format("the name {} a second time; expected it once", serialize(make_text(name))));
    return true;
  }

  /// Reads the comma behind what ended at `end`. It is missing where the next one of `beginnings` stands:
  /// then the fault is right behind the value, which may be lines above.
  bool read_comma(std::size_t end, char close, std::string_view beginnings, std::string_view expected,
                  std::string_view what) {
    char first = next();
    if (first == ',') {
      std::size_t comma = at_++;
      if (next() != close) return true;
      note(comma, pointer(About::container),
           fmt::format("a comma before the closing '{}'; expected no comma behind the last {}", close, what));
      return false;
    }
    if (first == '\0' || beginnings.find(first) == beginnings.npos)
      return unexpected(About::container, expected);
    note(end, pointer(About::container), fmt::format("no comma behind the value; expected {}", expected));
    return false;
  }

  /// Goes to the next token and gives its first byte; 0 at the end.
  char next() {
    at_ = skip_blanks(text_, at_);
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool unexpected(About about, std::string_view expected) {
    bool comment = text_.substr(at_).starts_with("/*");
    note(at_, pointer(about),
         fmt::format("{}; expected {}", comment ? "a comment without end" : found_at(text_, at_),
                     comment ? "*/" : expected));
    return false;
  }

  bool passed(const std::optional<TokenFault>& fault, About about) {
    if (fault) note(fault->offset, pointer(about), fault->what);
    return !fault;
  }

  /// The JSON pointer of the innermost list or object that is being read, or of its last element or member.
  std::string pointer(About about) const {
    std::string text;
    for (const Value* value : open_) {
      if (value == open_.back() && about == About::container) break;
      text = value->is(Value::Type::list) ? fmt::format("{}/{}", text, value->items.size() - 1)
                                          : pointer_step(text, value->members.back().name);
    }
    return text;
  }

  void note(std::size_t offset, std::string_view pointer, std::string what) {
    std::string where = fmt::format("{}: {}", places_.at(offset).text(), pointer.empty() ? "/" : pointer);
    errors_.push_back({std::move(where), std::move(what)});
  }

  std::string_view text_;
  std::size_t at_;
  Places places_;
  std::vector<const Value*> open_;  // lists and objects that are being read, outermost first
  Errors errors_;
};

}  // namespace

Result<Document> parse_json(std::string_view text, std::string_view file_name) {
  return Parser(text, file_name).parse();
}

}  // namespace frond
