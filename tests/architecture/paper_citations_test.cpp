// Citations of the three papers name what the papers have, and docs/papers.md names what the code has.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "architecture/plain_code.h"
#include "architecture/source_tree.h"

namespace tramline::architecture::paper_citations_test {

enum class Part { kSection, kEquation, kFigure, kTable, kAlgorithm };

/// What a paper numbers. Figures, tables, equations and algorithms are numbered from 1 without a gap.
struct Paper {
  std::set<std::string> sections;
  int equations = 0;
  int figures = 0;
  int tables = 0;
  int algorithms = 0;
};

/// Versleijen 2019: the table of contents. Zhou et al. 2020: no equation has a number. Zhang et al. 2023.
const std::map<std::string, Paper>& papers() {
  static const std::map<std::string, Paper> all = {
      {"Versleijen",
       {{"1",     "1.1",   "1.2",   "1.2.1", "1.2.2", "1.2.3", "1.3",   "2",     "2.1",   "2.1.1",
         "2.1.2", "2.1.3", "2.1.4", "2.1.5", "2.1.6", "2.2",   "2.2.1", "2.2.2", "2.2.3", "2.2.4",
         "2.2.5", "2.2.6", "2.3",   "2.3.1", "2.3.2", "2.3.3", "2.3.4", "3",     "3.1",   "3.1.1",
         "3.1.2", "3.1.3", "3.2",   "3.2.1", "3.2.2", "3.2.3", "3.3",   "3.3.1", "3.3.2", "4",
         "4.1",   "4.2",   "4.2.1", "4.2.2", "4.3",   "5"},
        3,
        50,
        14,
        0}},
      {"Zhou",
       {{"1", "2", "2.1", "2.2", "2.3", "2.3.1", "2.3.2", "2.3.3", "2.3.4", "2.3.5", "3", "4", "5"},
        0,
        14,
        5,
        2}},
      {"Zhang",
       {{"1",     "2",     "2.1",   "2.2",   "2.3",   "2.3.1", "2.3.2", "2.3.3",
         "2.4",   "2.4.1", "2.4.2", "2.4.3", "2.4.4", "2.5",   "2.5.1", "2.5.2",
         "2.5.3", "2.5.4", "3",     "3.1",   "3.2",   "4",     "5"},
        8,
        18,
        3,
        0}},
  };
  return all;
}

bool exists(const Paper& paper, Part part, const std::string& number) {
  if (part == Part::kSection) return paper.sections.count(number) > 0;
  if (number.find('.') != std::string::npos) return false;
  const int most = part == Part::kEquation ? paper.equations
                   : part == Part::kFigure ? paper.figures
                   : part == Part::kTable  ? paper.tables
                                           : paper.algorithms;
  return number.size() < 4 && std::stoi(number) >= 1 && std::stoi(number) <= most;
}

/// The words before numbers, longer ones before those they begin with.
constexpr std::array<std::pair<std::string_view, Part>, 20> kKinds = {{
    {"§", Part::kSection},
    {"sections", Part::kSection},
    {"section", Part::kSection},
    {"chapters", Part::kSection},
    {"chapter", Part::kSection},
    {"equations", Part::kEquation},
    {"equation", Part::kEquation},
    {"eqs.", Part::kEquation},
    {"eq.", Part::kEquation},
    {"Eqs.", Part::kEquation},
    {"Eq.", Part::kEquation},
    {"figures", Part::kFigure},
    {"figure", Part::kFigure},
    {"figs.", Part::kFigure},
    {"fig.", Part::kFigure},
    {"Fig.", Part::kFigure},
    {"tables", Part::kTable},
    {"table", Part::kTable},
    {"algorithms", Part::kAlgorithm},
    {"algorithm", Part::kAlgorithm},
}};

/// One number of a citation, such as {"Zhang", kEquation, "3"}.
struct Citation {
  std::string paper;
  Part part = Part::kSection;
  std::string number;
  friend bool operator==(const Citation& a, const Citation& b) = default;
};

/// Reads on from a place in a text.
class Reader {
 public:
  Reader(std::string_view text, std::size_t at) : text_(text), at_(at) {}
  bool take(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }
  /// Spaces, and a line's end with the marks of a comment that goes on.
  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) {
      if (text_[at_++] != '\n') continue;
      while (at_ < text_.size() && std::string_view(" /#<*").find(text_[at_]) != std::string_view::npos)
        ++at_;
    }
  }
  std::optional<Part> kind() {
    const std::size_t from = at_;
    skip_space();
    for (const auto& [word, part] : kKinds) {
      if (!take(word)) continue;
      skip_space();
      if (at_ < text_.size() && digit(at_)) return part;
      break;
    }
    at_ = from;
    return std::nullopt;
  }
  /// Digits and the dots between digits; empty where there are none.
  std::string number() {
    std::string out;
    while (at_ < text_.size() && (digit(at_) || (text_[at_] == '.' && !out.empty() && digit(at_ + 1))))
      out += text_[at_++];
    return out;
  }
  /// A letter or a remark in brackets behind a number: "fig. 50b", "table 3 (a)".
  void skip_suffix() {
    if (at_ < text_.size() && std::islower(static_cast<unsigned char>(text_[at_])) != 0 && !letter(at_ + 1))
      ++at_;
    if (text_.substr(at_, 2) != " (") return;
    const std::size_t close = text_.find(')', at_);
    if (close != std::string_view::npos && close - at_ < 24) at_ = close + 1;
  }
  /// A comma, "and" or "to" before another number or another kind.
  bool separator() {
    skip_suffix();
    const std::size_t from = at_;
    skip_space();
    if (take(",") || take("–") || take("and ") || take("and\n") || take("to ") || take("to\n")) {
      skip_space();
      take("and ");
      if (digit(at_)) return true;
      const std::size_t here = at_;
      if (kind()) {
        at_ = here;
        return true;
      }
    }
    at_ = from;
    return false;
  }

 private:
  bool letter(std::size_t at) const {
    return at < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at])) != 0;
  }
  bool digit(std::size_t at) const {
    return at < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at])) != 0;
  }
  std::string_view text_;
  std::size_t at_;
};

