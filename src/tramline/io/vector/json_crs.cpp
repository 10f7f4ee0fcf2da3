#include "tramline/io/vector/json_crs.h"

#include <cstddef>
#include <istream>
#include <nlohmann/json.hpp>

#include "tramline/io/vector/json_listener.h"

namespace tramline::io {
namespace {

using nlohmann::json;

using TakeCrs = std::function<void(const std::string&, const std::string&)>;

/// Follows the parser through the values, and keeps only what stands in a "crs".
class CrsListener final : public JsonListener {
 public:
  explicit CrsListener(const TakeCrs& take) : take_(take) {}

  bool start_object(std::size_t) override {
    ++depth_;
    if (crs_depth_ == 0 && key_ == "crs") {
      crs_depth_ = depth_;
      type_.clear();
      place_.clear();
    }
    key_.clear();
    return true;
  }
  bool end_object() override {
    if (depth_ == crs_depth_) {
      take_(type_, place_);
      crs_depth_ = 0;
    }
    --depth_;
    key_.clear();
    return true;
  }
  bool key(std::string& name) override {
    key_ = name;
    return true;
  }
  bool string(std::string& text) override {
    if (crs_depth_ > 0 && key_ == "type" && depth_ == crs_depth_) type_ = text;
    if (crs_depth_ > 0 && (key_ == "href" || key_ == "url" || key_ == "name")) place_ = text;
    return value();
  }

 private:
  bool value() override {
    key_.clear();
    return true;
  }

  const TakeCrs& take_;
  std::string key_, type_, place_;
  std::size_t depth_ = 0, crs_depth_ = 0;  ///< 0: in no object, in no "crs"
};

}  // namespace

bool skip_to_json_value(std::istream& text) {
  constexpr char kRecordSeparator = 0x1e;
  while ((text >> std::ws) && text.peek() == kRecordSeparator) text.get();
  return text.good() && text.peek() != std::istream::traits_type::eof();
}

void each_json_crs(std::istream& text, const TakeCrs& take) {
  while (skip_to_json_value(text)) {
    CrsListener listener(take);
    if (!json::sax_parse(text, &listener, json::input_format_t::json, false)) return;
  }
}

}  // namespace tramline::io
