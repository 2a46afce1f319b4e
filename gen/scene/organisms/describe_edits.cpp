#include "organisms/describe_edits.h"

#include "appearance/describe.h"
#include "preset/keys.h"
#include "preset/reader.h"

namespace frond {

namespace {

bool read_address(Reader& reader, const Value& value, Address& address) {
  std::optional<std::string> given = reader.text_at(value);
  if (!given) return false;
  Result<Address> parsed = parse_address(*given);
  if (parsed) return address = *parsed, true;
  return reader.fault(value, kAddressForm), false;
}

/// `true` for always, or a year.
bool read_cut(Reader& reader, const Value& value, double& year) {
  constexpr double kMostYears = 500;
  if (value.is(Value::Type::boolean) && value.boolean) return year = 0, true;
  if (value.is(Value::Type::number) && value.number >= 1 && value.number <= kMostYears)
    return year = value.number, true;
  return reader.fault(value, "true, or a year of its life from 1 to 500"), false;
}

}  // namespace

void describe_rest(KeyWriter& v, Address& address) {
  std::string name = text(address);
  v.add("", name);
}

void describe(Properties& v, Edit& e) {
  v.custom(
      "at", e.at, read_address, R"({"type": "string"})",
      "The place: numbers of branches, counted from the foot, and a share of the length, as in \"3/1:0.4\": "
      "four tenths along the first branch of the third one of the stem; \":0.7\" is on the stem itself");
  v.required("at");
  v.integer("plant", e.plant, {.min = 0, .max = 1000000},
            "The one of the entry's plants that is meant, counted from 0; without it all are");
  v.custom(
      "cut", e.cut, read_cut,
      R"({"anyOf": [{"const": true}, {"type": "number", "minimum": 1, "maximum": 500}]})",
      "Saws off what is beyond the place; a number is the year of its life at whose end that happens, for "
      "the kind tree, which answers by new shoots");
  v.vector("bend", e.bend, {.min = -100, .max = 100, .unit = "m"},
           "Way by which the place is pulled, as by a wire, in the plant's own upright frame");
  v.number("strength", e.strength, {.min = 0.2, .max = 3},
           "Factor of the length and thickness of all that is beyond the place");
  v.boolean("bare", e.bare, "Takes leaves, flowers and fruit off all that is beyond the place");
  v.object("bark", e.bark,
           "Another bark of all that is beyond the place, for plants; what it does not say is as on the rest "
           "of the plant");
}

}  // namespace frond