bool part_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The citations that follow a paper's name: "Zhang's eqs. 3 and 4", "Versleijen §2.2.3, fig. 16".
std::vector<Citation> citations_in(std::string_view text) {
  std::vector<Citation> out;
  for (const auto& [name, paper] : papers())
    for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
      Reader reader(text, at + name.size());
      reader.take("'s");
      reader.take(" et al.");
      for (const std::string_view year : {" 2019", " (2019)", " 2020", " (2020)", " 2023", " (2023)"})
        reader.take(year);
      reader.take(",");
      std::optional<Part> part = reader.kind();
      if (!part) continue;
      do {
        if (const std::optional<Part> next = reader.kind()) part = next;
        out.push_back({name, *part, reader.number()});
      } while (reader.separator());
    }
  return out;
}

/// Places such as "S2" with a dot and digits behind, of a list that readers of the repository do not have.
std::vector<std::string> foreign_numbers_in(std::string_view text) {
  std::vector<std::string> out;
  for (std::size_t at = text.find('S'); at != std::string_view::npos; at = text.find('S', at + 1)) {
    if (at + 3 >= text.size() || text[at + 1] < '1' || text[at + 1] > '3' || text[at + 2] != '.') continue;
    if (std::isdigit(static_cast<unsigned char>(text[at + 3])) == 0) continue;
    if (at == 0 || !part_of_word(text[at - 1])) out.emplace_back(text.substr(at, 5));
  }
  return out;
}

bool is_text(std::string_view bytes) { return bytes.substr(0, 8000).find('\0') == std::string_view::npos; }

/// This file shows wrong citations.
constexpr std::string_view kThisFile = "tests/architecture/paper_citations_test.cpp";

