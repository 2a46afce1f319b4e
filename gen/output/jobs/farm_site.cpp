#include "jobs/farm_site.h"

#include <algorithm>

#include "preset/describe.h"
#include "preset/reader.h"

namespace frond {

void describe(Properties& v, FarmSite& s) {
  v.text("partition", s.partition, "Of Slurm");
  v.text("account", s.account, "That pays for it");
  v.text("qos", s.qos, "Quality of service, of Slurm");
  v.integer("cpus", s.cpus, {.min = 1, .max = 1024}, "Processors of a task");
  v.integer("memory", s.memory, {.min = 0, .max = 1e8, .unit = "MB"}, "Of a task");
  v.integer("minutes", s.minutes, {.min = 0, .max = 1e6}, "That a task may take");
  v.list("modules", s.modules, "Loaded before a task");
  v.list("options", s.options, "Further options of sbatch");
  v.text("facility", s.facility, "Of OpenCue");
  v.text("show", s.show, "Of OpenCue");
  v.text("shot", s.shot, "Of OpenCue");
}

namespace {

/// Whether a text can be one line of a file, and nothing that begins as an option does.
bool is_name(std::string_view text) {
  return !text.starts_with('-') && std::ranges::all_of(text, [](char c) {
    return static_cast<unsigned char>(c) >= ' ' && c != '\x7f';
  });
}

}  // namespace

Result<FarmSite> read_farm_site(std::string_view text, const std::string& file_name) {
  Result<Document> document = parse_json(text, file_name);
  if (!document) return document.errors();
  Result<FarmSite> site = read_preset<FarmSite>(*document);
  if (!site) return site;
  Errors errors;
  auto refuse = [&](const std::string& pointer, std::string what) {
    errors.push_back(Fault{origin_at(document->root, pointer), pointer, std::move(what)}.error());
  };
  for (std::size_t i = 0; i < site->modules.size(); ++i)
    if (site->modules[i].empty() || !is_name(site->modules[i]))
      refuse("/modules/" + std::to_string(i), "expected the name of a module");
  for (std::size_t i = 0; i < site->options.size(); ++i)
    if (!site->options[i].starts_with("--") || !is_name(site->options[i].substr(2)))
      refuse("/options/" + std::to_string(i), "expected an option of sbatch, as in \"--constraint=avx2\"");
  if (!errors.empty()) return errors;
  return site;
}

}  // namespace frond
