#include "preset/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>

#include "core/assets.h"
#include "core/content.h"

namespace frond {

namespace {

void append_value(std::string& text, double x) {
  fmt::format_to(std::back_inserter(text), "{} ", x == 0 ? 0 : x);  // no -0
}

void append_value(std::string& text, std::string_view s) {
  fmt::format_to(std::back_inserter(text), "{}:{}", s.size(), s);
}

template <class Real>
void append_all(std::string& text, const Real* parts, int count) {
  for (int i = 0; i < count; ++i) append_value(text, static_cast<double>(parts[i]));
}

void append_key_value(std::string& text, double x) { append_value(text, x); }
void append_key_value(std::string& text, Vec3 x) { append_all(text, &x.x, 3); }

template <class T>
void append_animated(std::string& text, const Animated<T>& a) {
  for (const auto& key : a.keys()) {
    append_value(text, key.time), append_key_value(text, key.value);
    if (key.ease) append_value(text, "ease"), append_value(text, static_cast<double>(*key.ease));
    if (key.in) append_value(text, "in"), append_key_value(text, *key.in);
    if (key.out) append_value(text, "out"), append_key_value(text, *key.out);
  }
}

}  // namespace

void KeyWriter::add_slot(std::string_view name, Slot x) {
  Entry entry;
  entry.name = name;
  append(entry.texts, x);
  entries_.push_back(std::move(entry));
}

void KeyWriter::file(std::string_view name, FileName& file, LoadFile, std::string_view, bool) {
  add(name, file.content.empty() ? file.name : file.content);
}

void KeyWriter::choose(std::string_view name, Slot e, const ChoiceTable& table, std::string_view) {
  std::optional<Slot> held = e.held();
  std::string chosen(held ? table.name_of(*held) : "");
  add(name, chosen);
}

void KeyWriter::append(Texts& texts, Slot x) const {
  const SlotType& type = *x.type;
  std::string& own = texts[static_cast<std::size_t>(own_)];
  switch (type.kind) {
    case SlotType::Kind::boolean:
      return append_value(own, static_cast<double>(x.as<bool>()));
    case SlotType::Kind::real:
    case SlotType::Kind::vector:
      return type.is_float ? append_all(own, &x.as<float>(), type.length)
                           : append_all(own, &x.as<double>(), type.length);
    case SlotType::Kind::integer:
      return append_value(own, type.get(x.at));
    case SlotType::Kind::text:
      return append_value(own, x.as<std::string>());
    case SlotType::Kind::size:
      append_value(own, 2.0);
      return append_all(own, x.as<std::array<int, 2>>().data(), 2);
    case SlotType::Kind::color:
      return append_all(own, &x.as<Color>().red, 3);
    case SlotType::Kind::curve:
      for (const Vec2& point : x.as<Curve>().points()) append_all(own, &point.x, 2);
      return;
    case SlotType::Kind::animated:
      return type.length == 1 ? append_animated(own, x.as<Animated<double>>())
                              : append_animated(own, x.as<Animated<Vec3>>());
    case SlotType::Kind::pairs: {
      const auto& pairs = x.as<std::vector<std::pair<std::string, std::string>>>();
      append_value(own, static_cast<double>(pairs.size()));
      for (const auto& [name, value] : pairs) append_value(own, name), append_value(own, value);
      return;
    }
    case SlotType::Kind::keys:
      texts[static_cast<std::size_t>(Aspect::shape)] += x.as<Keys>().shape;
      texts[static_cast<std::size_t>(Aspect::look)] += x.as<Keys>().look;
      texts[static_cast<std::size_t>(Aspect::motion)] += x.as<Keys>().motion;
      return;
    case SlotType::Kind::list:
      append_value(own, static_cast<double>(type.count(x.at)));  // lists of lists are told apart
      [[fallthrough]];
    case SlotType::Kind::optional:
      for (std::size_t i = 0; i < type.count(x.at); ++i)
        append(texts, {type.element_at(x.at, i), type.element});
      return;
    case SlotType::Kind::object: {
      KeyWriter inner;
      inner.own_ = own_;
      if (type.describe) type.describe(inner, x.at);
      if (type.rest) type.rest(inner, x.at);
      return inner.append_to(texts);
    }
    case SlotType::Kind::choice:
      assert(!"the names of a choice are known to its property alone");
  }
}

void KeyWriter::move_to(Aspect aspect, std::string_view name) {
  auto entry = std::ranges::find(entries_, name, &Entry::name);
  assert(entry != entries_.end() && "the aspect of a property comes after it");
  std::string all;
  for (std::string& text : entry->texts) all += std::exchange(text, {});
  entry->texts[static_cast<std::size_t>(aspect)] = std::move(all);
}

void KeyWriter::append_to(Texts& texts) const {
  // An object that tells nothing else tells that it is there.
  for (std::size_t aspect = 0; aspect < texts.size(); ++aspect) {
    std::string inside;
    for (const Entry& entry : entries_)
      if (!entry.texts[aspect].empty()) (inside += entry.name) += '=' + entry.texts[aspect];
    bool own = aspect == static_cast<std::size_t>(own_);
    if (own || !inside.empty()) texts[aspect] += '{' + inside + '}';
  }
}

Keys KeyWriter::keys() const {
  Texts texts;
  append_to(texts);
  auto key = [&](Aspect aspect) { return content_id(texts[static_cast<std::size_t>(aspect)]); };
  return {key(Aspect::shape), key(Aspect::look), key(Aspect::motion)};
}

}  // namespace frond
