#pragma once
// Options of a command that come from elsewhere than a command line, read as if they stood on one.

#include <memory>
#include <string>
#include <vector>

#include "options/command_options.h"

namespace tramline::app {

/// An option as its declaration describes it.
struct OptionText {
  std::string name;   ///< "--width"
  std::string takes;  ///< the word that stands for its value; empty for a flag
  std::string help;
};

class OptionParser {
 public:
  explicit OptionParser(const std::string& command);
  OptionParser(const OptionParser&) = delete;
  OptionParser& operator=(const OptionParser&) = delete;
  ~OptionParser();

  /// To declare the options with.
  CommandOptions& command() { return command_; }
  /// `words` as on the command line, "--width=6". Once only. Throws kBadInput for what is not understood.
  void parse(const std::vector<std::string>& words);
  /// Those declared by their long names, in the order of declaration.
  std::vector<OptionText> options() const;

 private:
  std::unique_ptr<CLI::App> program_;
  CommandOptions command_;
};

}  // namespace tramline::app
