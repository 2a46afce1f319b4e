
#include <algorithm>
#include <cstring>

#include "core/parallel.h"
#include "grammar/fast.h"

namespace frond {

namespace {

constexpr std::size_t kLongest = 1024;        // symbols that one symbol may become in composed steps
constexpr std::size_t kFixedChunk = 1 << 14;  // symbols of the word that one task rewrites
constexpr std::size_t kFixedBlock = 32;       // bytes copied at a time, whatever the length

/// What every symbol becomes in some number of steps, one word behind the other.
struct Image {
  std::vector<SymbolId> words;
  std::array<std::uint32_t, 256> begin{}, length{};
  std::size_t longest = 0;

  void add(SymbolId symbol, const SymbolId* first, std::size_t count) {
    begin[symbol] = static_cast<std::uint32_t>(words.size());
    length[symbol] = static_cast<std::uint32_t>(count);
    words.insert(words.end(), first, first + count);
    longest = std::max(longest, count);
  }
  void close() { words.resize(words.size() + kFixedBlock); }  // the last word may be read past its end
};

Image one_step(const Grammar& grammar) {
  Image image;
  for (std::size_t i = 0; i < grammar.symbols.size(); ++i) {
    auto symbol = static_cast<SymbolId>(i);
    const auto& of = grammar.rules.of[i];
    if (of.empty())
      image.add(symbol, &symbol, 1);
    else
      image.add(symbol, grammar.rules.rules[of[0]].successor.data(),
                grammar.rules.rules[of[0]].successor.size());
  }
  image.close();
  return image;
}

/// One step more than `image`.
Image compose(const Image& image, const Image& step, std::size_t symbols) {
  Image next;
  std::vector<SymbolId> word;
  for (std::size_t i = 0; i < symbols; ++i) {
    word.clear();
    for (std::uint32_t k = 0; k < step.length[i]; ++k) {
      SymbolId inner = step.words[step.begin[i] + k];
      auto first = image.words.begin() + image.begin[inner];
      word.insert(word.end(), first, first + image.length[inner]);
    }
    next.add(static_cast<SymbolId>(i), word.data(), word.size());
  }
  next.close();
  return next;
}

/// Images of 1, 2, … steps while they stay short, no more than `most`.
std::vector<Image> images_of(const Grammar& grammar, int most) {
  std::vector<Image> images{one_step(grammar)};
  while (static_cast<int>(images.size()) < most && images.size() < 64) {
    if (images.back().longest * images[0].longest > kLongest * 16) break;
    Image next = compose(images.back(), images[0], grammar.symbols.size());
    if (next.longest > kLongest) break;
    images.push_back(std::move(next));
  }
  return images;
}

/// Writes the images of the symbols from `first` on, to exactly `end`. Blocks are copied whole while there is
/// room behind them, which is faster than copying the right number of bytes.
void write(const Image& image, const SymbolId* first, const SymbolId* last, SymbolId* out,
           const SymbolId* end) {
  const SymbolId* words = image.words.data();
  std::ptrdiff_t room = static_cast<std::ptrdiff_t>(image.longest + kFixedBlock);
  while (first != last && end - out >= room) {
    std::size_t length = image.length[*first];
    const SymbolId* word = words + image.begin[*first++];
    std::memcpy(out, word, kFixedBlock);
    if (length > 4 * kFixedBlock) {
      std::memcpy(out + kFixedBlock, word + kFixedBlock, length - kFixedBlock);
    } else {
      for (std::size_t at = kFixedBlock; at < length; at += kFixedBlock)
        std::memcpy(out + at, word + at, kFixedBlock);
    }
    out += length;
  }
  for (; first != last; ++first) {
    std::size_t length = image.length[*first];
    if (length > 0) std::memcpy(out, words + image.begin[*first], length);
    out += length;
  }
}

/// Counts, sums up, writes. False where the outcome passes the limit.
bool apply(const Image& image, const Buffer<SymbolId>& in, Buffer<SymbolId>& out, std::size_t limit) {
  std::size_t chunks = (in.size() + kFixedChunk - 1) / kFixedChunk;
  std::vector<std::size_t> begin(chunks + 1);
  auto range = [&](std::size_t i) {
    return std::pair{in.data() + i * kFixedChunk, in.data() + std::min(in.size(), (i + 1) * kFixedChunk)};
  };
  parallel_for(chunks, [&](std::size_t i) {
    auto [first, last] = range(i);
    std::size_t sum = 0;
    for (; first != last; ++first) sum += image.length[*first];
    begin[i + 1] = sum;
  });
  for (std::size_t i = 0; i < chunks; ++i) begin[i + 1] += begin[i];
  if (begin[chunks] > limit) return false;
  out.clear();
  if (out.capacity() < begin[chunks]) Buffer<SymbolId>().swap(out);
  out.resize(begin[chunks]);
  parallel_for(chunks, [&](std::size_t i) {
    auto [first, last] = range(i);
    write(image, first, last, out.data() + begin[i], out.data() + begin[i + 1]);
  });
  return true;
}

}  // namespace

bool is_fixed(const Grammar& grammar) {
  return grammar.single && !grammar.parametric && grammar.context_free && !grammar.cuts && !grammar.queries &&
         grammar.decomposition.empty() && grammar.text.mode == GrammarText::Mode::parallel;
}

Errors advance_fixed(const Grammar& grammar, Derivation& state, int steps, const Limits& limits) {
  if (steps == 0) return {};
  std::vector<Image> images = images_of(grammar, steps);
  Word next;
  for (int left = steps; left > 0;) {
    auto at_once = static_cast<int>(images.size());
    if (left % at_once != 0) at_once = left % at_once;
    left -= at_once;
    if (!apply(images[static_cast<std::size_t>(at_once) - 1], state.word.symbols, next.symbols,
               std::min(limits.modules, limits.bytes)))
      return {error_at("", "by step {} the word passes the limit of {} modules; use fewer steps",
                       state.steps + at_once, limits.modules)};
    std::swap(state.word, next);
    state.steps += at_once;
  }
  return {};
}

}  // namespace frond
