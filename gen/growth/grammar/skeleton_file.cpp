#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "grammar/import.h"
#include "grammar/import_text.h"

namespace frond {

namespace {

using namespace import_text;

struct SwcNode {
  DVec3 at{0};
  double radius = 0;
  long long parent = -1;
  Line line;
  std::vector<std::size_t> children;
  std::size_t above = 0;  ///< how many nodes hang from it
};

/// The numbers of a line, between blanks, tabs or commas.
std::vector<double> numbers_of(std::string_view text, Errors& errors, const Line& line) {
  std::vector<double> numbers;
  while (!(text = trim(text)).empty()) {
    std::size_t end = std::min(text.find_first_of(" \t,"), text.size());
    std::optional<double> value = number(text.substr(0, end));
    if (!value)
      return errors.push_back(error_at(place_in(line, text), "`{}` is no number", text.substr(0, end))),
             numbers;
    numbers.push_back(*value);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return numbers;
}

/// The nodes of a skeleton and which hang from which.
class SkeletonFile {
 public:
  SkeletonFile(std::string_view text, bool z_up) : z_up_(z_up) {
    for (Line line : lines_of(text)) {
      line.text = trim(line.text.substr(0, line.text.find('#')));
      if (!line.text.empty()) read_node(line);
    }
    if (errors.empty() && nodes.empty())
      errors.push_back({"", "there is no node; expected lines of seven numbers"});
    if (errors.empty()) connect();
    if (errors.empty()) weigh();
  }

  std::vector<SwcNode> nodes;
  std::vector<std::size_t> roots;
  Errors errors;

 private:
  void read_node(const Line& line) {
    std::vector<double> row = numbers_of(line.text, errors, line);
    if (!errors.empty()) return;
    if (row.size() < 7)
      return errors.push_back(
          error_at(place_in(line, line.text),
                   "found {} numbers; expected seven: number, type, x, y, z, radius and the parent's number",
                   row.size()));
    auto id = std::llround(row[0]);
    if (!index_.try_emplace(id, nodes.size()).second)
      return errors.push_back(error_at(place_in(line, line.text), "the node {} is there twice", id));
    if (row[5] < 0)
      return errors.push_back(
          error_at(place_in(line, line.text), "the radius is {}; expected 0 or more", row[5]));
    DVec3 at = z_up_ ? DVec3{row[2], row[4], -row[3]} : DVec3{row[2], row[3], row[4]};
    nodes.push_back({at, row[5], std::llround(row[6]), line, {}});
  }

  void connect() {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].parent < 0) {
        roots.push_back(i);
        continue;
      }
      auto parent = index_.find(nodes[i].parent);
      if (parent == index_.end())
        return errors.push_back(error_at(place_in(nodes[i].line, nodes[i].line.text),
                                         "there is no node {} to hang from; a first node has -1",
                                         nodes[i].parent));
      nodes[parent->second].children.push_back(i);
    }
  }

  /// Counts what hangs from each node; nodes that no root leads to hang from each other.
  void weigh() {
    std::vector<std::size_t> order = roots;
    for (std::size_t k = 0; k < order.size(); ++k)
      order.insert(order.end(), nodes[order[k]].children.begin(), nodes[order[k]].children.end());
    std::vector<char> seen(nodes.size());
    for (std::size_t i : order) seen[i] = 1;
    auto lost = std::ranges::find(seen, 0);
    if (lost != seen.end()) {
      const Line& line = nodes[static_cast<std::size_t>(lost - seen.begin())].line;
      return errors.push_back({place_in(line, line.text), "this node hangs from itself by way of others"});
    }
    for (std::size_t k = order.size(); k-- > 0;)
      for (std::size_t child : nodes[order[k]].children) nodes[order[k]].above += nodes[child].above + 1;
  }

  std::map<long long, std::size_t> index_;
  bool z_up_;
};

/// The child that the way goes on to at a fork: the thickest, of those the one that carries most.
std::size_t main_child(const std::vector<SwcNode>& nodes, std::size_t at) {
  return *std::ranges::max_element(nodes[at].children, {},
                                   [&](std::size_t i) { return std::pair(nodes[i].radius, nodes[i].above); });
}

