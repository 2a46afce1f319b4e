#include "preset/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>

#include "core/content.h"

namespace frond {

void KeyWriter::append_value(std::string& text, double x) {
  fmt::format_to(std::back_inserter(text), "{} ", x == 0 ? 0 : x);  // no -0
}

void KeyWriter::append_value(std::string& text, std::string_view s) {
  fmt::format_to(std::back_inserter(text), "{}:{}", s.size(), s);
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
