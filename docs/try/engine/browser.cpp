#include "core/cancellation.h"
#include "core/parallel.h"
#include "geometry/obj.h"
#include "images/describe_mask.h"
#include "images/read_picture.h"

// What the engine uses of other modules, as it is in a browser: one thread and no files.

namespace frond {

extern const char* const kCodeId;
const char* const kCodeId = "browser";  // of names of pictures, which are not drawn here

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  for (std::size_t i = 0; i < count; ++i) body(i);
}

int thread_count() { return 1; }

void stay_wanted() {}  // the page ends its worker

Result<LineSet> read_obj_lines(std::string_view, const std::string& name) {
  return Error{name, "no files are read here"};
}

Errors load_mask(const NamedFile&, Mask&) { return {{"", "no files are read here"}}; }

Result<Raster> read_picture(std::string_view) { return Error{"", "no files are read here"}; }

}  // namespace frond
