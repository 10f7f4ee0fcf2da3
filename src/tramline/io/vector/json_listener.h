#pragma once
// A base for listeners that parse JSON without storing it.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace tramline::io {

/// Ignores everything; derived listeners override the events they need. A fault in the text ends the parsing.
class JsonListener : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool start_object(std::size_t) override { return value(); }
  bool end_object() override { return value(); }
  bool key(std::string&) override { return true; }
  bool start_array(std::size_t) override { return value(); }
  bool end_array() override { return value(); }
  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(std::string&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 protected:
  /// Called for a value, or its beginning or end, that has no override. False ends the parsing.
  virtual bool value() = 0;
};

}  // namespace tramline::io
