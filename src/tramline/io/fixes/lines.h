#pragma once
// Reads the lines of a text one after the other, also from gzipped files.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace tramline::io {

/// The largest expanded size of a compressed file, and of a file that has to be read whole; larger ones are
/// refused.
inline constexpr std::size_t kMostExpanded = std::size_t{1} << 30;
/// The largest text that is held whole and parsed into a tree several times its size; larger ones are
/// refused.
inline constexpr std::size_t kMostWholeText = std::size_t{128} << 20;
/// The limit on the length of a line; no line of a log is as long.
inline constexpr std::size_t kLongestLine = std::size_t{1} << 20;

/// The limit on the number of lines; no log has as many: 3 million fixes of NMEA come with up to 16 sentences
/// each.
inline constexpr std::size_t kMostLines = 50'000'000;

/// A source of lines.
class Lines {
 public:
  virtual ~Lines() = default;
  /// The next line without its end; false after the last. A last line without an end counts.
  virtual bool next(std::string& line) = 0;
  /// The reason why the text stopped before its end; empty when it did not.
  virtual std::string cut_off() const { return {}; }
};

/// Lines of a text in memory, which has to outlive this.
class TextLines final : public Lines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}
  bool next(std::string& line) override;

 private:
  std::string_view rest_;
};

/// Lines of a file, plain or gzipped. Throws bad_input when it cannot be opened, when a gzipped file expands
/// to more than `most_expanded` bytes, when a line is longer than kLongestLine and beyond kMostLines. Memory
/// does not grow with the file.
class FileLines final : public Lines {
 public:
  explicit FileLines(const std::string& path, std::size_t most_expanded = kMostExpanded);
  FileLines(const FileLines&) = delete;
  FileLines& operator=(const FileLines&) = delete;
  ~FileLines() override;
  bool next(std::string& line) override;
  std::string cut_off() const override;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// The first bytes of a file, expanded when it is gzipped. Throws bad_input when it cannot be opened.
std::string first_bytes(const std::string& path, std::size_t most);

/// A whole file, expanded when it is gzipped. Throws bad_input when it cannot be opened and beyond
/// kMostExpanded.
std::string whole_text(const std::string& path);

}  // namespace tramline::io
