#pragma once

#include <gtest/gtest.h>

#include <regex>
#include <span>
#include <string>
#include <vector>

#include "scene/preset.h"

namespace frond {

/// A whole preset that is wrong, with all that is said of it.
struct WrongPreset {
  const char* name;
  std::string text;
  std::vector<std::string> sets;
  std::vector<std::string> messages;  ///< those about the file without "reef.json:"
};

inline void expect_messages(std::span<const WrongPreset> presets) {
  for (const WrongPreset& wrong : presets) {
    Result<Preset> preset = read_preset(wrong.text, "reef.json", wrong.sets);
    ASSERT_FALSE(preset.ok()) << wrong.name;
    std::vector<std::string> messages;
    for (const Error& error : preset.errors()) {
      std::string message = error.text();
      EXPECT_EQ(message.find('\n'), message.npos) << message;
      if (message.starts_with("reef.json:")) message.erase(0, message.find(':') + 1);
      // Long lists of names change with each new property.
      messages.push_back(std::regex_replace(
          message, std::regex("one of ([a-z_$]+, ){8,}[a-z_]+( and [0-9]+ more)?"), "one of many names"));
    }
    EXPECT_EQ(messages, wrong.messages) << wrong.name << "\n" << wrong.text;
  }
}

}  // namespace frond
