#include "tramline/io/log/work_word.h"

#include <algorithm>
#include <array>
#include <string>

#include "tramline/io/fixes/number_text.h"

namespace tramline::io {
namespace {

constexpr std::array<std::string_view, 17> kOn = {
    "true", "on",      "yes",   "t",       "y",      "working", "work",     "recording", "in",
    "down", "lowered", "lower", "engaged", "active", "enabled", "applying", "work on"};
constexpr std::array<std::string_view, 17> kOff = {
    "false", "off",    "no",    "f",          "n",        "not working", "not recording", "idle",    "out",
    "up",    "raised", "raise", "disengaged", "inactive", "disabled",    "not applying",  "work off"};

template <class Words>
bool contains(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::optional<WorkState> work_word(std::string_view text) {
  const std::string word = lower_case(trimmed(text));
  if (word.empty()) return WorkState::kUnknown;
  if (contains(kOn, word)) return WorkState::kOn;
  if (contains(kOff, word)) return WorkState::kOff;
  const auto value = number_in(word);
  if (value && *value == 1) return WorkState::kOn;
  if (value && *value == 0) return WorkState::kOff;
  return std::nullopt;
}

}  // namespace tramline::io
