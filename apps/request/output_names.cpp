#include "request/output_names.h"

#include <algorithm>
#include <iterator>

namespace tramline::app {
namespace {

constexpr bool is_plain(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

/// Without what stands before the first and behind the last plain character: a name that begins with '.'
/// is hidden, and one that begins with '-' is an option to most programs.
std::string trimmed(const std::string& name) {
  const auto first = std::find_if(name.begin(), name.end(), is_plain);
  const auto last = std::find_if(name.rbegin(), std::make_reverse_iterator(first), is_plain);
  return {first, last.base()};
}

}  // namespace

std::string as_file_name(const std::string& id) {
  constexpr std::size_t kLongest = 80;  // file systems take 255 bytes, folders and suffixes included
  std::string out;
  for (const char c : id) out += is_plain(c) || c == '.' || c == '-' ? c : '-';
  out = trimmed(trimmed(out).substr(0, kLongest));
  return out.empty() ? "field" : out;
}

std::string UniqueNames::next(const std::string& wanted) {
  std::string name = wanted;
  for (int copy = 2; !taken_.insert(name).second; ++copy) name = wanted + "-" + std::to_string(copy);
  return name;
}

std::filesystem::path OutputNames::next(const std::string& field_id) {
  if (naming_ == Naming::kAsGiven) return given_;
  const std::string name = names_.next(given_.stem().string() + "-" + as_file_name(field_id));
  return given_.parent_path() / (name + given_.extension().string());
}

}  // namespace tramline::app
