#pragma once
// Messages of the library for people who have typed keywords instead of options.

#include <string>

namespace tramline::python {

/// "--obstacle-headlands takes …" as "obstacle_headlands takes …". Words without the two dashes stay.
std::string with_keywords(const std::string& message);

}  // namespace tramline::python
