#include "render/process.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "core/files.h"
#include "core/text.h"

extern char** environ;

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Texts as C wants lists of them.
std::vector<char*> pointers(const std::vector<std::string>& list) {
  std::vector<char*> all;
  for (const std::string& text : list) all.push_back(const_cast<char*>(text.c_str()));
  all.push_back(nullptr);
  return all;
}

std::vector<std::string> environment_of(const Command& command) {
  std::vector<std::string> all = command.environment;
  for (char** variable = environ; *variable; ++variable) {
    std::string_view text = *variable, name = text.substr(0, text.find('=') + 1);
    if (std::ranges::none_of(command.environment, [&](const auto& own) { return own.starts_with(name); }))
      all.emplace_back(text);
  }
  return all;
}

/// In the new process: becomes the program, or says to `report` why it cannot.
[[noreturn]] void become(const Command& command, char** words, char** environment, pid_t parent, int report) {
  auto give_up = [&](const std::string& where) {
    write_all(report, where + ": " + std::strerror(errno));
    ::_exit(127);
  };
  ::prctl(PR_SET_PDEATHSIG, command.end_with);
  if (::getppid() != parent) ::_exit(127);  // it has ended before that was set
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::signal(SIGPIPE, SIG_DFL);
  if (command.apart) ::setsid(), ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  int in = command.in >= 0 ? command.in : ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(in, 0);
  // Both at once, as one may be the place of the other.
  int out = ::fcntl(command.out >= 0 ? command.out : 1, F_DUPFD_CLOEXEC, 3);
  int err = ::fcntl(command.err >= 0 ? command.err : 2, F_DUPFD_CLOEXEC, 3);
  ::dup2(out, 1);
  ::dup2(err, 2);
  if (!command.folder.empty() && ::chdir(command.folder.c_str()) != 0) give_up(command.folder.string());
  if (command.confinement)
    if (Errors errors = confine(*command.confinement, words[0]); !errors.empty()) {
      write_all(report, errors.front().text());
      ::_exit(127);
    }
  ::execvpe(words[0], words, environment);
  give_up(words[0]);
  ::_exit(127);
}

int code_of(int status) { return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status); }

}  // namespace

Result<pid_t> start(const Command& command) {
  std::vector<std::string> all = environment_of(command);
  std::vector<char*> words = pointers(command.words), environment = pointers(all);
  int report[2];
  if (::pipe2(report, O_CLOEXEC) != 0) return Error{command.words[0], std::strerror(errno)};
  pid_t parent = ::getpid(), child = ::fork();
  if (child == 0) become(command, words.data(), environment.data(), parent, report[1]);
  int failed = child < 0 ? errno : 0;
  ::close(report[1]);
  std::string said;
  std::array<char, 512> buffer;
  for (ssize_t got; (got = ::read(report[0], buffer.data(), buffer.size())) != 0;) {
    if (got < 0 && errno != EINTR) break;
    if (got > 0) said.append(buffer.data(), static_cast<std::size_t>(got));
  }
  ::close(report[0]);
  if (child < 0) return Error{command.words[0], std::strerror(failed)};
  if (said.empty()) return child;
  frond::wait_for(child);
  return Error{"", said};
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return 127;
  return code_of(status);
}

Result<int> run(const Command& command) {
  Result<pid_t> process = start(command);
  if (!process) return process.errors();
  return wait_for(*process);
}

std::optional<fs::path> find_program(const std::string& name) {
  auto runs = [](const fs::path& path) { return is_file(path) && ::access(path.c_str(), X_OK) == 0; };
  if (name.find('/') != name.npos) return runs(name) ? std::optional(fs::path(name)) : std::nullopt;
  std::string path = environment_or("PATH", "/usr/bin:/bin");
  for (std::size_t from = 0; from <= path.size();) {
    std::size_t to = std::min(path.find(':', from), path.size());
    fs::path found = fs::path(path.substr(from, to - from)) / name;
    if (runs(found)) return found;
    from = to + 1;
  }
  return std::nullopt;
}

std::string environment_or(const char* name, const std::string& other) {
  const char* value = std::getenv(name);
  return value && *value ? value : other;
}

fs::path own_program() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

StopSignals::StopSignals() {
  sigemptyset(&held_);
  for (int signal : {SIGTERM, SIGINT, SIGHUP, SIGCHLD}) sigaddset(&held_, signal);
  ::sigprocmask(SIG_BLOCK, &held_, &before_);
  sigset_t ours = held_;
  sigdelset(&ours, SIGCHLD);
  file_ = Descriptor(::signalfd(-1, &ours, SFD_CLOEXEC | SFD_NONBLOCK));
}

StopSignals::~StopSignals() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }

std::optional<int> StopSignals::wait_for(pid_t process) {
  std::optional<Ended> ended = wait(process);
  return ended ? std::optional(ended->code) : std::nullopt;
}

std::optional<StopSignals::Ended> StopSignals::wait_for_any() { return wait(-1); }

std::optional<StopSignals::Ended> StopSignals::wait(pid_t process) {
  for (;;) {
    if (asked_) return std::nullopt;
    int status = 0;
    pid_t ended = ::waitpid(process, &status, WNOHANG);
    if (ended != 0) return Ended{ended, ended < 0 ? 127 : code_of(status)};
    int signal = ::sigwaitinfo(&held_, nullptr);
    asked_ = signal > 0 && signal != SIGCHLD;
  }
}

bool StopSignals::asked() {
  sigset_t ours = held_;
  sigdelset(&ours, SIGCHLD);
  timespec at_once{};
  if (!asked_) asked_ = ::sigtimedwait(&ours, nullptr, &at_once) > 0;
  return asked_;
}

OutputCapture::OutputCapture() : file_(::memfd_create("words", MFD_CLOEXEC)) {
  if (file_) ::fcntl(*file_, F_SETFL, O_APPEND);
}

std::string OutputCapture::text() const {
  off_t size = ::lseek(*file_, 0, SEEK_END);
  std::string text(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
  ssize_t got = ::pread(*file_, text.data(), text.size(), 0);
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return text;
}

bool tells_full_disk(std::string_view words) {
  return words.find("No space left on device") != words.npos ||
         words.find("Disk quota exceeded") != words.npos;
}

std::vector<std::string> lines_of(std::string_view text) { return split(text, '\n'); }

}  // namespace frond
