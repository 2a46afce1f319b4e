#include <pwd.h>
#include <unistd.h>

#include <algorithm>

#include "app/commands.h"
#include "app/inputs.h"
#include "app/messages.h"
#include "app/streams.h"
#include "core/files.h"
#include "jobs/farm.h"

namespace frond {

int farm(const FarmArguments& arguments) {
  FarmSite site;
  if (arguments.site) {
    Result<std::string> text = read_file(*arguments.site);
    Result<FarmSite> read = text ? read_farm_site(*text, *arguments.site) : text.errors();
    if (!read) return fail(read.errors(), kWrongInput);
    site = std::move(*read);
  }
  if (!is_task_list(arguments.tasks))
    return fail({{"--tasks", "\"" + arguments.tasks + "\" is no list of tasks; expected one as in 1,3,7-9"}},
                kWrongInput);
  FarmJob job{.folder = arguments.folder,
              .name = arguments.name,
              .tasks = arguments.tasks,
              .work = arguments.work,
              .uid = ::getuid()};
  if (const passwd* user = ::getpwuid(job.uid)) job.user = user->pw_name;
  std::string text = std::ranges::find(farm_formats(), arguments.format, &FarmFormat::name)->text(job, site);
  if (arguments.out) {
    Result<bool> written = write_file(*arguments.out, text);
    if (!written) return fail(written.errors(), kCouldNot);
    text = *arguments.out + "\n";
  }
  put(text);
  return kDone;
}

}  // namespace frond
