#include "server/store/new_id.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <random>

namespace tramline::server {
namespace {

std::string letters(std::size_t count) {
  constexpr std::string_view kLetters = "0123456789abcdefghijklmnopqrstuv";
  // Debian's libstdc++ reads the processor's source or the kernel's.
  std::random_device chance;
  std::string out;
  while (out.size() < count) out += kLetters[chance() % kLetters.size()];
  return out;
}

}  // namespace

std::string new_id() {
  return fmt::format("{:%Y%m%d-%H%M%S}-{}", fmt::gmtime(std::time(nullptr)), letters(6));
}

bool is_id(std::string_view text) {
  const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), plain);
}

std::string new_token() { return letters(32); }

std::string time_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%S}Z", fmt::gmtime(std::time(nullptr))); }

}  // namespace tramline::server
