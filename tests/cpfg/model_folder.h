#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

#include "cpfg/cpfg.h"

namespace frond {

/// A folder with the files of a model, which is removed again.
class ModelFiles {
 public:
  ModelFiles(std::initializer_list<std::pair<const char*, std::string>> files) {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = std::filesystem::temp_directory_path() / ("frond_cpfg_" + name + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    for (const auto& [file, text] : files) write(file, text);
  }
  ~ModelFiles() { std::filesystem::remove_all(folder_); }

  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_ / file) << text;
  }
  std::filesystem::path path(const std::string& file = "m.l") const { return folder_ / file; }

 private:
  std::filesystem::path folder_;
};

/// A grammar around its settings, axiom and productions.
inline std::string grammar_of(const std::string& lines) { return "Lsystem: 1\n" + lines + "\nendlsystem\n"; }

/// The word of a model, or what is wrong with it.
inline std::string word_of(const Result<CpfgModel>& model, CpfgRequest request = {}) {
  if (!model) return model.errors()[0].what;
  Result<CpfgDerived> derived = derive(*model, request);
  return derived ? text(derived->word, *model) : derived.errors()[0].what;
}

inline std::string word_of(const ModelFiles& files, CpfgRequest request = {}) {
  return word_of(read_cpfg(files.path()), request);
}

/// The same of a grammar without other files.
inline std::string word_of(const std::string& lines, CpfgRequest request = {}) {
  Result<CpfgModel> model = read_cpfg("m.l", grammar_of(lines));
  return word_of(model, request);
}

/// The word that the turtle reads.
inline std::string drawing_of(const ModelFiles& files) {
  CpfgRequest request;
  request.drawing = true;
  Result<CpfgModel> model = read_cpfg(files.path());
  if (!model) return model.errors()[0].what;
  Result<CpfgDerived> derived = derive(*model, request);
  return derived ? text(derived->drawing.word, *model) : derived.errors()[0].what;
}

}  // namespace frond
