#include "render/label.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.h"

namespace frond {

namespace {

/// Where the character after so many begins.
std::size_t after(std::string_view text, std::size_t characters) {
  std::size_t at = 0;
  for (; at < text.size(); ++at)
    if ((static_cast<unsigned char>(text[at]) & 0xc0) != 0x80 && characters-- == 0) break;
  return at;
}

/// How many characters fit below a picture.
std::size_t fitting(int width) {
  int most = width > 224 ? width * 100 / 1024 : width > 112 ? 21 : width > 16 ? width * 100 / 512 : 3;
  return static_cast<std::size_t>(most);
}

/// Breaks a text at blanks, or within a word that is too long.
void fold(std::string_view text, std::size_t most, std::vector<std::string>& lines) {
  for (;;) {
    std::size_t end = after(text, most);
    if (end == text.size()) break;
    std::size_t blank = text.substr(0, end).rfind(' ');
    if (blank != text.npos) end = blank + 1;
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  lines.emplace_back(text);
}

}  // namespace

std::vector<std::string> label_lines(std::string_view text, int width) {
  constexpr std::string_view kPart = "   ";
  std::string clean(text);
  std::ranges::replace_if(
      clean, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  std::vector<std::string> lines;
  std::string_view rest = clean;
  std::size_t most = fitting(width);
  bool parted = after(clean, most) < clean.size();
  for (std::size_t at; parted && (at = rest.find(kPart)) != rest.npos;) {
    fold(rest.substr(0, at), most, lines);
    rest.remove_prefix(at + kPart.size());
  }
  fold(rest, most, lines);
  return lines;
}

Errors Labels::add(const std::string& name, std::string_view text, int width) {
  std::vector<std::string> lines = label_lines(text, width);
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (std::error_code error = write_new(folder_ / fmt::format("{}.{}", name, i + 1), lines[i]); error)
      return {{folder_.string(), reason_of(error)}};
  labels_.push_back({name, lines.size()});
  most_ = std::max(most_, lines.size());
  return {};
}

std::string Labels::filter(const std::string& name) const {
  constexpr std::size_t kLine = 18, kAround = 10, kBelow = 2;  // pixels
  std::string filter = fmt::format("pad=iw:ih+{}:0:0:0x202020", kAround + kLine * most_);
  auto label = std::ranges::find(labels_, name, &Label::name);
  for (std::size_t line = 1; label != labels_.end() && line <= label->lines; ++line)
    filter += fmt::format(
        ",drawtext=textfile={}.{}:expansion=none:fontcolor=white:fontsize='clip(w/14,8,16)'"
        ":x='max(0,(w-tw)/2)':y=h-{}",
        name, line, kBelow + kLine * (most_ - line + 1));
  return filter;
}

}  // namespace frond
