#include "scene/taxon.h"

#include <algorithm>
#include <cctype>

#include "core/files.h"
#include "core/home.h"
#include "preset/json.h"
#include "preset/reader.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr Range kLengths = metres(0, 150);
constexpr Range kMonths{.min = 1, .max = 12, .unit = "months"};

/// A name as names are compared: in lower case, its words parted by blanks.
std::string plain_name(std::string_view name) {
  std::string plain;
  for (char c : name)
    plain += c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return plain;
}

bool is_called(const Taxon& taxon, std::string_view name) {
  auto same = [plain = plain_name(name)](const std::string& own) { return plain_name(own) == plain; };
  return same(taxon.latin) || std::ranges::any_of(taxon.names, same);
}

}  // namespace

void describe(Properties& v, TaxonPart& p) {
  v.text("organ", p.organ,
         "The symbol of the first organism's organ that is it, or `leaf`, `blossom` or `fruit` of a tree; "
         "empty: it is none of its own");
  v.number("share", p.share, {.min = 0.01, .max = 1},
           "Share of that organ's length that it has, where the organ is a sprig of several");
  v.vector("size", p.size, kLengths, "Smallest and largest length or diameter that is usual");
  v.required("size");
}

void describe(Properties& v, Taxon& t) {
  v.text("latin", t.latin, "The scientific name");
  v.required("latin");
  v.list("names", t.names, "Everyday names, by which it is found");
  v.vector("height", t.height, kLengths, "Smallest and largest height of grown plants");
  v.vector("spread", t.spread, kLengths, "Smallest and largest width of grown plants");
  v.object("leaf", t.leaf, "A leaf");
  v.object("flower", t.flower, "A flower, or a head or spike of them");
  v.object("fruit", t.fruit, "A fruit");
  v.object("body", t.body, "An animal of a school; its organ is called as its `animal`");
  v.vector("flowering", t.flowering, kMonths, "First and last month of flowers where it is at home");
  v.vector("fruiting", t.fruiting, kMonths, "First and last month of ripe fruit");
  v.vector("in_leaf", t.in_leaf, kMonths, "First and last month of leaves");
  v.text("source", t.source, "Where these figures come from");
}

std::vector<ShippedSpecies> shipped_species() {
  std::vector<ShippedSpecies> all;
  for (const fs::path& file : files_below(home_folder() / "presets")) {
    if (file.extension() != ".json") continue;
    Result<std::string> text = read_file(file);
    if (!text || text->find("\"taxon\"") == text->npos) continue;
    Result<Document> document = parse_json(*text, file.string());
    const Value* told = document ? document->root.find("taxon") : nullptr;
    ShippedSpecies one{file, {}};
    if (told && Reader().object_at(*told, one.taxon)) all.push_back(std::move(one));
  }
  return all;
}

std::optional<fs::path> shipped_by_name(std::string_view name) {
  if (std::optional<fs::path> file = shipped_preset(name)) return file;
  if (name.empty()) return std::nullopt;
  for (ShippedSpecies& species : shipped_species())
    if (is_called(species.taxon, name)) return std::move(species.file);
  return std::nullopt;
}

}  // namespace frond
