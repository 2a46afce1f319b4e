#include "studio/carry.h"

#include "core/files.h"
#include "scene/named_files.h"
#include "studio/grammar_files.h"
#include "studio/mesh_files.h"
#include "studio/put_files.h"

namespace frond {

namespace fs = std::filesystem;

Result<std::string> carried(const std::string& text, const fs::path& from, const fs::path& to,
                            const std::function<bool(const fs::path&)>& readable) {
  return renamed(text, from, [&](const fs::path& file) -> Result<std::string> {
    if (!readable(file)) return std::string();
    auto put = [&]() -> Result<PutFiles> {
      if (file.extension() == ".l") return put_grammar(to, file);
      if (is_mesh_name(file)) return copy_mesh(to, file);
      Result<std::string> content = read_file(file);
      if (!content) return content.errors();
      return put_beside(to, file.filename().string(), *content);
    }();
    if (!put) return put.errors();
    return put->name;
  });
}

}  // namespace frond
