#include "render/frame.h"

#include <signal.h>
#include <sys/prctl.h>

#include <charconv>

#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "render/place.h"
#include "render/process.h"

// One frame by POV-Ray: frame.

namespace frond {

void frame(const FrameArguments& arguments) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // it ends with the one that called it, however that ends
  FrameJob job;
  job.scene = arguments.scene;
  job.picture = arguments.picture;
  job.size = size_of(arguments.size);
  if (job.size[0] == 0)
    fail_run({{"", arguments.size + " is no size; expected WIDTHxHEIGHT, as in 640x360"}}, kWrongInput);
  job.flags = arguments.flags;
  job.home = or_fail_run(home(), kCouldNot);
  job.povray = environment_or("FROND_POVRAY", "povray");
  job.confined = environment_or("FROND_UNCONFINED", "").empty();
  std::string threads = environment_or("FROND_THREADS", "1");
  std::from_chars(threads.data(), threads.data() + threads.size(), job.threads);
  if (!or_fail_run(render_frame(job), kCouldNot)) throw CommandEnd{kStopped};
}

}  // namespace frond
