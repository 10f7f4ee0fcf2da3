#pragma once
// GeoPackages of tramline that others have changed, and what their readers say about them.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/refusals.h"
#include "support/temporary_folder.h"

namespace tramline::testing_support {

/// Changes a file through GDAL by `change(GDALDataset&)`. Statements that fail print nothing.
template <class Change>
void change_file(const std::filesystem::path& file, Change change) {
  CPLPushErrorHandler(CPLQuietErrorHandler);
  {
    const GDALDatasetUniquePtr data(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    change(*data);
  }
  CPLPopErrorHandler();
}

inline void run_sql(const std::filesystem::path& file, const std::string& statement) {
  change_file(file, [&](GDALDataset& data) { data.ExecuteSQL(statement.c_str(), nullptr, nullptr); });
}

/// The one sentence, with the name of the file, by which `read()` refuses a file as bad input; "" where it
/// reads it.
template <class Read>
std::string refusal_of_file(const std::filesystem::path& file, Read read) {
  try {
    read();
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << sentence;
    EXPECT_TRUE(mentions(sentence, file.filename().string())) << sentence;
    EXPECT_FALSE(mentions(sentence, "\n")) << sentence;
    return sentence;
  }
  return "";
}

/// Calls `read()` for many copies of the file with bytes changed at random, more in each copy.
template <class Read>
void read_damaged_copies(const std::filesystem::path& file, Read read) {
  const std::string whole = bytes_of(file);
  std::mt19937 random(3);
  for (int changes = 1; changes <= 150; ++changes) {
    std::ofstream(file, std::ios::binary) << damaged(whole, changes, random);
    read();
  }
}

}  // namespace tramline::testing_support
