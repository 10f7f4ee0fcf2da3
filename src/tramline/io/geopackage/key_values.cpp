#include "tramline/io/geopackage/key_values.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "tramline/model/plain_zero.h"

namespace tramline::io {
namespace {

template <class Number>
Number number_of(const KeyReader& reader, const std::string& key) {
  const std::string& digits = reader.text(key);
  Number value{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size()) throw reader.wrong(key, "a number");
  return value;
}

}  // namespace

void KeyWriter::operator()(const std::string& key, double value) const {
  out_[key] = fmt::format("{}", plain_zero(value));
}

void KeyWriter::number_if_any(const std::string& key, double value) const {
  out_[key] = std::isnan(value) ? std::string() : fmt::format("{}", plain_zero(value));
}

void KeyReader::operator()(const std::string& key, double& value) const {
  value = number_of<double>(*this, key);
  if (!std::isfinite(value)) throw wrong(key, "a finite number");
}

void KeyReader::operator()(const std::string& key, int& value) const { value = number_of<int>(*this, key); }

void KeyReader::operator()(const std::string& key, long long& value) const {
  value = number_of<long long>(*this, key);
}

void KeyReader::operator()(const std::string& key, std::size_t& value) const {
  value = number_of<std::size_t>(*this, key);
}

void KeyReader::operator()(const std::string& key, bool& value) const {
  if (text(key) != "true" && text(key) != "false") throw wrong(key, "true or false");
  value = text(key) == "true";
}

void KeyReader::operator()(const std::string& key, std::vector<std::string>& values) const {
  parse(key, [&](const nlohmann::json& json) { values = json.get<std::vector<std::string>>(); });
}

void KeyReader::number_if_any(const std::string& key, double& value) const {
  if (text(key).empty())
    value = std::numeric_limits<double>::quiet_NaN();
  else
    (*this)(key, value);
}

const std::string& KeyReader::text(const std::string& key) const {
  const auto found = metadata_.find(key);
  if (found != metadata_.end()) return found->second;
  throw bad_input(fmt::format("{}: the table metadata has no key '{}'; write the {} again with {}",
                              file_.string(), key, kind_.what, kind_.writer));
}

Error KeyReader::wrong(const std::string& key, const char* expected) const {
  return bad_input(fmt::format("{}: '{}' in the table metadata is '{}', expected {}", file_.string(), key,
                               text(key), expected));
}

std::string KeyReader::place_of(const std::string& key) const {
  return fmt::format("{}: table metadata, {}", file_.string(), key);
}

void KeyReader::parse(const std::string& key, const std::function<void(const nlohmann::json&)>& take) const {
  try {
    take(nlohmann::json::parse(text(key)));
  } catch (const nlohmann::json::exception&) {
    throw wrong(key, "a JSON list");
  }
}

}  // namespace tramline::io
