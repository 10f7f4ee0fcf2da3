#include "options/option_parser.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "tramline/geometry/error.h"

namespace tramline::app {

OptionParser::OptionParser(const std::string& command)
    : program_(std::make_unique<CLI::App>()), command_(*program_, command, "") {}

OptionParser::~OptionParser() = default;

void OptionParser::parse(const std::vector<std::string>& words) {
  // CLI11 takes the last word first.
  std::vector<std::string> reversed(words.rbegin(), words.rend());
  reversed.push_back(command_.parser()->get_name());
  try {
    program_->parse(reversed);
  } catch (const CLI::ExtrasError&) {
    const std::vector<std::string> unknown = program_->remaining(true);
    throw bad_input(fmt::format("'{}' was not expected", unknown.empty() ? "" : unknown.front()));
  } catch (const CLI::ParseError& error) {
    throw bad_input(error.what());
  }
}

std::vector<OptionText> OptionParser::options() const {
  std::vector<OptionText> out;
  for (const CLI::Option* option : command_.parser()->get_options({})) {
    if (option->get_lnames().empty() || option->get_lnames().front() == "help") continue;
    const bool flag = option->get_items_expected_max() == 0;
    out.push_back({"--" + option->get_lnames().front(), flag ? "" : option->get_type_name(),
                   option->get_description()});
  }
  return out;
}

}  // namespace tramline::app
