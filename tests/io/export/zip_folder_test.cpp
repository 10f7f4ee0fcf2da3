#include "tramline/io/export/zip_folder.h"
#include "support/refusals.h"

#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

void put_file(const MemoryFolder& folder, const std::string& name, const std::string& text) {
  VSILFILE* file = VSIFOpenL(folder.file(name).c_str(), "wb");
  VSIFWriteL(text.data(), 1, text.size(), file);
  VSIFCloseL(file);
}

std::vector<std::byte> zipped(std::time_t time) {
  const MemoryFolder folder;
  put_file(folder, "a.txt", std::string(5000, 'x'));
  put_file(folder, "b.txt", "b");
  zip_files(folder, {"a.txt", "b.txt"}, "both.zip", time);
  const auto bytes = folder.bytes("both.zip");
  return {bytes.begin(), bytes.end()};
}

unsigned number(const std::vector<std::byte>& bytes, std::size_t at) {
  return std::to_integer<unsigned>(bytes[at]) | std::to_integer<unsigned>(bytes[at + 1]) << 8;
}

TEST(ZipFolder, EntriesCarryTheTimeGiven) {
  // 2023-11-14 22:13:20 UTC
  const std::vector<std::byte> zip = zipped(1700000000);
  const unsigned time = 22u << 11 | 13u << 5 | 10u, date = 43u << 9 | 11u << 5 | 14u;
  EXPECT_EQ(number(zip, 10), time);
  EXPECT_EQ(number(zip, 12), date);
  const std::size_t central = number(zip, zip.size() - 22 + 16);
  EXPECT_EQ(number(zip, central + 12), time);
  EXPECT_EQ(number(zip, central + 14), date);
}

TEST(ZipFolder, TimesBeforeTheFormatBecomeItsFirst) {
  const std::vector<std::byte> zip = zipped(0);
  EXPECT_EQ(number(zip, 10), 0u);
  EXPECT_EQ(number(zip, 12), 0u << 9 | 1u << 5 | 1u);
}

TEST(ZipFolder, BytesThatAreNoZipAreAFailure) {
  std::vector<std::byte> noise(100, std::byte{7});
  EXPECT_RUN_FAILURE(stamp_zip(noise, 0));
  std::vector<std::byte> cut = zipped(0);
  cut.erase(cut.begin());
  EXPECT_RUN_FAILURE(stamp_zip(cut, 0));
}

}  // namespace
}  // namespace tramline::io
