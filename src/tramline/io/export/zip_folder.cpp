#include "tramline/io/export/zip_folder.h"

#include <cpl_error.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <cstdint>

#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

// Offsets and signatures of PKWARE's APPNOTE, 4.3.7, 4.3.12 and 4.3.16.
constexpr std::uint32_t kLocal = 0x04034b50, kCentral = 0x02014b50, kEnd = 0x06054b50;
constexpr std::size_t kLocalSize = 30, kCentralSize = 46, kEndSize = 22;

std::uint32_t number(std::span<const std::byte> bytes, std::size_t at, int size) {
  std::uint32_t out = 0;
  for (int i = size - 1; i >= 0; --i)
    out = out << 8 | std::to_integer<std::uint32_t>(bytes[at + static_cast<std::size_t>(i)]);
  return out;
}

void put(std::span<std::byte> bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::byte>(value >> (8 * i) & 0xff);
}

/// Time in the low 16 bits, date in the high ones: two seconds are the finest, 1980 the earliest, 2107 the
/// last year.
std::uint32_t dos_time(std::time_t time) {
  constexpr std::time_t k1980 = 315532800, k2107 = 4354819198;
  time = std::clamp(time, k1980, k2107);
  std::tm utc{};
  gmtime_r(&time, &utc);
  const auto bits = [](int value, int shift) { return static_cast<std::uint32_t>(value) << shift; };
  return bits(utc.tm_year - 80, 25) | bits(utc.tm_mon + 1, 21) | bits(utc.tm_mday, 16) |
         bits(utc.tm_hour, 11) | bits(utc.tm_min, 5) | bits(utc.tm_sec / 2, 0);
}

bool holds(std::span<const std::byte> bytes, std::size_t at, std::size_t size, std::uint32_t signature) {
  return at + size <= bytes.size() && number(bytes, at, 4) == signature;
}

}  // namespace

void stamp_zip(std::span<std::byte> zip, std::time_t time) {
  const Error broken = failure("GDAL wrote a zip file that cannot be read again");
  // No comment: the end record is the last of the file.
  if (zip.size() < kEndSize || !holds(zip, zip.size() - kEndSize, kEndSize, kEnd)) throw broken;
  const std::size_t end = zip.size() - kEndSize;
  const std::uint32_t count = number(zip, end + 10, 2), stamp = dos_time(time);
  std::size_t at = number(zip, end + 16, 4);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!holds(zip, at, kCentralSize, kCentral)) throw broken;
    const std::size_t local = number(zip, at + 42, 4);
    if (!holds(zip, local, kLocalSize, kLocal)) throw broken;
    put(zip, at + 12, stamp);
    put(zip, local + 10, stamp);
    at += kCentralSize + number(zip, at + 28, 2) + number(zip, at + 30, 2) + number(zip, at + 32, 2);
  }
}

void zip_files(const MemoryFolder& folder, const std::vector<std::string>& names, const std::string& zip,
               std::time_t time) {
  for (const std::string& name : names) {
    const std::span<const std::byte> bytes = folder.bytes(name);
    VSILFILE* file = VSIFOpenL(("/vsizip/" + folder.file(zip) + "/" + name).c_str(), "wb");
    if (file == nullptr || VSIFWriteL(bytes.data(), 1, bytes.size(), file) != bytes.size())
      CPLError(CE_Failure, CPLE_FileIO, "%s could not be packed", name.c_str());
    if (file != nullptr) VSIFCloseL(file);
  }
  vsi_l_offset size = 0;
  GByte* data = VSIGetMemFileBuffer(folder.file(zip).c_str(), &size, FALSE);
  if (data != nullptr)
    stamp_zip(std::as_writable_bytes(std::span(data, static_cast<std::size_t>(size))), time);
}

}  // namespace tramline::io
