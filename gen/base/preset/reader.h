#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "preset/describe.h"
#include "preset/fault.h"
#include "preset/json.h"

namespace frond {

class Assets;

/// The visitor that reads described structs (describe.h) from JSON values. All errors are collected; a member
/// with an error keeps its old value. Use read_preset() below.
class Reader : public Properties {
 public:
  /// With `partial`, missing properties are allowed: the values read are defaults for another object.
  explicit Reader(bool partial = false) : partial_(partial) {}

  /// Reads the files that properties name; without this call only their names are read.
  void read_files(const Assets& assets) { assets_ = &assets; }

  const Faults& faults() const { return faults_; }
  /// Warnings: valid, but probably not intended.
  const Faults& warnings() const { return warnings_; }

  /// Reads a whole document; "$schema" is allowed there.
  void read_root(const Value& root, ObjectSlot out);

  // The properties, see describe.h.

  using Properties::direction;
  using Properties::list;
  Purpose purpose() const override { return Purpose::reading; }
  void angle(std::string_view name, RealSlot out, const Range& range, std::string_view doc) override;
  void file(std::string_view name, FileName& out, LoadFile load, std::string_view doc,
            bool needed = true) override;
  void direction(std::string_view name, VectorSlot out, Across across, std::string_view doc) override;
  void list(std::string_view name, ListSlot out, const Count& count, std::string_view doc) override;
  void inheriting_list(const Inheritance& names, ListSlot out, const KindTable& kinds,
                       std::string_view doc) override;
  /// Position of the object being read, or of that property of it, as in messages.
  void origin(std::string& out, std::string_view name = {}) override;
  /// Whether the object itself gives the property, not the defaults behind it.
  void given(std::string_view name, bool& out) override;
  void required(std::string_view name) override;
  void shorthand(std::string_view name) override;

  // For custom properties: building blocks of the above. Each notes its errors.

  /// Notes `found <value>; expected <expected>` at the value being read; nothing was read then.
  std::nullopt_t fault(const Value& value, std::string_view expected);
  /// Runs `work` one level deeper: at the element or member of that name.
  template <class Work>
  auto inside(std::string_view step, Work work) {
    std::size_t parent = pointer_.size();
    pointer_ = pointer_step(pointer_, step);
    struct Leave {
      Reader& reader;
      std::size_t size;
      ~Leave() { reader.pointer_.resize(size); }
    } leave{*this, parent};
    return work();
  }
  std::optional<double> number_at(const Value& value, const Range& range);
  std::optional<bool> boolean_at(const Value& value);
  std::optional<std::string> text_at(const Value& value);
  /// Index of the text among the names.
  std::optional<std::size_t> name_at(const Value& value, std::span<const std::string_view> names);
  std::optional<std::array<int, 2>> size_at(const Value& value, const Range& range);
  std::optional<Color> color_at(const Value& value);
  std::optional<Curve> curve_at(const Value& value);
  std::optional<std::vector<std::pair<std::string, std::string>>> pairs_at(const Value& value);
  /// The last argument only selects the type.
  std::optional<Animated<double>> animated_at(const Value& value, const Range& range,
                                              const Animated<double>&);
  std::optional<Animated<Vec3>> animated_at(const Value& value, const Range& range, const Animated<Vec3>&);
  /// A vector of two or three numbers, float or double.
  template <class V>
  std::optional<V> vector_at(const Value& value, const Range& range) {
    V vector;
    return vector_at(value, range, slot_of(vector)) ? std::optional(vector) : std::nullopt;
  }
  /// A described struct; true if there was no error.
  bool object_at(const Value& value, ObjectSlot out);

 protected:
  void visit_value(std::string_view name, Slot out, const Range& range, std::string_view doc) override;
  void visit_tagged(std::string_view name, Slot out, const KindTable& kinds, std::string_view doc) override;
  void choose(std::string_view name, Slot out, const ChoiceTable& table, std::string_view doc) override;
  void read_custom(std::string_view name, Slot out, ReadCustom read, std::string_view schema,
                   std::string_view doc) override;

 private:
  struct Frame {
    const Value* value;
    std::vector<std::string_view> names = {};
    std::string_view bare = {};
  };

  /// Notes an angle that looks like radians (`usual` in radians) where degrees are expected.
  void warn_of_radians(const Value& value, double found, double usual);
  /// Notes a direction without length.
  bool has_length(const Value& value, const DVec3& direction, Across across);
  /// The file that a text names; an empty text names none.
  std::optional<NamedFile> file_at(const Value& value);
  void note_faults(const Value& value, const NamedFile& file, const Errors& errors);
  std::optional<double> whole_at(const Value& value, const Range& range);
  bool numbers_at(const Value& value, const Range& range, std::span<double> out);
  /// Each reads what a slot holds; false, and the slot as it was, where that is not there.
  bool real_at(const Value& value, const Range& range, Slot out);
  bool integer_at(const Value& value, const Range& range, Slot out);
  bool vector_at(const Value& value, const Range& range, Slot out);
  bool value_at(const Value& value, const Range& range, Slot out);
  bool struct_at(const Value& value, Slot out);
  bool tagged_at(const Value& value, Slot out, const KindTable& kinds);
  void list_at(const Value& value, Slot out, const Count& count, FunctionRef<void(const Value&, Slot)> read);
  template <class T, class Read>
  std::optional<Animated<T>> keys_at(const Value& value, bool constant, Read read);

  /// The member of the object being read, recorded as a known name; nullptr if it is missing.
  const Value* consume(std::string_view name);
  void enter(const Value& value) { frames_.push_back(Frame{&value}); }
  void leave();
  void member(std::string_view name, FunctionRef<void(const Value&)> read);
  bool with_object(const Value& value, FunctionRef<void()> read);
  bool check_list(const Value& value, const Count& count);
  /// Whether the path ("wave/amplitude") names a property of the schema of an object.
  bool check_path(const Value& value, std::string_view path, const Value& schema);

  bool partial_;
  std::string pointer_;
  std::vector<Frame> frames_;
  Faults faults_, warnings_;
  const Assets* assets_ = nullptr;
};

/// Reads a document into a described struct and returns everything that is wrong with it. Warnings go to
/// `warnings`. Named files are read from `assets`.
Errors read_document(const Document& document, ObjectSlot out, Faults* warnings = nullptr,
                     const Assets* assets = nullptr);

/// Reads a document into a new struct, as read_document() does; what is wrong with it is the error.
template <class T>
Result<T> read_preset(const Document& document, Faults* warnings = nullptr, const Assets* assets = nullptr) {
  T preset{};
  Errors errors = read_document(document, preset, warnings, assets);
  if (errors.empty()) return preset;
  return errors;
}

}  // namespace frond
