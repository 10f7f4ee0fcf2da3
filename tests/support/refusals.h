#pragma once
// What was wrong with bad input, in words.

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <string>

#include "tramline/geometry/error.h"

namespace tramline::testing_support {

/// The error that a call throws. A call that throws none has failed.
template <class Call>
Error error_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no Error was thrown";
  return failure("");
}

/// The sentence with which a call refuses bad input.
template <class Call>
std::string refusal_of(Call call) {
  const Error error = error_of(call);
  EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
  return error.what();
}

/// The result of a call; nullopt where it refuses bad input.
template <class Call>
auto unless_refused(Call call) -> std::optional<decltype(call())> {
  try {
    return call();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kBadInput) throw;
    return std::nullopt;
  }
}

/// The statement throws an Error that finds the user's input at fault, or that a run failed: another kind is
/// not what was expected.
#define EXPECT_REFUSED(...)                                                     \
  EXPECT_EQ(::tramline::testing_support::error_of([&] { __VA_ARGS__; }).kind(), \
            ::tramline::ErrorKind::kBadInput)
#define EXPECT_RUN_FAILURE(...)                                                 \
  EXPECT_EQ(::tramline::testing_support::error_of([&] { __VA_ARGS__; }).kind(), \
            ::tramline::ErrorKind::kFailure)

inline bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// As many bytes of a text changed at random.
inline std::string damaged(std::string bytes, int changes, std::mt19937& random) {
  std::uniform_int_distribution<std::size_t> place(0, bytes.size() - 1);
  std::uniform_int_distribution<int> byte(0, 255);
  for (int k = 0; k < changes; ++k) bytes[place(random)] = static_cast<char>(byte(random));
  return bytes;
}

}  // namespace tramline::testing_support
