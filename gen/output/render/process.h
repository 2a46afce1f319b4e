#pragma once

#include <signal.h>
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "render/confine.h"
#include "render/descriptor.h"

/// Other programs, started with their arguments as they are: no shell reads them.
namespace frond {

/// A program that is to run.
struct Command {
  std::vector<std::string> words;        ///< the program, found as a shell finds it, and its arguments
  std::vector<std::string> environment;  ///< NAME=VALUE, beside ours or in place of it
  std::filesystem::path folder;          ///< where it runs; empty: where we do
  int in = -1;                           ///< descriptors of its streams; -1: of nothing, for in,
  int out = -1, err = -1;                ///< and ours
  int end_with = SIGKILL;                ///< the signal that it gets when we end, however we do
  bool apart = false;  ///< no signal of ours reaches it, nor can it gain rights that we do not have
  std::optional<Confinement> confinement;

  /// Appends further arguments.
  void add(const std::vector<std::string>& more) { words.insert(words.end(), more.begin(), more.end()); }
};

/// Starts it; the number of its process. Of a process with one thread only where it is confined.
Result<pid_t> start(const Command& command);

/// Writes all of it to an open file; false where that fails.
bool write_all(int file, std::string_view bytes);

/// Waits for its end: its exit code, or 128 and the signal that ended it.
int wait_for(pid_t process);

/// Starts it and waits for its end.
Result<int> run(const Command& command);

/// Where a program lies that is named as in a shell; nothing where there is none.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// The value of a variable of the environment; the other where it is not set, or empty.
std::string environment_or(const char* name, const std::string& other);

/// This program itself.
std::filesystem::path own_program();

/// Says that what runs is to stop.
class Stop {
 public:
  virtual ~Stop() = default;
  /// Whether we are to stop; asked at least once a second.
  virtual bool asked() = 0;
  /// Can be read from as soon as we are, for poll(); -1: there is none.
  virtual int descriptor() const { return -1; }
};

/// As long as it lives, SIGTERM, SIGINT and SIGHUP do not end this process, but show here. One at a time, and
/// before there are threads.
class StopSignals final : public Stop {
 public:
  StopSignals();
  ~StopSignals() override;

  /// Waits for the end of a process, as wait_for; nothing where we are to stop, which it is then left to.
  std::optional<int> wait_for(pid_t process);

  /// One of the processes that this one has started, once it has ended.
  struct Ended {
    pid_t process = 0;
    int code = 0;
  };
  /// Waits for the end of any of them, of which there must be one; nothing as above.
  std::optional<Ended> wait_for_any();

  bool asked() override;
  int descriptor() const override { return *file_; }

 private:
  std::optional<Ended> wait(pid_t process);

  sigset_t held_, before_;
  Descriptor file_;
  bool asked_ = false;
};

/// A file without a name, for what programs say: each write goes to its end.
class OutputCapture {
 public:
  OutputCapture();

  int descriptor() const { return *file_; }
  std::string text() const;

 private:
  Descriptor file_;
};

/// Whether a program's words are those of a full disk; each has its own, "no room on the disk" is what we
/// say.
bool tells_full_disk(std::string_view words);

/// The lines of a text, without their ends.
std::vector<std::string> lines_of(std::string_view text);

}  // namespace frond
