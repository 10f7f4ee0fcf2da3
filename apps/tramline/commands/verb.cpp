#include "commands/verb.h"

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

Option& Option::group(const char* heading) {
  option_->group(heading);
  return *this;
}

Option& Option::shows_default() {
  option_->capture_default_str();
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
  return *this;
}

Option& Option::in_range(double least, double most) {
  option_->check(CLI::Range(least, most));
  option_->check(fault_of_nan);
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

Verb::Verb(CLI::App& program, const std::string& name, const std::string& about)
    : verb_(program.add_subcommand(name, about)) {}

Option Verb::add_option(const std::string& name, std::string& value, const std::string& help) {
  return Option(verb_->add_option(name, value, help));
}

Option Verb::add_option(const std::string& name, int& value, const std::string& help) {
  return Option(verb_->add_option(name, value, help));
}

Option Verb::add_option(const std::string& name, std::size_t& value, const std::string& help) {
  return Option(verb_->add_option(name, value, help));
}

Option Verb::add_option(const std::string& name, double& value, const std::string& help) {
  return Option(verb_->add_option(name, value, help));
}

Option Verb::add_option(const std::string& name, std::vector<std::string>& values, const std::string& help) {
  return Option(verb_->add_option(name, values, help));
}

Option Verb::add_option(const std::string& name, std::optional<std::size_t>& value, const std::string& help) {
  return Option(verb_->add_option(name, value, help));
}

Option Verb::add_option(const std::string& name, std::optional<double>& value, const std::string& help) {
  return Option(verb_->add_option(name, value, help));
}

Option Verb::add_flag(const std::string& name, bool& given, const std::string& help) {
  return Option(verb_->add_flag(name, given, help));
}

Option Verb::option(const std::string& name) const { return Option(verb_->get_option(name)); }

void Verb::remove_option(const std::string& name) { verb_->remove_option(verb_->get_option(name)); }

bool Verb::is_given(const std::string& name) const { return verb_->get_option(name)->count() > 0; }

void Verb::footer(const std::string& text) { verb_->footer(text); }

void Verb::takes_anything() { verb_->allow_extras(); }

}  // namespace tramline::app
