#include "scene/named_preset.h"

#include "core/home.h"

namespace frond {

namespace fs = std::filesystem;

Result<NamedFile> read_named_preset(const Assets& assets, const std::string& name,
                                    const std::string& named_in) {
  fs::path folder = fs::path(named_in).parent_path();
  Result<NamedFile> file = assets.read(name, folder);
  std::error_code error;
  if (file || fs::exists(folder / name, error)) return file;
  std::optional<fs::path> shipped = shipped_preset(name);
  return shipped ? assets.read(shipped->string(), folder) : file;
}

}  // namespace frond
