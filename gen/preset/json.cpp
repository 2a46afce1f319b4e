#include "preset/json.h"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "core/utf8.h"
#include "preset/syntax.h"

namespace frond {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// Gives the library its bytes and counts them.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* count) : at_(at), count_(count) {}

  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*count_;
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  std::size_t* count_;
};

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

/// What the library calls (its SAX interface) as it reads the text, each time with a token just behind it. To
/// return false ends the reading. A name that stands twice is noted and the reading goes on.
class TreeBuilder {
 public:
  TreeBuilder(std::string_view text, std::string_view file_name)
      : text_(text), end_(text.starts_with(kByteOrderMark) ? 3 : 0), places_(text, end_, file_name) {}

  Result<Document> build() {
    if (std::optional<std::size_t> bad = invalid_utf8(text_)) {
      note(*bad, "", "bytes that are not UTF-8; expected UTF-8");
    } else if (std::size_t zero = text_.find('\0'); zero != text_.npos) {
      // The library would take it for the end.
      note(zero, "", "a zero byte; expected a text");
    } else {
      // It throws nothing: what is wrong comes to parse_error().
      CountingIterator begin(text_.data(), &read_);
      CountingIterator end(text_.data() + text_.size(), nullptr);
      nlohmann::json::sax_parse(begin, end, this, nlohmann::json::input_format_t::json, true, true);
    }
    if (!errors_.empty()) return errors_;
    return std::move(document_);
  }

  bool null() { return add(Value::Type::null), true; }
  bool boolean(bool boolean) { return add(Value::Type::boolean).boolean = boolean, true; }
  bool string(std::string& text) { return add(Value::Type::text).text = std::move(text), true; }
  bool number_unsigned(std::uint64_t number) {
    return add_number(static_cast<double>(number), true, fmt::formatted_size("{}", number));
  }
  bool number_integer(std::int64_t number) {
    // Zero comes here as -0.
    return add_number(static_cast<double>(number), true, number == 0 ? 2 : fmt::formatted_size("{}", number));
  }
  bool number_float(double number, const std::string& text) {
    return add_number(number, text.find_first_not_of("-0123456789") == text.npos, text.size());
  }
  bool binary(nlohmann::json::binary_t&) { return false; }  // not in JSON

  bool start_object(std::size_t) { return open(Value::Type::object); }
  bool start_array(std::size_t) { return open(Value::Type::list); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    Frame& frame = frames_.back();
    std::size_t start = next_token();
    end_ = read_;
    bool fresh = frame.names.insert(name).second;
    frame.value->members.push_back({std::move(name), places_.at(start), {}});
    frame.at_value = true;
    if (fresh) return true;
    std::string shown = serialize(make_text(frame.value->members.back().name));
    note(start, pointer(true), fmt::format("the name {} a second time; expected it once", shown));
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& exception) {
    SyntaxFault fault = find_fault(text_, end_, expected(), position, exception.what());
    note(fault.offset, pointer(fault.inside), std::move(fault.what));
    return false;
  }

 private:
  /// A list or object that is being read.
  struct Frame {
    Value* value;
    std::set<std::string> names = {};
    bool at_value = false;  ///< of an object: behind a name
  };

  /// Where the token begins that was just read.
  std::size_t next_token() const {
    std::size_t start = skip_blanks(text_, end_);
    bool separator = start < text_.size() && (text_[start] == ',' || text_[start] == ':');
    return separator ? skip_blanks(text_, start + 1) : start;
  }

  Value& add(Value::Type type) {
    Value* value = &document_.root;
    if (frames_.empty()) {
      whole_ = true;
    } else if (Frame& frame = frames_.back(); frame.value->is(Value::Type::list)) {
      value = &frame.value->items.emplace_back();
    } else {
      value = &frame.value->members.back().value;
      frame.at_value = false;
    }
    value->type = type;
    value->origin = places_.at(next_token());
    end_ = read_;
    return *value;
  }

  /// The library may have read one byte more to see that the number ends; `length` is how long it is.
  bool add_number(double number, bool integer, std::size_t length) {
    std::size_t start = next_token();
    Value& value = add(Value::Type::number);
    value.number = number;
    value.integer = integer;
    end_ = start + length;
    return true;
  }

  bool open(Value::Type type) {
    if (frames_.size() == kDeepestNesting) {
      note(next_token(), pointer(true),
           fmt::format("a value {} levels deep; expected at most {}", kDeepestNesting + 1, kDeepestNesting));
      return false;
    }
    frames_.push_back({&add(type)});
    return true;
  }

  bool close() {
    frames_.pop_back();
    end_ = read_;
    return true;
  }

  Expected expected() const {
    if (frames_.empty()) return whole_ ? Expected::end : Expected::value;
    const Frame& frame = frames_.back();
    if (frame.value->is(Value::Type::list))
      return frame.value->items.empty() ? Expected::value : Expected::comma_or_bracket;
    if (frame.at_value) return Expected::colon;
    return frame.value->members.empty() ? Expected::first_name : Expected::comma_or_brace;
  }

  /// Of the innermost list or object, or of the next value inside it.
  std::string pointer(bool inside) const {
    std::string text;
    for (const Frame& frame : frames_) {
      bool last = &frame == &frames_.back();
      const Value& value = *frame.value;
      if (last && !inside) break;
      text = value.is(Value::Type::list) ? fmt::format("{}/{}", text, value.items.size() - (last ? 0 : 1))
                                         : pointer_step(text, value.members.back().name);
    }
    return text;
  }

  void note(std::size_t offset, std::string_view pointer, std::string what) {
    std::string where = fmt::format("{}: {}", places_.at(offset).text(), pointer.empty() ? "/" : pointer);
    errors_.push_back({std::move(where), std::move(what)});
  }

  std::string_view text_;
  std::size_t read_ = 0;  ///< bytes that the library has read
  std::size_t end_;       ///< of the last token
  Places places_;
  Document document_;
  std::vector<Frame> frames_;
  bool whole_ = false;  ///< the outermost value has begun
  Errors errors_;
};

}  // namespace

Result<Document> parse_json(std::string_view text, std::string_view file_name) {
  return TreeBuilder(text, file_name).build();
}

}  // namespace frond
