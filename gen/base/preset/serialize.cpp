#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "preset/json.h"

namespace frond {
namespace {

void append_text(std::string& out, std::string_view text) {
  constexpr std::string_view kEscaped = "\"\\\n\r\t", kNames = "\"\\nrt";
  out += '"';
  for (char c : text) {
    bool control = static_cast<unsigned char>(c) < 0x20;
    if (!control && c != '"' && c != '\\')
      out += c;
    else if (std::size_t which = kEscaped.find(c); which != kEscaped.npos)
      (out += '\\') += kNames[which];
    else
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
  }
  out += '"';
}

void append_number(std::string& out, double number) {
  if (number == 0) number = 0;  // of -0
  // The shortest form would write 100000 as 1e+05.
  double size = std::abs(number);
  std::chars_format format =
      size == 0 || (size >= 1e-5 && size < 1e17) ? std::chars_format::fixed : std::chars_format::general;
  std::array<char, 64> digits;
  auto [end, fault] = std::to_chars(digits.data(), digits.data() + digits.size(), number, format);
  out.append(digits.data(), end);
}

bool scalar(const Value& value) { return !value.is(Value::Type::list) && !value.is(Value::Type::object); }

void append_value(std::string& out, const Value& value, std::string_view space) {
  switch (value.type) {
    case Value::Type::null:
      out += "null";
      break;
    case Value::Type::boolean:
      out += value.boolean ? "true" : "false";
      break;
    case Value::Type::number:
      append_number(out, value.number);
      break;
    case Value::Type::text:
      append_text(out, value.text);
      break;
    case Value::Type::list:
      out += '[';
      for (const Value& item : value.items) {
        if (&item != value.items.data()) (out += ',') += space;
        append_value(out, item, space);
      }
      out += ']';
      break;
    case Value::Type::object:
      out += '{';
      for (const Member& member : value.members) {
        if (&member != value.members.data()) (out += ',') += space;
        append_text(out, member.name);
        (out += ':') += space;
        append_value(out, member.value, space);
      }
      out += '}';
      break;
  }
}

struct Pretty {
  std::string out;
  std::size_t width;

  void line(std::size_t indent) {
    out += '\n';
    out.append(indent, ' ');
  }

  std::size_t column() const { return out.size() - (out.rfind('\n') + 1); }

  void append(const Value& value, std::size_t indent) {
    std::string flat;
    append_value(flat, value, " ");
    if (scalar(value) || column() + flat.size() + 1 <= width) {
      out += flat;
    } else if (value.is(Value::Type::list)) {
      append_list(value, indent);
    } else {
      append_object(value, indent);
    }
  }

  // Plain items fill their lines, others have a line each.
  void append_list(const Value& list, std::size_t indent) {
    out += '[';
    line(indent + 2);
    for (const Value& item : list.items) {
      bool first = &item == list.items.data();
      std::string flat;
      if (scalar(item)) append_value(flat, item, " ");
      if (!first) {
        out += ',';
        if (scalar(item) && column() + flat.size() + 2 <= width) {
          out += ' ';
        } else {
          line(indent + 2);
        }
      }
      append(item, indent + 2);
    }
    line(indent);
    out += ']';
  }

  void append_object(const Value& object, std::size_t indent) {
    out += '{';
    for (const Member& member : object.members) {
      if (&member != object.members.data()) out += ',';
      line(indent + 2);
      append_text(out, member.name);
      out += ": ";
      append(member.value, indent + 2);
    }
    line(indent);
    out += '}';
  }
};

}  // namespace

std::string serialize(const Value& value) {
  std::string text;
  append_value(text, value, "");
  return text;
}

std::string serialize_pretty(const Value& value, std::size_t width) {
  Pretty pretty{{}, width};
  pretty.append(value, 0);
  pretty.out += '\n';
  return pretty.out;
}

}  // namespace frond
