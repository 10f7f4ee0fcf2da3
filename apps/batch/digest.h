#pragma once
// Short texts by which a run that goes on recognises what it was begun with.

#include <cstddef>
#include <cstdint>
#include <string>

namespace tramline::app {

/// FNV-1a, 64 bits, of bytes that come piece by piece. Finds changes that happen, not forgeries.
class Digest {
 public:
  void add(const void* bytes, std::size_t count);
  void add(const std::string& text) { add(text.data(), text.size()); }
  /// The bytes of a file; nothing where it cannot be read. O(bytes).
  void add_file(const std::string& file);
  /// In hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t state_ = 0xcbf29ce484222325;
};

/// Of one text.
std::string digest_of(const std::string& text);

}  // namespace tramline::app
