#include "render/confine.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

#include "render/descriptor.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

using Rights = std::uint64_t;

constexpr Rights kTruncate = 1ULL << 14;  // of later headers than ours
constexpr Rights kRefer = 1ULL << 13;
constexpr Rights kOfFirstVersion = 0x1fff;
constexpr Rights kRun = LANDLOCK_ACCESS_FS_EXECUTE;
constexpr Rights kRead = LANDLOCK_ACCESS_FS_READ_FILE;
constexpr Rights kList = LANDLOCK_ACCESS_FS_READ_DIR;
constexpr Rights kWrite = LANDLOCK_ACCESS_FS_WRITE_FILE;
constexpr Rights kChange = kWrite | kTruncate | LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_REMOVE_FILE;
constexpr Rights kOfFiles = kRun | kWrite | kRead | kTruncate;  // a rule of a folder may hold all

long version() { return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION); }

/// A set of rules on its way to the kernel.
class Rules {
 public:
  explicit Rules(long of_version) {
    handled_ = kOfFirstVersion | (of_version >= 2 ? kRefer : 0) | (of_version >= 3 ? kTruncate : 0);
    landlock_ruleset_attr attributes{};
    attributes.handled_access_fs = handled_;
    file_ = Descriptor(static_cast<int>(
        ::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes.handled_access_fs, 0)));
    if (!file_) fail("Landlock");
  }

  /// Allows it below a path. What is not there needs no rule, unless somebody has named it.
  void allow(const fs::path& path, Rights rights, bool must_be_there = false) {
    Descriptor place(::open(path.c_str(), O_PATH | O_CLOEXEC));
    if (!place) {
      if (must_be_there) fail(path.string());
      return;
    }
    struct stat about {};
    if (::fstat(*place, &about) == 0 && !S_ISDIR(about.st_mode)) rights &= kOfFiles;
    landlock_path_beneath_attr rule{};
    rule.allowed_access = rights & handled_;
    rule.parent_fd = *place;
    if (::syscall(SYS_landlock_add_rule, *file_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0)
      fail(path.string() + ": Landlock");
  }

  Errors enforce() {
    if (errors_.empty() && (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
                            ::syscall(SYS_landlock_restrict_self, *file_, 0) != 0))
      fail("Landlock");
    return errors_;
  }

 private:
  void fail(const std::string& where) { errors_.push_back({where, std::strerror(errno)}); }

  Descriptor file_;
  Rights handled_ = 0;
  Errors errors_;
};

}  // namespace

bool can_confine() { return version() >= 1; }

Error no_landlock() {
  return {"",
          "this kernel has no Landlock (Linux 5.13), which keeps programs to their folders; "
          "FROND_UNCONFINED=1 lets frames be rendered without"};
}

Errors confine(const Confinement& to, const fs::path& program) {
  if (!can_confine()) return {no_landlock()};
  Rules rules(version());
  for (const char* folder : {"/usr", "/bin", "/lib", "/lib32", "/lib64"})
    rules.allow(folder, kRun | kRead | kList);
  for (const char* file : {"/etc/ld.so.cache", "/etc/localtime"}) rules.allow(file, kRead);
  rules.allow("/dev/null", kRead | kWrite);
  for (const fs::path& path : to.read) rules.allow(path, kRead | kList, true);
  for (const fs::path& folder : to.write) rules.allow(folder, kRead | kList | kChange, true);
  rules.allow(program, kRun | kRead);
  return rules.enforce();
}

}  // namespace frond
