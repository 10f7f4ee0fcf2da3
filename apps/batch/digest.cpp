#include "batch/digest.h"

#include <fmt/format.h>

#include <fstream>
#include <vector>

namespace tramline::app {

void Digest::add(const void* bytes, std::size_t count) {
  const auto* byte = static_cast<const unsigned char*>(bytes);
  for (std::size_t i = 0; i < count; ++i) state_ = (state_ ^ byte[i]) * 0x100000001b3;
}

void Digest::add_file(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::vector<char> piece(1 << 16);
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0)
    add(piece.data(), static_cast<std::size_t>(stream.gcount()));
}

std::string Digest::text() const { return fmt::format("{:016x}", state_); }

std::string digest_of(const std::string& text) {
  Digest out;
  out.add(text);
  return out.text();
}

}  // namespace tramline::app
