#pragma once
// Numbers as logs write them.

#include <optional>
#include <string>
#include <string_view>

namespace tramline::io {

/// The text without blanks, tabs and line ends around it.
std::string_view trimmed(std::string_view text);

/// A decimal number that takes up the whole text, blanks aside; nullopt for anything else, also for "nan" and
/// "inf". Independent of the locale.
std::optional<double> number_in(std::string_view text);

/// The same for whole numbers that are written as nothing but digits.
std::optional<long long> digits_in(std::string_view text);

/// The text with ASCII letters in lower case.
std::string lower_case(std::string_view text);

}  // namespace tramline::io
