#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "render/process.h"

namespace frond {

/// What is told while ninja runs.
struct NinjaEvents {
  std::function<void(std::string_view what)> done;    ///< a command ended well: its description
  std::function<void(const std::string& line)> said;  ///< a line that a failing command prints
  std::function<void()> idle;                         ///< a second without any
};

/// ninja in the folder of a film. It ends when this process does, however that ends.
class Ninja {
 public:
  /// `environment` is what its commands are given; signals to this process show in `stop`.
  Ninja(std::filesystem::path folder, std::vector<std::string> environment, Stop& stop);

  /// What came of a run.
  struct End {
    bool well = false;                ///< all was made
    bool stopped = false;             ///< by a signal to this process
    std::vector<std::string> failed;  ///< files that could not be made
  };

  /// Makes files, so many at once. What fails stops nothing else.
  Result<End> make(const std::vector<std::string>& files, int jobs, const NinjaEvents& events);

  void set_environment(std::vector<std::string> environment) { environment_ = std::move(environment); }

  /// Ends ninja and what it runs, from within an event.
  void end();

  /// What ninja prints that is called with these words, and with nothing to say of its own progress.
  std::string answer(std::vector<std::string> words) const;

 private:
  /// Reads a line that ninja has printed.
  void read_line(const std::string& line, End& end, const NinjaEvents& events);
  void tell_pending(const NinjaEvents& events);
  void follow(int pipe, End& end, const NinjaEvents& events);

  std::filesystem::path folder_;
  std::vector<std::string> environment_;
  Stop& stop_;
  pid_t process_ = 0;
  std::string pending_;  // the description of a command that may yet turn out to have failed
  bool has_pending_ = false;
  bool skip_ = false;  // the next line is the command that failed
};

}  // namespace frond
