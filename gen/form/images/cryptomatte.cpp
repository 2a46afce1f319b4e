#include "images/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <map>

namespace frond {

namespace {

/// The bytes of a text as a number, the first the lowest; at most four.
std::uint32_t number_of(std::string_view bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    number |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  return number;
}

std::uint32_t scrambled(std::uint32_t block) { return std::rotl(block * 0xcc9e2d51u, 15) * 0x1b873593u; }

/// A text as a JSON string with its quotes. UTF-8 is kept.
std::string quoted(std::string_view text) {
  std::string words = "\"";
  for (char c : text) {
    auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20) {
      words += fmt::format("\\u{:04x}", unsigned{byte});
      continue;
    }
    if (c == '"' || c == '\\') words += '\\';
    words += c;
  }
  return words + '"';
}

std::string hex(std::uint32_t id) { return fmt::format("{:08x}", id); }

/// Names and their ids as JSON, each name once, sorted.
std::string manifest_of(std::span<const std::string> names) {
  std::map<std::string_view, std::uint32_t> ids;
  for (const std::string& name : names) ids.emplace(name, cryptomatte_id(name));
  std::string text;
  for (const auto& [name, id] : ids)
    text += fmt::format("{}{}:\"{}\"", text.empty() ? "" : ",", quoted(name), hex(id));
  return "{" + text + "}";
}

/// An id and how much of a pixel it covers.
struct Rank {
  std::uint32_t id = 0;
  float share = 0;
};

/// The ids of a pixel, those that cover more first, and of equal ones the smaller id. `ranks` is used again
/// for the next.
void rank(std::span<const Coverages::Entry> entries, std::span<const std::uint32_t> ids,
          std::vector<Rank>& ranks) {
  ranks.clear();
  for (const Coverages::Entry& entry : entries) {
    std::uint32_t id = ids[entry.name];
    auto same = std::find_if(ranks.begin(), ranks.end(), [&](const Rank& other) { return other.id == id; });
    if (same == ranks.end()) same = ranks.insert(same, {id, 0});
    same->share += entry.share;
  }
  std::sort(ranks.begin(), ranks.end(), [](const Rank& a, const Rank& b) {
    return a.share != b.share ? a.share > b.share : a.id < b.id;
  });
}

/// The channels of so many ranks, all of them 0: four for two ranks.
std::vector<ExrChannel> channels_of(const std::string& layer, int ranks, std::size_t pixels) {
  std::vector<ExrChannel> channels;
  for (int pair = 0; pair < (ranks + 1) / 2; ++pair)
    for (char color : {'R', 'G', 'B', 'A'})
      channels.push_back({fmt::format("{}{:02}.{}", layer, pair, color),
                          ExrChannel::Kind::single,
                          std::vector<float>(pixels),
                          {}});
  return channels;
}

}  // namespace

std::uint32_t murmur_hash(std::string_view text) {
  std::uint32_t hash = 0;
  std::string_view rest = text;
  for (; rest.size() >= 4; rest.remove_prefix(4))
    hash = std::rotl(hash ^ scrambled(number_of(rest.substr(0, 4))), 13) * 5 + 0xe6546b64u;
  hash ^= scrambled(number_of(rest));
  hash ^= static_cast<std::uint32_t>(text.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bu;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
  return hash ^ hash >> 16;
}

std::uint32_t cryptomatte_id(std::string_view name) {
  std::uint32_t hash = murmur_hash(name), exponent = hash >> 23 & 255;
  return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

Cryptomatte cryptomatte(const std::string& layer, std::span<const std::string> names,
                        const Coverages& coverages, int ranks) {
  assert(coverages.ends.empty() || coverages.ends.back() == coverages.entries.size());
  std::vector<std::uint32_t> ids;
  for (const std::string& name : names) ids.push_back(cryptomatte_id(name));
  Cryptomatte made;
  made.channels = channels_of(layer, ranks, coverages.ends.size());
  std::vector<Rank> ranked;
  std::size_t begin = 0;
  for (std::size_t pixel = 0; pixel < coverages.ends.size(); ++pixel) {
    std::size_t end = coverages.ends[pixel];
    rank(std::span(coverages.entries).subspan(begin, end - begin), ids, ranked);
    begin = end;
    for (std::size_t i = 0; i < std::min(ranked.size(), static_cast<std::size_t>(ranks)); ++i) {
      made.channels[2 * i].values[pixel] = std::bit_cast<float>(ranked[i].id);
      made.channels[2 * i + 1].values[pixel] = ranked[i].share;
    }
  }
  std::string key = "cryptomatte/" + hex(cryptomatte_id(layer)).substr(0, 7) + "/";
  made.attributes = {{key + "name", layer},
                     {key + "hash", "MurmurHash3_32"},
                     {key + "conversion", "uint32_to_float32"},
                     {key + "manifest", manifest_of(names)}};
  return made;
}

}  // namespace frond
