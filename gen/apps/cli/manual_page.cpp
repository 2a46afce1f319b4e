#include "cli/rendering.h"
#include "core/version.h"

// frond(1) from what the program says of itself.

namespace frond {

namespace {

/// A text as man shows it: no backslash and no dash means anything else there, nor does a line's first sign.
std::string as_roff(const std::string& text) {
  std::string roff;
  for (char c : text) {
    bool begins = roff.empty() || roff.back() == '\n';
    if (begins && (c == '.' || c == '\'')) roff += "\\&";
    if (c == '\\')
      roff += "\\e";
    else if (c == '-')
      roff += "\\-";
    else
      roff += c;
  }
  return roff;
}

std::string text_of(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "-" : ", -") + name;
  for (const std::string& name : option.get_lnames()) names += (names.empty() ? "--" : ", --") + name;
  if (names.empty()) names = option.get_name(true);
  return ".TP\n\\fB" + as_roff(names) + "\\fR\n" + as_roff(option.get_description()) + "\n";
}

std::string text_of(const CLI::App& command) {
  std::string text =
      ".SS frond " + as_roff(command.get_name()) + "\n" + as_roff(command.get_description()) + ".\n";
  for (const CLI::Option* option : command.get_options())
    if (option->get_name() != "--help") text += text_of(*option);
  if (std::string footer = command.get_footer(); !footer.empty())
    text += ".PP\n.nf\n" + as_roff(footer) + "\n.fi\n";
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string page = ".TH FROND 1 \"\" \"Frond " + version() + "\" \"User commands\"\n";
  page += ".SH NAME\nfrond \\- grows plants and corals and films them with POV\\-Ray\n";
  page += ".SH SYNOPSIS\n.B frond\n\\fICOMMAND\\fR [\\fIOPTION\\fR...]\n";
  page += ".SH DESCRIPTION\n" + as_roff(app.get_description()) +
          "\nA preset is a JSON file, or one that comes with Frond by its name: \\fBfrond render oak\\fR.\n";
  page += ".SH COMMANDS\n";
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty()) page += text_of(*command);
  page +=
      ".SH EXIT STATUS\n0: all was made. 1: something could not be. 2: what was given is wrong.\n"
      "4: nothing has grown by then. 130: interrupted.\n";
  page += ".SH ENVIRONMENT\n" + as_roff(app.get_footer()) + "\n";
  return page;
}

}  // namespace frond
