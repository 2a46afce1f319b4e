
#include <cctype>
#include <charconv>
#include <cmath>
#include <pugixml.hpp>
#include <string>

#include "crown/silhouette.h"

namespace frond {

namespace {

constexpr int kPieces = 16;    // of a curve
constexpr double kMost = 1e9;  // of a number; what curves reach beyond it still is one to a float

double cross2(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

/// Reads path data command by command, and draws as it goes.
class PathReader {
 public:
  explicit PathReader(std::string_view data) : data_(data) {}

  Result<std::vector<std::vector<Vec2>>> read() {
    char command = 0;
    for (skip(); at_ < data_.size(); skip()) {
      char c = data_[at_];
      if (std::isalpha(static_cast<unsigned char>(c))) {
        command = c;
        ++at_;
      } else if (command == 0 || command == 'Z' || command == 'z') {
        return fault("a command letter");
      } else if (command == 'M' || command == 'm') {
        command = command == 'M' ? 'L' : 'l';  // further points of a move are lines
      }
      if (outlines_.empty() && command != 'M' && command != 'm') return fault("M or m to begin with");
      if (!run_command(command)) return fault(wanted_);
    }
    return std::move(outlines_);
  }

 private:
  Error fault(std::string_view expected) const {
    return error_at("", "the path has \"{}\" at character {}; expected {}", data_.substr(at_, 12), at_ + 1,
                    expected);
  }

  void skip() {
    while (at_ < data_.size() && (std::isspace(static_cast<unsigned char>(data_[at_])) || data_[at_] == ','))
      ++at_;
  }

  bool number(double& x) {
    skip();
    std::size_t from = at_ < data_.size() && data_[at_] == '+' ? at_ + 1 : at_;
    auto [end, error] = std::from_chars(data_.data() + from, data_.data() + data_.size(), x);
    if (error != std::errc{} || !(std::abs(x) <= kMost)) return wanted_ = "a number from -1e9 to 1e9", false;
    at_ = static_cast<std::size_t>(end - data_.data());
    return true;
  }

  bool flag(bool& on) {
    skip();
    if (at_ >= data_.size() || (data_[at_] != '0' && data_[at_] != '1')) return wanted_ = "0 or 1", false;
    on = data_[at_++] == '1';
    return true;
  }

  bool point(bool relative, Vec2& p) {
    double x = 0, y = 0;
    if (!number(x) || !number(y)) return false;
    p = Vec2(x, y) + (relative ? pen_ : Vec2(0));
    return true;
  }

  void line_to(Vec2 p) {
    outlines_.back().push_back(p);
    pen_ = p;
  }

  void bezier(Vec2 a, Vec2 b, Vec2 to) {
    Vec2 from = pen_;
    for (int i = 1; i <= kPieces; ++i) {
      float t = static_cast<float>(i) / kPieces, u = 1 - t;
      line_to(from * (u * u * u) + a * (3 * u * u * t) + b * (3 * u * t * t) + to * (t * t * t));
    }
  }

  bool run_command(char command) {
    bool relative = std::islower(static_cast<unsigned char>(command));
    char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    Vec2 hint = pen_;
    Vec2 a, b, to;
    double x = 0;
    switch (upper) {
      case 'M':
        if (!point(relative, to)) return false;
        outlines_.push_back({to});
        pen_ = start_ = to;
        break;
      case 'Z':
        pen_ = start_;
        outlines_.push_back({start_});
        break;
      case 'L':
        if (!point(relative, to)) return false;
        line_to(to);
        break;
      case 'H':
      case 'V': {
        if (!number(x)) return false;
        auto value = static_cast<float>(x);
        line_to(upper == 'H' ? Vec2(relative ? pen_.x + value : value, pen_.y)
                             : Vec2(pen_.x, relative ? pen_.y + value : value));
        break;
      }
      case 'C':
      case 'S':
        a = smooth_ == 'C' ? pen_ * 2.0f - hint_ : pen_;
        if (upper == 'C' && !point(relative, a)) return false;
        if (!point(relative, b) || !point(relative, to)) return false;
        bezier(a, b, to);
        hint = b;
        break;
      case 'Q':
      case 'T':
        a = smooth_ == 'Q' ? pen_ * 2.0f - hint_ : pen_;
        if (upper == 'Q' && !point(relative, a)) return false;
        if (!point(relative, to)) return false;
        bezier(glm::mix(pen_, a, 2.0f / 3), glm::mix(to, a, 2.0f / 3), to);
        hint = a;
        break;
      case 'A':
        if (!arc(relative)) return false;
        break;
      default:
        --at_;
        return wanted_ = "one of M L H V C S Q T A Z", false;
    }
    smooth_ = upper == 'C' || upper == 'S' ? 'C' : upper == 'Q' || upper == 'T' ? 'Q' : 0;
    hint_ = hint;
    return true;
  }

  /// An elliptical arc from its ends (SVG 1.1, F.6.5).
  bool arc(bool relative) {
    double rx = 0, ry = 0, turn = 0;
    bool large = false, sweep = false;
    Vec2 to;
    if (!number(rx) || !number(ry) || !number(turn) || !flag(large) || !flag(sweep) || !point(relative, to))
      return false;
    rx = std::abs(rx), ry = std::abs(ry);
    if (rx == 0 || ry == 0 || to == pen_) return line_to(to), true;
    auto c = static_cast<float>(std::cos(radians(turn))), s = static_cast<float>(std::sin(radians(turn)));
    Vec2 half = (pen_ - to) * 0.5f, p(c * half.x + s * half.y, -s * half.x + c * half.y);
    double grow = p.x * p.x / (rx * rx) + p.y * p.y / (ry * ry);
    if (grow > 1) rx *= std::sqrt(grow), ry *= std::sqrt(grow);
    double below = rx * rx * p.y * p.y + ry * ry * p.x * p.x;
    double k = std::sqrt(std::max(0.0, (rx * rx * ry * ry - below) / below)) * (large != sweep ? 1 : -1);
    Vec2 q(k * rx * p.y / ry, -k * ry * p.x / rx);
    Vec2 radii(rx, ry), u = (p - q) / radii, v = (-p - q) / radii;
    double from = std::atan2(u.y, u.x), span = std::atan2(cross2(u, v), glm::dot(u, v));
    if (sweep && span < 0) span += 2 * kPi;
    if (!sweep && span > 0) span -= 2 * kPi;
    Vec2 middle = (pen_ + to) * 0.5f + Vec2(c * q.x - s * q.y, s * q.x + c * q.y);
    for (int i = 1; i < kPieces; ++i) {
      double angle = from + span * i / kPieces;
      Vec2 e = radii * Vec2(std::cos(angle), std::sin(angle));
      line_to(middle + Vec2(c * e.x - s * e.y, s * e.x + c * e.y));
    }
    line_to(to);
    return true;
  }

  std::string_view data_;
  std::size_t at_ = 0;
  std::vector<std::vector<Vec2>> outlines_;
  Vec2 pen_{0}, start_{0}, hint_{0};
  char smooth_ = 0;  // which kind of curve the last command drew
  std::string_view wanted_ = "a command letter";
};

}  // namespace

Result<std::vector<std::vector<Vec2>>> read_svg_path(std::string_view data) {
  return PathReader(data).read();
}

Result<std::vector<std::vector<Vec2>>> read_svg(std::string_view svg) {
  pugi::xml_document document;
  pugi::xml_parse_result parsed = document.load_buffer(svg.data(), svg.size());
  if (!parsed) return Error{"", std::string("no XML: ") + parsed.description()};
  std::vector<std::vector<Vec2>> all;
  for (pugi::xpath_node found : document.select_nodes("//*[local-name()='path']/@d")) {
    Result<std::vector<std::vector<Vec2>>> path = read_svg_path(found.attribute().value());
    if (!path) return path.errors();
    all.insert(all.end(), path->begin(), path->end());
  }
  if (all.empty()) return Error{"", "holds no <path> with outlines"};
  return all;
}

}  // namespace frond
