#include "grammar/word.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include "grammar/grammar.h"

namespace frond {

void* allocate_pages(std::size_t bytes) {
  constexpr std::size_t kPage = std::size_t{2} << 20;
  void* memory = nullptr;
  if (bytes < 4 * kPage) {
    memory = std::malloc(bytes);
  } else {
    std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
    memory = std::aligned_alloc(kPage, whole);
#ifdef __linux__
    if (memory) madvise(memory, whole, MADV_HUGEPAGE);
#endif
  }
  if (!memory) throw std::bad_alloc();
  return memory;
}

void release_pages(void* memory) { std::free(memory); }

std::string text(const Grammar& grammar, const Word& word) {
  std::string out;
  out.reserve(word.size() + word.parameters.size() * 12);
  const double* parameter = word.parameters.data();
  for (SymbolId id : word.symbols) {
    const Symbol& symbol = grammar.symbols[id];
    out += symbol.name;
    for (int i = 0; i < symbol.arity; ++i) {
      char number[32];
      // "%.10g" of the C locale, which the program never leaves; -0 is written as 0.
      int size = std::snprintf(number, sizeof number, "%.10g", *parameter++ + 0.0);
      out += i == 0 ? '(' : ',';
      out.append(number, static_cast<std::size_t>(size));
    }
    if (symbol.arity > 0) out += ')';
  }
  return out;
}

std::vector<std::pair<std::string, std::size_t>> counts(const Grammar& grammar, const Word& word) {
  std::array<std::size_t, 256> times{};
  for (SymbolId id : word.symbols) ++times[id];
  std::vector<std::pair<std::string, std::size_t>> found;
  for (std::size_t i = 0; i < grammar.symbols.size(); ++i) {
    if (times[i] == 0) continue;
    const std::string& name = grammar.symbols[i].name;
    auto same =
        std::find_if(found.begin(), found.end(), [&](const auto& entry) { return entry.first == name; });
    if (same != found.end())
      same->second += times[i];
    else
      found.emplace_back(name, times[i]);
  }
  return found;
}

}  // namespace frond
