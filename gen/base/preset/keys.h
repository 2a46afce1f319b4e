#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "preset/describe.h"

namespace frond {

/// What stands for a described value in names of files and in caches: hashes of its properties' names and of
/// their values as they were read. So a default may be written out or left out, and the order, the spelling
/// and the place of what is written do not count. Files that properties name count by what they hold.
struct Keys {
  std::string shape;   ///< of all that tells what grows
  std::string look;    ///< of all that tells only how it looks
  std::string motion;  ///< of all that tells only how it moves

  /// The three keys as one text.
  std::string all() const { return shape + look + motion; }
  bool operator==(const Keys&) const = default;
};

/// The visitor that makes the keys of described structs (describe.h). Use keys_of() below.
class KeyWriter : public Properties {
 public:
  Keys keys() const;

  /// Adds a value that is no property of its own.
  void add(std::string_view name, AnySlot x) { add_slot(name, x); }

  // The properties, see describe.h.

  Purpose purpose() const override { return Purpose::keys; }
  void angle(std::string_view name, RealSlot x, const Range&, std::string_view) override {
    add_slot(name, x);
  }
  void file(std::string_view name, FileName& file, LoadFile, std::string_view, bool) override;
  void direction(std::string_view name, VectorSlot v, Across, std::string_view) override {
    add_slot(name, v);
  }
  void list(std::string_view name, ListSlot l, const Count&, std::string_view) override { add_slot(name, l); }
  void inheriting_list(const Inheritance& names, ListSlot l, const KindTable&, std::string_view) override {
    add_slot(names.list, l);
  }
  void aspect(Aspect of_all_after) override { own_ = of_all_after; }

 protected:
  void visit_value(std::string_view name, Slot x, const Range&, std::string_view) override {
    add_slot(name, x);
  }
  void visit_tagged(std::string_view name, Slot x, const KindTable&, std::string_view) override {
    add_slot(name, x);
  }
  void choose(std::string_view name, Slot e, const ChoiceTable& table, std::string_view doc) override;
  void read_custom(std::string_view name, Slot x, ReadCustom, std::string_view, std::string_view) override {
    add_slot(name, x);
  }
  /// The text of a name's value becomes part of an aspect.
  void move_to(Aspect aspect, std::string_view name) override;

 private:
  using Texts = std::array<std::string, kAspects>;
  struct Entry {
    std::string_view name;
    Texts texts;  // of each aspect
  };

  void add_slot(std::string_view name, Slot x);
  void append(Texts& texts, Slot x) const;
  /// Adds all that an object tells of each aspect.
  void append_to(Texts& texts) const;

  Aspect own_ = Aspect::shape;
  std::vector<Entry> entries_;
};

/// The keys of described values together.
template <class... T>
Keys keys_of(T... values) {
  KeyWriter writer;
  (writer.add("", values), ...);
  return writer.keys();
}

}  // namespace frond
