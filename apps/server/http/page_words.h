#pragma once
// Sentences of the library and of the requests, for those who sit before a page and not before a command
// line.

#include <string>

namespace tramline::server {

/// "--width" becomes "the working width" and so on; what is not known stays as it is.
std::string in_page_words(std::string sentence);

}  // namespace tramline::server