TEST(PaperCitations, AreFoundInAText) {
  const std::vector<Citation> expected = {{"Versleijen", Part::kSection, "2.2.3"},
                                          {"Versleijen", Part::kFigure, "16"},
                                          {"Versleijen", Part::kTable, "12"},
                                          {"Versleijen", Part::kTable, "14"},
                                          {"Zhang", Part::kEquation, "3"},
                                          {"Zhang", Part::kEquation, "4"},
                                          {"Zhang", Part::kSection, "3.1"},
                                          {"Zhou", Part::kAlgorithm, "2"},
                                          {"Zhou", Part::kFigure, "8"},
                                          {"Zhou", Part::kFigure, "10"},
                                          {"Zhou", Part::kSection, "2.2"}};
  EXPECT_EQ(citations_in("Versleijen §2.2.3, fig. 16: see Versleijen (2019), tables 12 to 14. Zhang's eqs.\n"
                         "  /// 3 and 4, and Zhang\n// §3.1; Zhou algorithm 2: 7 of them. Zhou says no more"
                         " than Zhou figs. 8 (c) and 10b, §2.2"),
            expected);
}

TEST(PaperCitations, OfWhatAPaperDoesNotHaveAreFound) {
  EXPECT_TRUE(exists(papers().at("Versleijen"), Part::kTable, "14"));
  EXPECT_FALSE(exists(papers().at("Versleijen"), Part::kTable, "15"));
  EXPECT_FALSE(exists(papers().at("Versleijen"), Part::kSection, "4.2.3"));
  EXPECT_FALSE(exists(papers().at("Zhou"), Part::kEquation, "1"));
  EXPECT_FALSE(exists(papers().at("Zhang"), Part::kFigure, "0"));
}

TEST(PaperCitations, NameWhatThePaperHas) {
  std::size_t seen = 0;
  for (const std::string& path : repository_files()) {
    if (path == kThisFile) continue;
    const std::string text = read(path);
    if (!is_text(text)) continue;
    for (const Citation& citation : citations_in(text)) {
      ++seen;
      EXPECT_TRUE(exists(papers().at(citation.paper), citation.part, citation.number))
          << path << " cites number " << citation.number << " of " << citation.paper
          << ", which the paper does not have";
    }
  }
  EXPECT_GT(seen, 300U) << "there are fewer citations than there should be";
}

TEST(PaperCitations, NoOtherNumbersAreUsed) {
  EXPECT_EQ(foreign_numbers_in("see S2.11, IDS1.5 and S4.2"), (std::vector<std::string>{"S2.11"}));
  for (const std::string& path : repository_files()) {
    if (path == kThisFile) continue;
    const std::string text = read(path);
    if (!is_text(text)) continue;
    for (const std::string& number : foreign_numbers_in(text))
      ADD_FAILURE() << path << " says " << number << ": cite the paper and its section";
  }
}

// docs/papers.md.

const std::string kPage = "docs/papers.md";

/// What stands between backticks.
std::vector<std::string> quoted_in(const std::string& page) {
  std::vector<std::string> out;
  const std::regex pattern("`([^`\n]+)`");
  for (std::sregex_iterator found(page.begin(), page.end(), pattern), end; found != end; ++found)
    out.push_back((*found)[1]);
  return out;
}

/// A file of the repository, and what it has to define or contain; empty: nothing in particular.
struct Place {
  std::string file;
  std::string name;
};

/// "src/tramline/a/b.cpp:f" and "tools/a.py"; nullopt for options, words and formulas.
std::optional<Place> place_of(const std::string& quoted) {
  static const std::regex pattern(
      "((?:src|include|apps|tests|bench|tools|docs|web|fuzz)/[A-Za-z0-9_/.\\-]*[a-z])(?::([A-Za-z_0-9:]+))?");
  std::smatch found;
  if (!std::regex_match(quoted, found, pattern)) return std::nullopt;
  return Place{found[1], found[2]};
}

