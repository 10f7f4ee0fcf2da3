#include "server/http/file_answer.h"

#include <fmt/format.h>
#include <stdlib.h>  // mkdtemp

#include <cctype>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

bool is_plain(unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.'; }

/// For programs that know no other letters than those of ASCII.
std::string in_ascii(const std::string& name) {
  std::string out;
  for (const char c : name) out += is_plain(static_cast<unsigned char>(c)) ? c : '_';
  return out;
}

/// RFC 8187.
std::string in_percents(const std::string& name) {
  std::string out;
  for (const char c : name)
    out += is_plain(static_cast<unsigned char>(c)) ? std::string(1, c)
                                                   : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return out;
}

}  // namespace

PassingFolder::PassingFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "tramline-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw failure("there is no room for a file to be sent; is the disk full?");
  path_ = name;
}

PassingFolder::~PassingFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void file_answer(httplib::Response& response, const std::filesystem::path& file, const std::string& name,
                 const char* type) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw failure("the file cannot be read any more; try again");
  response.set_header("Content-Disposition", fmt::format("attachment; filename=\"{}\"; filename*=UTF-8''{}",
                                                         in_ascii(name), in_percents(name)));
  response.set_content(std::move(bytes), type);
}

}  // namespace tramline::server
