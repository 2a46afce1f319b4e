#include <fmt/format.h>

#include <algorithm>

#include "core/printable.h"
#include "core/text.h"
#include "grammar/picture.h"

namespace frond {

namespace {

constexpr std::size_t kMostModules = 2000;

struct Node {
  std::string label;
  std::ptrdiff_t parent = -1;
  double x = 0;
};

using Row = std::vector<Node>;

Row row_of(const Grammar& grammar, const Word& word, const std::vector<std::uint32_t>& parents) {
  Row row;
  const double* parameters = word.parameters.data();
  for (std::size_t i = 0; i < word.size(); ++i) {
    Word module;
    int arity = grammar.symbols[word.symbols[i]].arity;
    module.symbols.push_back(word.symbols[i]);
    module.parameters.assign(parameters, parameters + arity);
    parameters += arity;
    row.push_back({text(grammar, module), parents.empty() ? -1 : static_cast<std::ptrdiff_t>(parents[i]), 0});
  }
  return row;
}

double width_of(const Node& node) {
  // A letter is about 7 wide; UTF-8 continuation bytes are no letters.
  auto letters =
      std::count_if(node.label.begin(), node.label.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return 12.0 + 7.0 * static_cast<double>(letters);
}

/// Places the last row side by side and every parent above the middle of its children, then pushes apart what
/// overlaps. Modules without children keep their order between their neighbours.
double place(std::vector<Row>& rows) {
  double width = 0;
  for (std::size_t level = rows.size(); level-- > 0;) {
    Row& row = rows[level];
    std::vector<double> low(row.size(), 1e30), high(row.size(), -1e30);
    if (level + 1 < rows.size()) {
      for (const Node& child : rows[level + 1]) {
        auto parent = static_cast<std::size_t>(child.parent);
        low[parent] = std::min(low[parent], child.x);
        high[parent] = std::max(high[parent], child.x);
      }
    }
    double edge = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      double half = width_of(row[i]) / 2;
      double wish = high[i] >= low[i] ? (low[i] + high[i]) / 2 : 0;
      row[i].x = std::max(wish, edge + half);
      edge = row[i].x + half;
    }
    width = std::max(width, edge);
  }
  return width;
}

void put_hundredths(std::string& out, double number) { append(out, number, 2); }

std::string draw_rows(const std::vector<Row>& rows, double width) {
  constexpr double kRow = 56, kTop = 28;
  double height = kTop * 2 + kRow * static_cast<double>(rows.size() - 1);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ";
  put_hundredths(out, width + 56), out += ' ', put_hundredths(out, height);
  out += "\" width=\"", put_hundredths(out, width + 56), out += "\" height=\"", put_hundredths(out, height);
  out +=
      "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g stroke=\"#7a8f6a\" stroke-width=\"1\" "
      "fill=\"none\">\n";
  for (std::size_t level = 1; level < rows.size(); ++level) {
    for (const Node& node : rows[level]) {
      const Node& parent = rows[level - 1][static_cast<std::size_t>(node.parent)];
      double y = kTop + kRow * static_cast<double>(level);
      out += "<line x1=\"", put_hundredths(out, parent.x + 48), out += "\" y1=\"",
          put_hundredths(out, y - kRow + 8);
      out += "\" x2=\"", put_hundredths(out, node.x + 48), out += "\" y2=\"", put_hundredths(out, y - 14),
          out += "\"/>\n";
    }
  }
  out += "</g>\n<g font-family=\"monospace\" font-size=\"12\" text-anchor=\"middle\" fill=\"#233\">\n";
  for (std::size_t level = 0; level < rows.size(); ++level) {
    double y = kTop + kRow * static_cast<double>(level);
    out += fmt::format("<text x=\"18\" y=\"{}\" fill=\"#99a\">{}</text>\n", static_cast<int>(y), level);
    for (const Node& node : rows[level]) {
      out += "<text x=\"", put_hundredths(out, node.x + 48), out += "\" y=\"", put_hundredths(out, y),
          out += "\">";
      out += xml_quoted(node.label) + "</text>\n";
    }
  }
  return out + "</g>\n</svg>\n";
}

}  // namespace

Result<std::string> derivation_tree_svg(const Grammar& grammar, int steps, Seed seed) {
  std::vector<Row> rows;
  Derivation state = begin(grammar, seed);
  std::vector<std::uint32_t> parents;
  for (int step = 0;; ++step) {
    if (state.word.size() > kMostModules)
      return Error{"", fmt::format("the word has {} modules after {} steps; a derivation tree is drawn for "
                                   "{} at most: use fewer steps",
                                   state.word.size(), step, kMostModules)};
    rows.push_back(row_of(grammar, state.word, parents));
    if (step == steps) break;
    Errors errors = advance_tracked(grammar, state, seed, parents, grammar.text.limits);
    if (!errors.empty()) return errors;
  }
  double width = place(rows);
  return draw_rows(rows, width);
}

}  // namespace frond
