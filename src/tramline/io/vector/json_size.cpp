#include "tramline/io/vector/json_size.h"

#include <istream>
#include <nlohmann/json.hpp>
#include <string>

#include "tramline/io/vector/json_crs.h"
#include "tramline/io/vector/json_listener.h"

namespace tramline::io {
namespace {

using nlohmann::json;

/// Keeps the "type" of the value itself, and nothing else.
class TypeListener final : public JsonListener {
 public:
  bool is_collection() const { return is_collection_; }

  bool start_object(std::size_t) override { return down(); }
  bool end_object() override { return up(); }
  bool start_array(std::size_t) override { return down(); }
  bool end_array() override { return up(); }
  bool key(std::string& name) override {
    at_type_ = depth_ == 1 && name == "type";
    return true;
  }
  bool string(std::string& text) override {
    if (at_type_) is_collection_ = text == "FeatureCollection";
    return value();
  }

 private:
  bool down() {
    ++depth_;
    return value();
  }
  bool up() {
    --depth_;
    return value();
  }
  bool value() override {
    at_type_ = false;
    return true;
  }

  std::size_t depth_ = 0;
  bool at_type_ = false, is_collection_ = false;
};

}  // namespace

bool has_large_json_value(std::istream& text, const std::function<std::size_t()>& read, std::size_t size,
                          std::size_t most) {
  std::size_t start = 0;
  while (skip_to_json_value(text)) {
    TypeListener listener;
    const bool whole = json::sax_parse(text, &listener, json::input_format_t::json, false);
    const std::size_t end = whole ? read() : size;
    if (end > start + most && !listener.is_collection()) return true;
    if (!whole) return false;
    start = end;
  }
  return false;
}

}  // namespace tramline::io
