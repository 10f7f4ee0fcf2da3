#pragma once
// The options of a command of the program, as the command declares them. CLI11 stands behind this interface,
// in command_options.cpp, help_format.cpp and main.cpp alone: its headers take longer to compile than a whole
// command.

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace tramline::app {

/// An option that a command has declared: a handle that may be copied and lives as long as the command.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required();
  /// May be given only together with `other`.
  Option& needs(const Option& other);
  /// May not be given together with `other`.
  Option& excludes(const Option& other);
  /// The word that stands for its value in --help: "FILE", "METRES".
  Option& takes(const char* word);
  /// --help shows the present value as the default.
  Option& shows_default();
  /// --help shows this text as the default.
  Option& shows_default(const std::string& text);
  /// Takes one value each time it is given, of those that are given again and again.
  Option& one_value_each_time();
  /// May be given without a value.
  Option& value_may_be_left_out();
  /// --help says the range.
  Option& in_range(int least, int most);
  Option& in_range(double least, double most);
  Option& positive();
  Option& one_of(std::initializer_list<const char*> words);
  /// `fault` returns a message about the text of a value, empty where the text is sound.
  Option& check(std::string (*fault)(const std::string& text));

 private:
  friend class CommandOptions;
  CLI::Option* option_;
};

/// A command and its options: a handle that may be copied. The variables that options are bound to have to
/// outlive the parse.
class CommandOptions {
 public:
  /// Declares the command `name` of `program`, which --help describes as `about`.
  CommandOptions(CLI::App& program, const std::string& name, const std::string& about);

  /// Declares an option "-o,--output", or an argument "FILE", whose value goes to `value`.
  Option add_option(const std::string& name, std::string& value, const std::string& help);
  Option add_option(const std::string& name, int& value, const std::string& help);
  Option add_option(const std::string& name, std::size_t& value, const std::string& help);
  Option add_option(const std::string& name, double& value, const std::string& help);
  Option add_option(const std::string& name, std::vector<std::string>& values, const std::string& help);
  Option add_option(const std::string& name, std::optional<std::size_t>& value, const std::string& help);
  Option add_option(const std::string& name, std::optional<double>& value, const std::string& help);
  /// Declares an option that takes no value: `given` says afterwards whether it was there.
  Option add_flag(const std::string& name, bool& given, const std::string& help);
  /// An option declared before, by its name.
  Option option(const std::string& name) const;
  void remove_option(const std::string& name);
  /// Was the option given on the command line?
  bool is_given(const std::string& name) const;
  /// --help lists the options declared from now on under this heading.
  void begin_group(const char* heading);
  /// The text at the end of --help.
  void footer(const std::string& text);
  /// Accepts any further arguments and ignores them.
  void takes_anything();

  CLI::App* parser() const { return parser_; }

 private:
  Option grouped(CLI::Option* option) const;

  CLI::App* parser_;
  std::string group_ = "Other options";
};

}  // namespace tramline::app