bool has_identifier(const std::string& code, const std::string& name) {
  for (std::size_t at = code.find(name); at != std::string::npos; at = code.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !part_of_word(code[at - 1])) && (end >= code.size() || !part_of_word(code[end])))
      return true;
  }
  return false;
}

TEST(PapersPage, PlacesAreFoundInIt) {
  ASSERT_TRUE(place_of("src/tramline/a/b.cpp:f"));
  EXPECT_EQ(place_of("src/tramline/a/b.cpp:A::f")->name, "A::f");
  EXPECT_EQ(place_of("tools/findings.py")->name, "");
  EXPECT_FALSE(place_of("--end-rule centre"));
  EXPECT_FALSE(place_of("tramline evaluate"));
  EXPECT_TRUE(has_identifier("int f(int);", "f"));
  EXPECT_FALSE(has_identifier("int of(int);", "f"));
}

TEST(PapersPage, NamesFilesAndFunctionsThatExist) {
  const std::vector<std::string> files = repository_files();
  std::size_t functions = 0;
  for (const std::string& quoted : quoted_in(read(kPage))) {
    const std::optional<Place> place = place_of(quoted);
    if (!place) continue;
    const bool file = std::binary_search(files.begin(), files.end(), place->file);
    const bool folder = std::any_of(files.begin(), files.end(), [&](const std::string& path) {
      return path.starts_with(place->file + "/");
    });
    EXPECT_TRUE(file || (folder && place->name.empty()))
        << kPage << " names " << place->file << ", which does not exist";
    if (!file || place->name.empty()) continue;
    ++functions;
    const std::string text = read(place->file);
    const bool cpp = place->file.ends_with(".cpp") || place->file.ends_with(".h");
    EXPECT_TRUE(has_identifier(cpp ? plain_code(text) : text, place->name))
        << kPage << " names " << place->name << ", which is not in " << place->file;
  }
  EXPECT_GT(functions, 100U) << "there are fewer names than there should be";
}

TEST(PapersPage, HasNothingLeftToFill) {
  const std::string page = read(kPage);
  std::size_t left = 0;
  for (std::size_t at = page.find("TODO-FILL"); at != std::string::npos; at = page.find("TODO-FILL", at + 1))
    ++left;
  EXPECT_EQ(left, 0U) << kPage << " has places still to be named";
}

/// The cells of a row of a table, without the spaces around them.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> out;
  std::size_t from = 1;
  for (std::size_t to = line.find('|', from); to != std::string::npos; to = line.find('|', from)) {
    std::string cell = line.substr(from, to - from);
    cell.erase(0, cell.find_first_not_of(' '));
    cell.erase(cell.find_last_not_of(' ') + 1);
    out.push_back(std::move(cell));
    from = to + 1;
  }
  return out;
}

TEST(PapersPage, EveryRowHasOneOfTheStates) {
  const std::set<std::string> states = {"as printed", "our reading", "better", "later", "missing"};
  const std::string page = read(kPage);
  std::size_t rows = 0;
  for (std::size_t from = 0; from < page.size();) {
    const std::size_t to = std::min(page.find('\n', from), page.size());
    const std::string line = page.substr(from, to - from);
    from = to + 1;
    const bool row = std::any_of(papers().begin(), papers().end(), [&](const auto& named) {
      return line.starts_with("| " + named.first + " ");
    });
    if (!row) continue;
    ++rows;
    const std::vector<std::string> cells = cells_of(line);
    ASSERT_EQ(cells.size(), 6U) << line;
    EXPECT_EQ(states.count(cells.back()), 1U) << line;
    EXPECT_FALSE(citations_in(cells.front()).empty()) << "the first cell cites no place: " << line;
    EXPECT_TRUE(cells[2].find('`') != std::string::npos || cells.back() == "later" ||
                cells.back() == "missing")
        << "it says not where it is done: " << line;
  }
  EXPECT_GE(rows, 100U);
}

}  // namespace tramline::architecture::paper_citations_test
