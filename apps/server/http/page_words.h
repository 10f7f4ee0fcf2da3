#pragma once
// Rewords messages of the library and of requests for users of the page instead of the command line.

#include <nlohmann/json.hpp>
#include <string>

namespace tramline::server {

/// "--width" becomes "the working width" and so on; what is not known stays as it is.
std::string in_page_words(std::string sentence);

/// A summary of a plan or a drive with its "warnings" in such words.
nlohmann::ordered_json summary_in_page_words(nlohmann::ordered_json summary);

}  // namespace tramline::server
