#pragma once
// A verb of the program and its options, as the verbs declare them. CLI11 stands behind it, in verb.cpp and
// main.cpp alone: its headers take longer to compile than a whole verb.

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

/// An option that a verb has declared: a handle that may be copied and lives as long as the verb.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required();
  /// May be given only together with `other`.
  Option& needs(const Option& other);
  /// May not be given together with `other`.
  Option& excludes(const Option& other);
  /// The heading that --help lists it under.
  Option& group(const char* heading);
  /// The value it has so far is shown by --help as its default.
  Option& shows_default();
  /// Takes one value each time it is given, of those that are given again and again.
  Option& one_value_each_time();
  /// May be given without a value.
  Option& value_may_be_left_out();
  Option& in_range(int least, int most);
  Option& in_range(double least, double most);
  Option& positive();
  Option& one_of(std::initializer_list<const char*> words);
  /// `fault` gives what is wrong with the text of a value, or nothing.
  Option& check(std::string (*fault)(const std::string& text));

 private:
  friend class Verb;
  CLI::Option* option_;
};

/// A verb on the command line: a handle that may be copied. What options are bound to has to outlive the
/// parse.
class Verb {
 public:
  /// Declares the verb `name` of `program`; --help says `about` of it.
  Verb(CLI::App& program, const std::string& name, const std::string& about);

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
  /// What --help says last.
  void footer(const std::string& text);
  /// Takes whatever follows without a word.
  void takes_anything();

  CLI::App* parser() const { return verb_; }

 private:
  CLI::App* verb_;
};

}  // namespace tramline::app