/// Writes the word that draws a skeleton. Other children than the main one are branches before it.
class SkeletonWord {
 public:
  explicit SkeletonWord(const SkeletonFile& file) : nodes_(file.nodes) {
    for (const SwcNode& node : nodes_)
      if (node.radius > 0 && (least_ == 0 || node.radius < least_)) least_ = node.radius;
    if (least_ == 0) least_ = 0.01;
    for (std::size_t root : file.roots) {
      bool alone = file.roots.size() == 1;
      const DVec3& at = nodes_[root].at;
      word += fmt::format("{}@M({:.9g},{:.9g},{:.9g})!({:.9g})", alone ? "" : "[", at.x, at.y, at.z,
                          width(nodes_[root]));
      grow(root);
      if (!alone) word += ']';
    }
  }

  std::string word;

 private:
  /// What is still to be written: a way from a node to another, or a sign.
  struct Piece {
    char sign = 0;
    std::size_t from = 0, to = 0;
  };

  double width(const SwcNode& node) const { return 2 * (node.radius > 0 ? node.radius : least_); }

  void add_segment(std::size_t from, std::size_t to) {
    DVec3 way = nodes_[to].at - nodes_[from].at;
    double length = glm::length(way);
    if (!(length > 0)) return void(word += fmt::format("!({:.9g})", width(nodes_[to])));
    way /= length;
    word += fmt::format("@R({:.9g},{:.9g},{:.9g})F({:.9g},{:.9g})", way.x, way.y, way.z, length,
                        width(nodes_[to]));
  }

  void grow(std::size_t root) {
    std::vector<Piece> pieces;  // the last one comes next
    go_on(root, pieces);
    while (!pieces.empty()) {
      Piece piece = pieces.back();
      pieces.pop_back();
      if (piece.sign != 0) {
        word += piece.sign;
      } else {
        add_segment(piece.from, piece.to);
        go_on(piece.to, pieces);
      }
    }
  }

  void go_on(std::size_t at, std::vector<Piece>& pieces) {
    const std::vector<std::size_t>& children = nodes_[at].children;
    if (children.empty()) return void(word += 'T');
    std::size_t main = main_child(nodes_, at);
    pieces.push_back({0, at, main});
    for (std::size_t k = children.size(); k-- > 0;)
      if (children[k] != main)
        pieces.insert(pieces.end(), {Piece{']'}, Piece{0, at, children[k]}, Piece{'['}});
  }

  const std::vector<SwcNode>& nodes_;
  double least_ = 0;
};

}  // namespace

Result<GuideLines> skeleton_lines(std::string_view text) {
  SkeletonFile file(text, false);
  if (!file.errors.empty()) return file.errors;
  GuideLines lines;
  for (const SwcNode& node : file.nodes) lines.place.push_back(node.at);
  std::vector<std::array<std::size_t, 2>> starts;  // a fork, and the child that leaves it; the last is next
  auto go = [&](std::size_t from, std::size_t to) {
    lines.line.push_back({static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to)});
  };
  auto follow = [&](std::size_t at) {
    std::vector<std::array<std::size_t, 2>> sides;
    while (!file.nodes[at].children.empty()) {
      std::size_t main = main_child(file.nodes, at);
      for (std::size_t child : file.nodes[at].children)
        if (child != main) sides.push_back({at, child});
      go(at, main);
      at = main;
    }
    starts.insert(starts.end(), sides.rbegin(), sides.rend());
  };
  for (std::size_t root : file.roots) {
    follow(root);
    while (!starts.empty()) {
      auto [from, to] = starts.back();
      starts.pop_back();
      go(from, to);
      follow(to);
    }
  }
  if (lines.line.empty()) return Error{"", "there is no line; expected two nodes that hang from each other"};
  return lines;
}

Result<GrammarText> import_skeleton(std::string_view text, bool z_up) {
  SkeletonFile file(text, z_up);
  if (!file.errors.empty()) return file.errors;
  GrammarText grammar;
  grammar.axiom = SkeletonWord(file).word;
  grammar.steps = 0;
  grammar.symbols = {"T"};
  DVec3 low = file.nodes[0].at, high = low;
  std::size_t bare = 0;
  for (const SwcNode& node : file.nodes)
    low = glm::min(low, node.at), high = glm::max(high, node.at), bare += node.radius == 0;
  if (bare > 0)
    grammar.notes.push_back(
        error_at("file", "{} nodes have no radius; the least of the others is taken", bare));
  if (high.z - low.z > 1.5 * (high.y - low.y))
    grammar.notes.push_back(
        {"file", "is higher along z than along y: where z is up, turn it when it is imported, by --z-up"});
  return grammar;
}

}  // namespace frond
