#pragma once
// Names as terminals show them.

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace tramline::io {

/// Longest designator of ISO 11783-10, in characters.
inline constexpr std::size_t kLongestDesignator = 32;

/// The text in printable ASCII, without blanks at its ends: letters with marks become the letter, German
/// umlauts two letters, Greek and Cyrillic letters those they are transcribed with; anything else becomes
/// '_'. Not shortened. Text that is no UTF-8 is taken byte by byte.
std::string in_ascii(std::string_view utf8);

/// Gives designators of which no two are alike: "Large field", "Large field 2".
class Designators {
 public:
  /// The name in ASCII, shortened to kLongestDesignator; `otherwise` where no letter or digit of it is left.
  std::string unique(std::string_view utf8, const std::string& otherwise);
  /// The same as the name of a folder on any system: without / \ : * ? " < > |, and without a full stop at
  /// its end.
  std::string unique_folder(std::string_view utf8, const std::string& otherwise);

 private:
  std::set<std::string, std::less<>> given_;
};

}  // namespace tramline::io
