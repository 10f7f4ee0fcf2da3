#include "server/store/new_id.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <random>

namespace tramline::server {
namespace {

constexpr std::string_view kLetters = "0123456789abcdefghijklmnopqrstuv";

std::string letters(std::size_t count) {
  // Debian's libstdc++ reads the processor's source or the kernel's.
  std::random_device chance;
  std::string out;
  while (out.size() < count) out += kLetters[chance() % kLetters.size()];
  return out;
}

}  // namespace

std::string new_id() {
  using namespace std::chrono;
  constexpr std::size_t kDigits = 4;  // 32⁴ is just more than a million
  const system_clock::time_point now = system_clock::now();
  auto us = duration_cast<microseconds>(now.time_since_epoch()).count() % 1'000'000;
  std::string within(kDigits, '0');
  for (auto digit = within.rbegin(); digit != within.rend(); ++digit, us /= 32)
    *digit = kLetters[static_cast<std::size_t>(us % 32)];
  return fmt::format("{:%Y%m%d-%H%M%S}-{}{}", fmt::gmtime(system_clock::to_time_t(now)), within, letters(6));
}

bool is_id(std::string_view text) {
  const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), plain);
}

std::string new_token() { return letters(32); }

std::string time_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%S}Z", fmt::gmtime(std::time(nullptr))); }

}  // namespace tramline::server
