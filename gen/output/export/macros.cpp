#include "export/macros.h"

#include <fmt/format.h>

#include <cctype>
#include <functional>
#include <map>

namespace frond {

namespace {

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Calls `visit(word)` for each word of a text with a letter in front.
template <class Visit>
void each_word(std::string_view text, const Visit& visit) {
  for (std::size_t i = 0; i < text.size();) {
    if (!in_word(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && in_word(text[end])) ++end;
    if (std::isalpha(static_cast<unsigned char>(text[i]))) visit(text.substr(i, end - i));
    i = end;
  }
}

/// The lines of a text, each with its end.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

/// What a line at the left edge declares, or nothing.
std::string_view declared(std::string_view line) {
  for (std::string_view directive : {"#macro ", "#declare "}) {
    if (!line.starts_with(directive)) continue;
    line.remove_prefix(directive.size());
    std::size_t end = 0;
    while (end < line.size() && in_word(line[end])) ++end;
    return line.substr(0, end);
  }
  return {};
}

using Owners = std::map<std::string_view, std::size_t, std::less<>>;

/// Which file declares what.
Owners owners_of(const MacroFiles& files) {
  Owners owners;
  for (std::size_t i = 0; i < files.size(); ++i)
    for (std::string_view line : lines_of(files[i].second))
      if (std::string_view name = declared(line); !name.empty()) owners.try_emplace(name, i);
  return owners;
}

/// A text without comments to the ends of its lines.
std::string uncommented(std::string_view text) {
  std::string plain;
  for (std::string_view line : lines_of(text)) {
    line = line.substr(0, line.find("//"));
    line = line.substr(0, line.find_last_not_of(" \n") + 1);
    if (line.empty()) continue;
    plain += line;
    plain += '\n';
  }
  return plain;
}

/// Files cut before each declaration at the left edge.
std::vector<std::string> pieces_of(const MacroFiles& files) {
  std::vector<std::string> pieces;
  for (const auto& [name, content] : files) {
    pieces.emplace_back();
    const std::string plain = uncommented(content);
    for (std::string_view line : lines_of(plain)) {
      if (!declared(line).empty()) pieces.emplace_back();
      pieces.back() += line;
    }
  }
  return pieces;
}

/// The names that a piece declares anywhere.
std::set<std::string_view> declared_in(std::string_view piece) {
  std::set<std::string_view> names;
  for (std::size_t at = piece.find('#'); at != piece.npos; at = piece.find('#', at + 1))
    if (std::string_view name = declared(piece.substr(at)); !name.empty()) names.insert(name);
  return names;
}

/// How many blocks a line opens, less those that it closes.
int opened(std::string_view line) {
  line = line.substr(0, line.find("//"));
  int depth = 0;
  for (std::size_t at = line.find('#'); at != line.npos; at = line.find('#', at + 1)) {
    std::string_view rest = line.substr(at + 1);
    if (rest.starts_with("end")) --depth;
    for (std::string_view word : {"if", "while", "for", "switch", "macro"}) depth += rest.starts_with(word);
  }
  return depth;
}

}  // namespace

std::vector<std::size_t> macros_used(const MacroFiles& files, std::string_view text) {
  Owners owners = owners_of(files);
  std::vector<std::size_t> used;
  std::vector<bool> seen(files.size(), false);
  std::function<void(std::string_view)> reach = [&](std::string_view from) {
    each_word(from, [&](std::string_view word) {
      auto owner = owners.find(word);
      if (owner == owners.end() || seen[owner->second]) return;
      seen[owner->second] = true;
      reach(files[owner->second].second);
      used.push_back(owner->second);
    });
  };
  reach(text);
  return used;
}

std::set<std::string> macros_called(const MacroFiles& files, std::string_view text) {
  std::map<std::string_view, std::string_view, std::less<>> signatures;
  for (const auto& [file, content] : files)
    for (std::string_view line : lines_of(content))
      if (line.starts_with("#macro ")) signatures[declared(line)] = line.substr(7, line.find(')') + 1 - 7);
  std::set<std::string> called;
  each_word(text, [&](std::string_view word) {
    if (auto found = signatures.find(word); found != signatures.end()) called.emplace(found->second);
  });
  return called;
}

std::string macros_reached(const MacroFiles& files, std::string_view text) {
  std::vector<std::string> pieces = pieces_of(files);
  std::map<std::string_view, std::vector<std::size_t>, std::less<>> owners;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::string_view name : declared_in(pieces[i])) owners[name].push_back(i);
  std::vector<bool> reached(pieces.size(), false);
  std::function<void(std::string_view)> reach = [&](std::string_view from) {
    each_word(from, [&](std::string_view word) {
      auto owner = owners.find(word);
      if (owner == owners.end()) return;
      for (std::size_t i : owner->second) {
        if (reached[i]) continue;
        reached[i] = true;
        reach(pieces[i]);
      }
    });
  };
  reach(text);
  std::string all;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (reached[i]) all += pieces[i];
  return all;
}

std::string macros_text(const MacroFiles& files, const std::vector<std::size_t>& used) {
  std::string text;
  for (std::size_t file : used) {
    int depth = 0;  // of the macro that is being written
    for (std::string_view line : lines_of(files[file].second)) {
      if (line.starts_with("#include")) continue;
      bool begins = depth == 0 && line.starts_with("#macro ");
      if (begins) text += fmt::format("#ifndef ({})\n", declared(line));
      text += line;
      if (begins || depth > 0) {
        depth += opened(line);
        if (depth == 0) text += "#end\n";
      }
    }
  }
  return text;
}

}  // namespace frond
