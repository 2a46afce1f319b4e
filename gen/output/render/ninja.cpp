#include "render/ninja.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace frond {

namespace {

/// Marks ninja's own lines, so that they are told from what failing commands print.
constexpr char kMark = '\1';
constexpr int kIdle = 1000;  // milliseconds

}  // namespace

Ninja::Ninja(std::filesystem::path folder, std::vector<std::string> environment, Stop& stop)
    : folder_(std::move(folder)), environment_(std::move(environment)), stop_(stop) {}

Result<Ninja::End> Ninja::make(const std::vector<std::string>& files, int jobs, const NinjaEvents& events) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return Error{"ninja", std::strerror(errno)};
  Descriptor from(ends[0]), to(ends[1]);
  Command command;
  command.words = {"ninja", "-k", "0", "-j", std::to_string(jobs)};
  command.add(files);
  command.environment = environment_;
  command.environment.push_back(fmt::format("NINJA_STATUS={}", kMark));
  command.folder = folder_;
  command.out = command.err = *to;
  command.end_with = SIGTERM;
  Result<pid_t> process = start(command);
  to.close();
  if (!process) return process.errors();
  process_ = *process;
  End result;
  has_pending_ = skip_ = false;
  follow(*from, result, events);
  from.close();
  if (result.stopped) end();
  result.well = wait_for(process_) == 0;
  process_ = 0;
  return result;
}

void Ninja::end() {
  if (process_ > 0) ::kill(process_, SIGTERM);
}

void Ninja::follow(int pipe, End& end, const NinjaEvents& events) {
  std::string begun;  // a line that is not whole yet
  std::array<char, 4096> buffer;
  std::array<pollfd, 2> wait{pollfd{pipe, POLLIN, 0}, pollfd{stop_.descriptor(), POLLIN, 0}};
  for (;;) {
    int ready = ::poll(wait.data(), wait.size(), kIdle);
    if (stop_.asked()) {
      end.stopped = true;
      return;
    }
    if (ready == 0) {
      tell_pending(events);  // that it failed would have followed at once
      events.idle();
    }
    if (ready <= 0 || wait[0].revents == 0) continue;
    ssize_t got = ::read(pipe, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    begun.append(buffer.data(), static_cast<std::size_t>(got));
    for (std::size_t at; (at = begun.find('\n')) != begun.npos;) {
      read_line(begun.substr(0, at), end, events);
      begun.erase(0, at + 1);
    }
  }
  if (!begun.empty()) read_line(begun, end, events);
  tell_pending(events);
}

void Ninja::tell_pending(const NinjaEvents& events) {
  if (!has_pending_) return;
  has_pending_ = false;
  events.done(pending_);
}

void Ninja::read_line(const std::string& line, End& end, const NinjaEvents& events) {
  constexpr std::string_view kFailed = "FAILED: ";
  if (skip_) {
    skip_ = false;
  } else if (line.starts_with(kMark)) {  // a command is counted when the next line shows that it did not fail
    tell_pending(events);
    pending_ = line.substr(1);
    has_pending_ = true;
  } else if (line.starts_with(kFailed)) {
    has_pending_ = false;
    std::string files = line.substr(kFailed.size());
    files.erase(files.find_last_not_of(' ') + 1);
    end.failed.push_back(files);
    skip_ = true;
  } else if (line != "ninja: no work to do." && !line.starts_with("ninja: build stopped") &&
             !line.starts_with("ninja: Entering directory")) {
    events.said(line);
  }
}

std::string Ninja::answer(std::vector<std::string> words) const {
  OutputCapture said;
  Command command;
  words.insert(words.begin(), "ninja");
  command.words = std::move(words);
  command.environment = environment_;
  command.environment.emplace_back("NINJA_STATUS=");
  command.folder = folder_;
  command.out = command.err = said.descriptor();
  Result<int> status = run(command);
  return status ? said.text() : status.errors()[0].text();
}

}  // namespace frond
