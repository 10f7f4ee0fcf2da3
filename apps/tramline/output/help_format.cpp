#include "output/help_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace tramline::app {
namespace {

constexpr std::size_t kColumns = 100;
constexpr std::size_t kDescriptionColumn = 30;

/// How many characters a terminal shows of UTF-8 text.
std::size_t shown_length(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The words of a text in lines that begin at a column, the first one without its indentation.
std::string wrapped(const std::string& text, std::size_t column) {
  std::string out;
  std::size_t used = column;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool first = out.empty();
    if (!first && used + 1 + shown_length(word) > kColumns) {
      out += "\n" + std::string(column, ' ');
      used = column;
    } else if (!first) {
      out += " ";
      ++used;
    }
    out += word;
    used += shown_length(word);
  }
  return out;
}

/// "  NAME   description", the description on a line of its own where the name is long.
std::string entry(const std::string& name, const std::string& description) {
  std::string out = "  " + name;
  if (shown_length(out) + 2 > kDescriptionColumn)
    out += "\n" + std::string(kDescriptionColumn, ' ');
  else
    out += std::string(kDescriptionColumn - shown_length(out), ' ');
  return out + wrapped(description, kDescriptionColumn) + "\n";
}

std::string listed(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::sort(names.begin(), names.end());
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string HelpFormatter::make_usage(const CLI::App* app, std::string) const {
  std::string out = "Usage: tramline";
  if (app->get_parent() == nullptr) return out + " COMMAND [OPTIONS] ...\n";
  out += " " + app->get_name() + " [OPTIONS]";
  for (const CLI::Option* option : app->get_options([](const CLI::Option* o) { return o->get_positional(); }))
    out +=
        (option->get_required() ? " " : " [") + option->get_name(true) + (option->get_required() ? "" : "]");
  return out + "\n";
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  return wrapped(app->get_description(), 0) + "\n";
}

std::string HelpFormatter::make_footer(const CLI::App* app) const { return "\n" + app->get_footer() + "\n"; }

std::string HelpFormatter::make_group(std::string group, bool is_positional,
                                      std::vector<const CLI::Option*> options) const {
  std::string out = "\n" + (is_positional ? "Arguments" : group) + ":\n";
  for (const CLI::Option* option : options) out += make_option(option, is_positional);
  return out;
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string out = make_description(app) + "\n" + make_usage(app, name) + make_positionals(app);
  for (const std::string& group : app->get_groups()) {
    const auto options = app->get_options([&](const CLI::Option* option) {
      return option->get_group() == group && option->nonpositional() && option != app->get_help_ptr();
    });
    if (!options.empty()) out += make_group(group, false, options);
  }
  return out + make_subcommands(app, mode) + make_footer(app);
}

std::string HelpFormatter::make_subcommands(const CLI::App* app, CLI::AppFormatMode) const {
  if (app->get_parent() != nullptr) return "";
  std::string out = "\nCommands:\n";
  for (const CLI::App* command :
       app->get_subcommands([](const CLI::App* one) { return !one->get_name().empty(); })) {
    std::string about = command->get_description();
    about = about.substr(0, about.find(". "));
    if (about.ends_with('.')) about.pop_back();
    out += entry(command->get_name(), about);
  }
  return out;
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  std::string name = is_positional ? option->get_name(true) : option->get_name(false, true);
  for (std::size_t comma = name.find(','); comma != std::string::npos; comma = name.find(',', comma + 2))
    name.insert(comma + 1, " ");
  const bool takes_value = option->get_items_expected_max() > 0;
  if (!is_positional && takes_value)
    name += " " + option->get_type_name().substr(0, option->get_type_name().find(':'));
  std::string description = option->get_description();
  if (!option->get_needs().empty()) description += " Only with " + listed(option->get_needs()) + ".";
  if (!option->get_excludes().empty()) description += " Not with " + listed(option->get_excludes()) + ".";
  if (!is_positional && option->get_required()) description += " Required.";
  if (takes_value && !option->get_default_str().empty())
    description += " Default: " + option->get_default_str() + ".";
  return entry(name, description);
}

}  // namespace tramline::app
