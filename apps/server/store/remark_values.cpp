#include "server/store/remark_values.h"

#include "report/report_parts.h"

namespace tramline::server {

std::string remark(const io::Metadata& remarks, const std::string& key) {
  const auto found = remarks.find(key);
  return found == remarks.end() ? std::string() : found->second;
}

std::string skipped_text(const std::vector<Skipped>& skipped) {
  return app::json_line(app::skipped_json(skipped));
}

std::vector<Skipped> skipped_in(const std::string& text) {
  std::vector<Skipped> out;
  const auto list = nlohmann::json::parse(text, nullptr, false);
  if (!list.is_array()) return out;
  for (const auto& item : list)
    if (item.is_object())
      out.push_back({item.value("what", ""), item.value("where", ""), item.value("why", "")});
  return out;
}

std::string words_text(const std::vector<std::string>& words) {
  return app::json_line(nlohmann::ordered_json(words));
}

std::vector<std::string> words_in(const std::string& text) {
  std::vector<std::string> out;
  const auto list = nlohmann::json::parse(text, nullptr, false);
  if (!list.is_array()) return out;
  for (const auto& word : list)
    if (word.is_string()) out.push_back(word.get<std::string>());
  return out;
}

}  // namespace tramline::server
