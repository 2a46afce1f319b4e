#include "jobs/farm.h"

#include <fmt/format.h>

#include "core/printable.h"
#include "jobs/escape.h"

namespace frond {

namespace {

/// The beginning of what OpenCue runs by a shell.
std::string shell_command(const FarmJob& job, const FarmSite& site) {
  return shell_quoted(job.folder + "/tool/scripts/farm_task.sh") + " " + shell_quoted(job.folder) + " " +
         std::to_string(site.cpus);
}

/// One step of OpenJD: its name, what stands before its script, and the last arguments as JSON.
std::string openjd_step(std::string_view name, std::string_view before, std::string_view arguments,
                        const FarmSite& site) {
  std::string needs = fmt::format(R"({{"name": "amount.worker.vcpu", "min": {}}})", site.cpus);
  if (site.memory > 0)
    needs += fmt::format(R"(, {{"name": "amount.worker.memory", "min": {}}})", site.memory);
  std::string timeout = site.minutes > 0 ? fmt::format(R"("timeout": {}, )", site.minutes * 60) : "";
  return fmt::format(
      R"(    {{
      "name": "{}",
{}      "hostRequirements": {{
        "amounts": [{}],
        "attributes": [{{"name": "attr.worker.os.family", "anyOf": ["linux"]}}]
      }},
      "script": {{"actions": {{"onRun": {{
        "command": "{{{{Param.Folder}}}}/tool/scripts/farm_task.sh",
        "args": ["{{{{Param.Folder}}}}", "{}", {}],
        {}"cancelation": {{"mode": "NOTIFY_THEN_TERMINATE", "notifyPeriodInSeconds": 10}}
      }}}}}}
    }})",
      name, before, needs, site.cpus, arguments, timeout);
}

}  // namespace

std::string job_name(std::string_view text) {
  std::string name;
  for (char c : text.substr(0, 64)) name += is_plain(c) ? c : '-';
  return name.empty() ? "frond" : name;
}

std::vector<std::string> sbatch_words(const FarmJob& job, const FarmSite& site) {
  std::vector<std::string> words;
  auto add = [&](std::string_view option, std::string_view value) {
    if (!value.empty() && value != "0") words.push_back(fmt::format("{}={}", option, value));
  };
  add("--job-name", job_name(job.name));
  add("--partition", site.partition);
  add("--account", site.account);
  add("--qos", site.qos);
  add("--cpus-per-task", std::to_string(site.cpus));
  add("--mem", std::to_string(site.memory));
  add("--time", std::to_string(site.minutes));
  words.insert(words.end(), site.options.begin(), site.options.end());
  return words;
}

std::string openjd_text(const FarmJob& job, const FarmSite& site) {
  // Values of parameters are taken as they are; elsewhere two braces begin an expression.
  std::string arguments;
  for (const std::string& word : job.work) arguments += json_quoted(word) + ", ";
  std::string space = fmt::format(
      R"(      "parameterSpace": {{"taskParameterDefinitions": [{{"name": "Task", "type": "INT", "range": "{}"}}]}},
)",
      job.tasks);
  return fmt::format(R"({{
  "specificationVersion": "jobtemplate-2023-09",
  "name": "{}",
  "parameterDefinitions": [
    {{"name": "Folder", "type": "STRING", "default": {}, "description": "Of the job, as every machine sees it"}}
  ],
  "steps": [
)",
                     job_name(job.name), json_quoted(job.folder)) +
         openjd_step("Render", space, arguments + "\"{{Task.Param.Task}}\"", site) + ",\n" +
         openjd_step("Film", "      \"dependencies\": [{\"dependsOn\": \"Render\"}],\n", "\"film\"", site) +
         "\n  ]\n}\n";
}

std::string opencue_text(const FarmJob& job, const FarmSite& site) {
  std::string render = shell_command(job, site), memory, name = job_name(job.name);
  for (const std::string& word : job.work) render += " " + shell_quoted(word);
  if (site.memory > 0) memory = fmt::format("<memory>{}m</memory>", site.memory);
  auto layer = [&](std::string_view called, std::string_view type, const std::string& command,
                   std::string_view range) {
    std::string timeout = site.minutes > 0 ? fmt::format("<timeout>{}</timeout>", site.minutes) : "";
    return fmt::format(
        "      <layer name=\"{}\" type=\"{}\">\n        <cmd>{}</cmd>\n"
        "        <range>{}</range><chunk>1</chunk><cores>{}.0</cores>{}{}\n"
        "        <services><service>shell</service></services>\n      </layer>\n",
        called, type, xml_quoted(command), range, site.cpus, memory, timeout);
  };
  return fmt::format(R"(<?xml version="1.0"?>
<!DOCTYPE spec PUBLIC "SPI Cue Specification Language" "http://localhost:8080/spcue/dtd/cjsl-1.15.dtd">
<spec>
  <facility>{}</facility><show>{}</show><shot>{}</shot><user>{}</user><uid>{}</uid>
  <job name="{}">
    <paused>False</paused><maxretries>2</maxretries><autoeat>False</autoeat>
    <layers>
)",
                     xml_quoted(site.facility), xml_quoted(site.show), xml_quoted(site.shot),
                     xml_quoted(job.user), job.uid, name) +
         layer("render", "Render", render + " #IFRAME#", job.tasks) +
         layer("film", "Util", shell_command(job, site) + " film", "1") +
         fmt::format(R"(    </layers>
  </job>
  <depends>
    <depend type="LAYER_ON_LAYER" anyframe="False">
      <depjob>{0}</depjob><deplayer>film</deplayer><onjob>{0}</onjob><onlayer>render</onlayer>
    </depend>
  </depends>
</spec>
)",
                     name);
}

}  // namespace frond
