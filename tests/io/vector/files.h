#pragma once
// Little vector files for one test.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tramline/io/vector/read_vector.h"

namespace tramline::testing_files {

using namespace io;

/// A folder that is gone after the test.
class Files : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// Writes text (or bytes) to a file of this name and returns its path.
  std::string write(const std::string& name, const std::string& bytes) const;
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string bytes_of(const std::string& path);

  std::filesystem::path folder_;
};

/// One feature to write with OGR.
struct Row {
  std::string id;
  std::string wkt;
};

/// Writes a layer with the text field "id" by an OGR driver. `epsg` 0: no CRS.
void write_layer(const std::string& driver, const std::string& path, const std::string& layer, int epsg,
                 const std::vector<Row>& rows, bool append = false);

/// Puts files into a zip under the given names.
void write_zip(const std::string& zip,
               const std::vector<std::pair<std::string, std::string>>& name_and_bytes);

VectorQuery query(const std::string& file, const std::string& layer = "", const std::string& where = "");

/// The sentence with which reading is refused; fails when it is not.
std::string refusal(const VectorQuery& query);

}  // namespace tramline::testing_files
