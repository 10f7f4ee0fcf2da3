#pragma once
// The remarks that the server stores in its files, as texts.

#include <string>
#include <vector>

#include "tramline/io/geopackage/metadata.h"
#include "tramline/model/report.h"

namespace tramline::server {

/// Empty where there is none.
std::string remark(const io::Metadata& remarks, const std::string& key);

std::string skipped_text(const std::vector<Skipped>& skipped);
/// The inverse; none where the text is of another form.
std::vector<Skipped> skipped_in(const std::string& text);

/// A list of words, and the inverse; none where the text is of another form.
std::string words_text(const std::vector<std::string>& words);
std::vector<std::string> words_in(const std::string& text);

}  // namespace tramline::server
