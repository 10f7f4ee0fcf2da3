#include "tramline/io/terminal/designators.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "tramline/io/vector/lower_case.h"

namespace tramline::io {
namespace {

constexpr char32_t kNoCharacter = 0xFFFFFFFF;

/// A run of letters that follow one another in Unicode, each with its transcription.
template <std::size_t N>
struct Letters {
  char32_t first;
  std::array<std::string_view, N> ascii;
};

/// U+00C0 to U+00FF: Latin letters of western Europe; the umlauts as in German, the ring as in Danish.
constexpr Letters<64> kWestern{
    0xC0, {"A", "A", "A", "A", "Ae", "Aa", "AE", "C", "E",  "E", "E", "E", "I",  "I", "I",  "I",
           "D", "N", "O", "O", "O",  "O",  "Oe", "x", "Oe", "U", "U", "U", "Ue", "Y", "Th", "ss",
           "a", "a", "a", "a", "ae", "aa", "ae", "c", "e",  "e", "e", "e", "i",  "i", "i",  "i",
           "d", "n", "o", "o", "o",  "o",  "oe", "_", "oe", "u", "u", "u", "ue", "y", "th", "y"}};

/// U+0100 to U+017F: those of central and eastern Europe.
constexpr Letters<128> kCentral{
    0x100, {"A", "a", "A", "a", "A", "a", "C",  "c",  "C", "c", "C", "c", "C",  "c",  "D", "d", "D", "d", "E",
            "e", "E", "e", "E", "e", "E", "e",  "E",  "e", "G", "g", "G", "g",  "G",  "g", "G", "g", "H", "h",
            "H", "h", "I", "i", "I", "i", "I",  "i",  "I", "i", "I", "i", "IJ", "ij", "J", "j", "K", "k", "k",
            "L", "l", "L", "l", "L", "l", "L",  "l",  "L", "l", "N", "n", "N",  "n",  "N", "n", "n", "N", "n",
            "O", "o", "O", "o", "O", "o", "OE", "oe", "R", "r", "R", "r", "R",  "r",  "S", "s", "S", "s", "S",
            "s", "S", "s", "T", "t", "T", "t",  "T",  "t", "U", "u", "U", "u",  "U",  "u", "U", "u", "U", "u",
            "U", "u", "W", "w", "Y", "y", "Y",  "Z",  "z", "Z", "z", "Z", "z",  "s"}};

/// U+0386 to U+03CE.
constexpr Letters<73> kGreek{
    0x386,
    {"A", "_", "E", "I", "I", "_", "O", "_", "Y",  "O",  "i", "A", "V",  "G", "D",  "E",  "Z", "I", "Th",
     "I", "K", "L", "M", "N", "X", "O", "P", "R",  "_",  "S", "T", "Y",  "F", "Ch", "Ps", "O", "I", "Y",
     "a", "e", "i", "i", "y", "a", "v", "g", "d",  "e",  "z", "i", "th", "i", "k",  "l",  "m", "n", "x",
     "o", "p", "r", "s", "s", "t", "y", "f", "ch", "ps", "o", "i", "y",  "o", "y",  "o"}};

/// U+0400 to U+045F.
constexpr Letters<96> kCyrillic{
    0x400, {"E", "E", "D", "G", "Ye", "Dz", "I",  "Yi", "J",  "Lj",   "Nj", "C", "K", "I", "U",  "Dz",
            "A", "B", "V", "G", "D",  "E",  "Zh", "Z",  "I",  "J",    "K",  "L", "M", "N", "O",  "P",
            "R", "S", "T", "U", "F",  "Kh", "Ts", "Ch", "Sh", "Shch", "",   "Y", "",  "E", "Yu", "Ya",
            "a", "b", "v", "g", "d",  "e",  "zh", "z",  "i",  "j",    "k",  "l", "m", "n", "o",  "p",
            "r", "s", "t", "u", "f",  "kh", "ts", "ch", "sh", "shch", "",   "y", "",  "e", "yu", "ya",
            "e", "e", "d", "g", "ye", "dz", "i",  "yi", "j",  "lj",   "nj", "c", "k", "i", "u",  "dz"}};

template <std::size_t N>
bool transcribe(const Letters<N>& letters, char32_t c, std::string& out) {
  if (c < letters.first || c >= letters.first + N) return false;
  out += letters.ascii[c - letters.first];
  return true;
}

/// Takes the next character off the text; kNoCharacter, taking one byte, where it is no UTF-8.
char32_t next_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  const std::size_t size = lead < 0x80       ? 1
                           : lead >> 5 == 6  ? 2
                           : lead >> 4 == 14 ? 3
                           : lead >> 3 == 30 ? 4
                                             : 0;
  char32_t out = size < 2 ? lead : lead & (0xFFU >> (size + 1));
  bool whole = size > 0 && text.size() >= size;
  for (std::size_t i = 1; whole && i < size; ++i) {
    whole = byte(i) >> 6 == 2;
    out = out << 6 | (byte(i) & 0x3FU);
  }
  text.remove_prefix(whole ? size : 1);
  return whole ? out : kNoCharacter;
}

bool is_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

std::string trimmed_text(std::string text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Windows takes these for devices, whatever the extension.
bool is_device(const std::string& folder) {
  const std::string name = lower_case(folder.substr(0, folder.find('.')));
  if (name == "con" || name == "prn" || name == "aux" || name == "nul") return true;
  return name.size() == 4 && (name.starts_with("com") || name.starts_with("lpt")) && name[3] >= '1' &&
         name[3] <= '9';
}

}  // namespace

std::string in_ascii(std::string_view utf8) {
  std::string out;
  while (!utf8.empty()) {
    const char32_t c = next_character(utf8);
    const bool combining = c >= 0x300 && c < 0x370;
    if (combining) continue;
    if (c >= 0x20 && c < 0x7F)
      out += static_cast<char>(c);
    else if (!transcribe(kWestern, c, out) && !transcribe(kCentral, c, out) && !transcribe(kGreek, c, out) &&
             !transcribe(kCyrillic, c, out))
      out += '_';
  }
  return trimmed_text(std::move(out));
}

std::string Designators::unique(std::string_view utf8, const std::string& otherwise) {
  std::string name = in_ascii(utf8);
  if (std::none_of(name.begin(), name.end(), is_letter_or_digit)) name = otherwise;
  std::string out = trimmed_text(name.substr(0, kLongestDesignator));
  for (int number = 2; given_.contains(lower_case(out)); ++number) {
    const std::string suffix = fmt::format(" {}", number);
    out = trimmed_text(name.substr(0, kLongestDesignator - suffix.size())) + suffix;
  }
  given_.insert(lower_case(out));
  return out;
}

std::string Designators::unique_folder(std::string_view utf8, const std::string& otherwise) {
  std::string name = in_ascii(utf8);
  for (char& c : name)
    if (std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos) c = '_';
  name.resize(std::min(name.size(), kLongestDesignator));
  while (name.ends_with('.') || name.ends_with(' ')) name.pop_back();
  return unique(is_device(name) ? "" : name, otherwise);
}

}  // namespace tramline::io
