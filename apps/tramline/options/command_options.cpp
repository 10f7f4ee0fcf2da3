#include "options/command_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>

namespace tramline::app {
namespace {

/// CLI11's ranges let NaN through: it is below no limit, and above none.
std::string fault_of_nan(const std::string& text) {
  return std::isnan(std::strtod(text.c_str(), nullptr)) ? "'" + text + "' is not a number" : "";
}

}  // namespace

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::needs(const Option& other) {
  option_->needs(other.option_);
  return *this;
}

Option& Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

Option& Option::takes(const char* word) {
  option_->type_name(word);
  return *this;
}

Option& Option::shows_default() {
  option_->capture_default_str();
  return *this;
}

Option& Option::shows_default(const std::string& text) {
  option_->default_str(text);
  return *this;
}

Option& Option::one_value_each_time() {
  option_->allow_extra_args(false);
  return *this;
}

Option& Option::value_may_be_left_out() {
  option_->expected(0, 1);
  return *this;
}

Option& Option::in_range(int least, int most) {
  option_->check(CLI::Range(least, most));
  option_->description(fmt::format("{} {} to {}.", option_->get_description(), least, most));
  return *this;
}

Option& Option::in_range(double least, double most) {
  option_->check(CLI::Range(least, most));
  option_->check(fault_of_nan);
  option_->description(fmt::format("{} {:g} to {:g}.", option_->get_description(), least, most));
  return *this;
}

Option& Option::positive() {
  option_->check(CLI::PositiveNumber);
  option_->check(fault_of_nan);
  return *this;
}

Option& Option::one_of(std::initializer_list<const char*> words) {
  option_->check(CLI::IsMember(std::vector<std::string>(words.begin(), words.end())));
  return *this;
}

Option& Option::check(std::string (*fault)(const std::string& text)) {
  option_->check(fault);
  return *this;
}

CommandOptions::CommandOptions(CLI::App& program, const std::string& name, const std::string& about)
    : parser_(program.add_subcommand(name, about)) {}

Option CommandOptions::add_option(const std::string& name, std::string& value, const std::string& help) {
  return grouped(parser_->add_option(name, value, help));
}

Option CommandOptions::add_option(const std::string& name, int& value, const std::string& help) {
  return grouped(parser_->add_option(name, value, help));
}

Option CommandOptions::add_option(const std::string& name, std::size_t& value, const std::string& help) {
  return grouped(parser_->add_option(name, value, help));
}

Option CommandOptions::add_option(const std::string& name, double& value, const std::string& help) {
  return grouped(parser_->add_option(name, value, help));
}

Option CommandOptions::add_option(const std::string& name, std::vector<std::string>& values,
                                  const std::string& help) {
  return grouped(parser_->add_option(name, values, help));
}

Option CommandOptions::add_option(const std::string& name, std::optional<std::size_t>& value,
                                  const std::string& help) {
  return grouped(parser_->add_option(name, value, help));
}

Option CommandOptions::add_option(const std::string& name, std::optional<double>& value,
                                  const std::string& help) {
  return grouped(parser_->add_option(name, value, help));
}

Option CommandOptions::add_flag(const std::string& name, bool& given, const std::string& help) {
  return grouped(parser_->add_flag(name, given, help));
}

Option CommandOptions::option(const std::string& name) const { return Option(parser_->get_option(name)); }

void CommandOptions::remove_option(const std::string& name) {
  parser_->remove_option(parser_->get_option(name));
}

bool CommandOptions::is_given(const std::string& name) const {
  return parser_->get_option(name)->count() > 0;
}

Option CommandOptions::grouped(CLI::Option* option) const {
  option->group(group_);
  return Option(option);
}

void CommandOptions::begin_group(const char* heading) { group_ = heading; }

void CommandOptions::footer(const std::string& text) { parser_->footer(text); }

void CommandOptions::takes_anything() { parser_->allow_extras(); }

}  // namespace tramline::app
