#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string>

#include "core/seed.h"
#include "preset/judge.h"
#include "preset/override.h"

// Texts that went wrong by chance: none may bring the reader down, and each fault has a place in the text.
namespace frond {
namespace {

using reef::kGood;

/// Whether `where` ("p.json:line:column: /pointer") is a place of the text, its end included.
bool inside(std::string_view text, std::string_view where) {
  constexpr std::string_view kFile = "p.json:";
  if (!where.starts_with(kFile)) return false;
  const char* end = where.data() + where.size();
  long line = 0;
  long column = 0;
  auto after_line = std::from_chars(where.data() + kFile.size(), end, line);
  if (after_line.ec != std::errc() || *after_line.ptr != ':') return false;
  auto after_column = std::from_chars(after_line.ptr + 1, end, column);
  if (after_column.ec != std::errc() || !std::string_view(after_column.ptr, end).starts_with(": /"))
    return false;
  std::size_t start = 0;
  for (long i = 1; i < line; ++i) {
    start = text.find('\n', start);
    if (start == text.npos) return false;
    ++start;
  }
  std::size_t length = std::min(text.find('\n', start), text.size()) - start;
  return line >= 1 && column >= 1 && column <= static_cast<long>(length) + 1;
}

/// Reads the text and looks at what comes of it; whether it was read.
bool survives(const std::string& text, SchemaJudge& judge) {
  Result<Document> document = parse_json(text, "p.json");
  if (document) {
    nlohmann::json theirs = nlohmann::json::parse(text, nullptr, false, true);
    EXPECT_FALSE(theirs.is_discarded()) << "a library refuses what we read: " << text;
    Result<reef::Preset> preset = read_preset<reef::Preset>(*document);
    if (preset) {
      EXPECT_TRUE(judge.accepts(serialize(document->root))) << judge.reason() << text;
      return true;
    }
    EXPECT_FALSE(preset.errors().empty());
    for (const Error& error : preset.errors())
      EXPECT_TRUE(inside(text, error.where)) << error.text() << "\n" << text;
    return false;
  }
  EXPECT_FALSE(document.errors().empty());
  for (const Error& error : document.errors()) {
    EXPECT_TRUE(inside(text, error.where)) << error.text() << "\n" << text;
    EXPECT_NE(error.what.find("; expected "), std::string::npos) << error.what;
  }
  return false;
}

TEST(Robustness, EveryTruncation) {
  SchemaJudge judge;
  for (std::size_t size = 0; size < kGood.size() - 2; ++size) {
    EXPECT_FALSE(survives(std::string(kGood.substr(0, size)), judge)) << size;
  }
}

TEST(Robustness, RandomBytes) {
  SchemaJudge judge;
  constexpr std::string_view kBytes = "{}[]\",:0123456789.-+eE/*\\ntrue \n\t\r#u\xc3\xff";
  for (unsigned round = 0; round < 1500; ++round) {
    Seed seed = Seed{1}.child(round);
    std::string text(kGood);
    auto edits = 1 + seed.child("edits").bits() % 3;
    for (unsigned i = 0; i < edits; ++i) {
      std::size_t at = seed.child("at", i).bits() % text.size();
      char byte = kBytes[seed.child("byte", i).bits() % kBytes.size()];
      switch (seed.child("kind", i).bits() % 4) {
        case 0:
          text[at] = byte;
          break;
        case 1:
          text.insert(at, 1, byte);
          break;
        case 2:
          text.erase(at, 1 + seed.child("length", i).bits() % 20);
          break;
        default:
          text.insert(at, kGood.substr(at % kGood.size(), seed.child("length", i).bits() % 40));
          break;
      }
    }
    survives(text, judge);
  }
}

/// Puts one of a few values in the place of the n-th value of the tree, counted down from n.
void disturb(Value& value, long& n, const Value& other) {
  if (n-- == 0) value = other;
  for (Value& item : value.items) disturb(item, n, other);
  for (Member& member : value.members) disturb(member.value, n, other);
}

TEST(Robustness, WrongValuesEverywhere) {
  SchemaJudge judge;
  int read = 0;
  for (std::string_view other : {"null", "true", "-1", "0.5", "1e308", "\"x\"", "\"\"", "[]", "[[]]",
                                 "[[0, 1]]", "[1, 2, 3]", "{}", "{\"kind\": \"rock\"}", "{\"a\": 1}"}) {
    Value wrong = parse_json(other, "p.json")->root;
    for (long n = 0;; ++n) {
      Document document = *parse_json(kGood, "p.json");
      long left = n;
      disturb(document.root, left, wrong);
      if (left >= 0) break;
      read += survives(serialize(document.root), judge);
    }
  }
  EXPECT_GT(read, 20) << "some of it is allowed";
}

TEST(Robustness, OverridesOfEveryKind) {
  for (unsigned round = 0; round < 500; ++round) {
    Document document = *parse_json(kGood, "p.json");
    Seed seed = Seed{2}.child(round);
    std::string assignment;
    constexpr std::string_view kParts[] = {"/organisms", "/0",    "/-", "/wave", "/~0", "~",
                                           "=",          "1",     "{",  "\"a\"", "/",   "[1]",
                                           "\xff",       "/film", "/x", "/3",    "=5",  "/title"};
    for (unsigned i = 0; i < 1 + seed.child("parts").bits() % 6; ++i) {
      assignment += kParts[seed.child("part", i).bits() % std::size(kParts)];
    }
    Errors errors = apply_set(document, assignment);
    for (const Error& error : errors) EXPECT_TRUE(error.where.starts_with("--set")) << error.text();
    Result<reef::Preset> preset = read_preset<reef::Preset>(document);
    EXPECT_TRUE(preset || !preset.errors().empty());
  }
}

}  // namespace
}  // namespace frond
