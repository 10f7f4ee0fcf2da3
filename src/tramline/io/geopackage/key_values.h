#pragma once
// Converts values of every kind to the texts of the table `metadata`, and back.

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/file_kind.h"
#include "tramline/io/geopackage/metadata.h"

namespace tramline::io {

/// Writes values under keys. Zeros have no sign.
class KeyWriter {
 public:
  explicit KeyWriter(Metadata& out) : out_(out) {}
  void operator()(const std::string& key, const std::string& value) const { out_[key] = value; }
  void operator()(const std::string& key, double value) const;
  void operator()(const std::string& key, int value) const { out_[key] = std::to_string(value); }
  void operator()(const std::string& key, long long value) const { out_[key] = std::to_string(value); }
  void operator()(const std::string& key, std::size_t value) const { out_[key] = std::to_string(value); }
  void operator()(const std::string& key, bool value) const { out_[key] = value ? "true" : "false"; }
  void operator()(const std::string& key, const std::vector<std::string>& values) const {
    out_[key] = dumped(nlohmann::json(values));
  }
  /// NaN as an empty text.
  void number_if_any(const std::string& key, double value) const;

 protected:
  /// A name that is not UTF-8 must not stop a file from being written.
  static std::string dumped(const nlohmann::json& json) {
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
  Metadata& out() const { return out_; }

 private:
  Metadata& out_;
};

/// The inverse. Every function throws Error(kBadInput) naming the file and the key where that is missing or
/// has a value of the wrong type; numbers have to be finite.
class KeyReader {
 public:
  /// All three have to outlive this.
  KeyReader(const Metadata& metadata, const std::filesystem::path& file, const FileKind& kind)
      : metadata_(metadata), file_(file), kind_(kind) {}

  void operator()(const std::string& key, std::string& value) const { value = text(key); }
  void operator()(const std::string& key, double& value) const;
  void operator()(const std::string& key, int& value) const;
  void operator()(const std::string& key, long long& value) const;
  void operator()(const std::string& key, std::size_t& value) const;
  void operator()(const std::string& key, bool& value) const;
  void operator()(const std::string& key, std::vector<std::string>& values) const;
  /// An empty text as NaN.
  void number_if_any(const std::string& key, double& value) const;

  const std::string& text(const std::string& key) const;
  Error wrong(const std::string& key, const char* expected) const;
  /// "plan.gpkg: table metadata, reference"
  std::string place_of(const std::string& key) const;
  /// Passes the JSON under the key to `take`; exceptions of nlohmann::json are reported as "not a list".
  void parse(const std::string& key, const std::function<void(const nlohmann::json&)>& take) const;

 private:
  const Metadata& metadata_;
  const std::filesystem::path& file_;
  const FileKind& kind_;
};

}  // namespace tramline::io
