#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace frond {

/// A text of JSON that is changed in places: its comments and its layout stay, but for what is changed. The
/// text is one that parse_json() reads, and so is each value that is put into it. Pointers are RFC 6901; what
/// is asked for where none points to anything leaves the text as it is.
class TextEdits {
 public:
  explicit TextEdits(std::string text) : text_(std::move(text)) {}

  const std::string& text() const { return text_; }

  /// The value as it is written, with the comments in it.
  std::optional<std::string> written(std::string_view pointer) const;

  /// Another name for a member of an object.
  void rename(std::string_view pointer, std::string_view name);

  /// Another value.
  void replace(std::string_view pointer, std::string_view json);

  /// Removes a member or an element with the comma that it no longer needs, and its line where it had one.
  void remove(std::string_view pointer);

  /// A new member behind another one, or without a name a new element, on a line of its own where that one
  /// begins a line.
  void insert_after(std::string_view pointer, std::string_view name, std::string_view json);

 private:
  /// Where a member or an element is written. Of an element the name has no length.
  struct Place {
    std::size_t begin = 0;                  ///< of its name, or of its value
    std::size_t name_end = 0;               ///< behind the name
    std::size_t value = 0;                  ///< where its value begins
    std::size_t end = 0;                    ///< behind its value
    std::size_t before = 0;                 ///< behind the bracket or the comma before it
    bool first = false;                     ///< nothing stands before it
    std::optional<std::size_t> comma = {};  ///< the one behind it
  };
  std::optional<Place> find(std::string_view pointer) const;
  /// The part of the list or object at `at` that a step of a pointer names.
  std::optional<Place> find_step(std::size_t at, std::string_view step) const;
  /// Where the line that holds an offset begins, if nothing but blanks stands before the offset.
  std::optional<std::size_t> own_line(std::size_t offset) const;

  std::string text_;
};

}  // namespace frond
