#include "output_names.h"

#include <cctype>

namespace tramline::app {
std::string as_file_name(const std::string& id) {
  constexpr std::size_t kLongest = 80;  // file systems take 255 bytes, folders and suffixes included
  std::string out;
  for (const char c : id)
    out += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-' ? c : '-';
  return out.substr(0, kLongest);
}

std::string UniqueNames::next(const std::string& wanted) {
  std::string name = wanted;
  for (int copy = 2; !taken_.insert(name).second; ++copy) name = wanted + "-" + std::to_string(copy);
  return name;
}

std::filesystem::path OutputNames::next(const std::string& field_id) {
  if (!several_) return given_;
  const std::string name = names_.next(given_.stem().string() + "-" + as_file_name(field_id));
  return given_.parent_path() / (name + given_.extension().string());
}

}  // namespace tramline::app
