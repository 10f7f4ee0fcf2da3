#include "architecture/bool_parameters.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

#include "architecture/plain_code.h"

namespace tramline::architecture {
namespace {

constexpr std::size_t kNowhere = std::string_view::npos;

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool says(const std::string& text, const char* pattern) {
  return std::regex_search(text, std::regex(pattern));
}

/// How deep a place lies in brackets. Those of templates count as such; comparisons and shifts are rare in
/// declarations, and stand in parentheses where they have to.
class Nesting {
 public:
  void pass(std::string_view text, std::size_t at) {
    const char c = text[at];
    const char before = at > 0 ? text[at - 1] : ' ';
    if (c == '(' || c == '[' || c == '{' || c == '<') ++depth_;
    if (c == ')' || c == ']' || c == '}' || (c == '>' && before != '-')) --depth_;
  }
  bool outside() const { return depth_ == 0; }

 private:
  int depth_ = 0;
};

std::size_t closing(std::string_view text, std::size_t open) {
  Nesting nesting;
  for (std::size_t at = open; at < text.size(); ++at) {
    nesting.pass(text, at);
    if (nesting.outside()) return at;
  }
  return kNowhere;
}

std::string word_before(std::string_view text, std::size_t end) {
  while (end > 0 && std::isspace(static_cast<unsigned char>(text[end - 1])) != 0) --end;
  std::size_t begin = end;
  while (begin > 0 && is_word(text[begin - 1])) --begin;
  return std::string(text.substr(begin, end - begin));
}

/// Where the list of parameters of a declaration opens; nowhere in one that declares no function.
std::size_t parameter_list(std::string_view declaration) {
  static const std::set<std::string> kNoNames = {"alignas", "decltype", "explicit", "noexcept", "requires"};
  Nesting nesting;
  for (std::size_t at = 0; at < declaration.size(); ++at) {
    const char c = declaration[at];
    if (nesting.outside() && c == '=') return kNowhere;
    if (nesting.outside() && c == '(') {
      const std::string name = word_before(declaration, at);
      if (!kNoNames.contains(name)) return name.empty() ? kNowhere : at;
      at = closing(declaration, at);
      if (at == kNowhere) return kNowhere;
      continue;
    }
    nesting.pass(declaration, at);
  }
  return kNowhere;
}

/// Appends the parameters of one declaration that begins at line `line`.
void append_parameters(const std::string& declaration, int line, std::vector<BoolParameter>& out) {
  static const std::regex bare(
      R"(^\s*(?:\[\[\w+\]\]\s*)?(?:const\s+)?bool\b(?:\s+const\b)?\s*(\w*)\s*(?:=[^]*)?$)");
  if (says(declaration, R"(\boperator\b|\boverride\b)")) return;
  const std::size_t open = parameter_list(declaration);
  if (open == kNowhere) return;
  const std::size_t end = std::min(closing(declaration, open), declaration.size());
  Nesting nesting;
  std::size_t begin = open + 1;
  for (std::size_t at = begin; at <= end; ++at) {
    if (at < end && !(nesting.outside() && declaration[at] == ',')) {
      nesting.pass(declaration, at);
      continue;
    }
    const std::string parameter = declaration.substr(begin, at - begin);
    std::smatch match;
    if (std::regex_match(parameter, match, bare)) {
      const std::size_t word = begin + parameter.find_first_not_of(" \n\t");
      const auto lines =
          std::count(declaration.begin(), declaration.begin() + static_cast<std::ptrdiff_t>(word), '\n');
      out.push_back({line + static_cast<int>(lines), word_before(declaration, open), match[1]});
    }
    begin = at + 1;
  }
}

/// What stands between two braces, and whether those who include the header may call what it declares.
struct Scope {
  bool declares = false;   ///< a namespace or a class: no body of a function, no list
  bool accessible = true;  ///< as it stands now, in a class that has said private:
  bool enclosed_accessible = true;
};

/// The scope that opens behind `head`, within one that is `outer`.
Scope scope_behind(const std::string& head, const Scope& outer) {
  const std::string plain = std::regex_replace(head, std::regex(R"(\btemplate\s*<[^{}()]*>)"), "");
  const bool open = outer.declares && outer.accessible;
  if (says(plain, R"(^\s*(inline\s+)?namespace\b)")) return {true, open, open};
  if (says(plain, R"(^\s*(struct|union)\b[^()=]*$)")) return {true, open, open};
  if (says(plain, R"(^\s*class\b[^()=]*$)")) return {true, false, open};
  return {};
}

/// Whether `head` is the label before a part of a class, and if so whether that part is public.
std::optional<bool> label(const std::string& head) {
  std::smatch match;
  if (!std::regex_match(head, match, std::regex(R"(\s*(public|protected|private)\s*)"))) return std::nullopt;
  return match[1] == "public";
}

/// Walks over the declarations of a header.
class Declarations {
 public:
  std::vector<BoolParameter> in(const std::string& header) {
    for (const char c : plain_code(header)) {
      if (c == '(') ++parentheses_;
      if (c == ')') --parentheses_;
      if (parentheses_ > 0 || !ends_declaration(c)) {
        if (head_.empty()) head_line_ = line_;
        head_ += c;
      }
      if (c == '\n') ++line_;
    }
    return std::move(found_);
  }

 private:
  /// Whether the sign, outside parentheses, ends what head_ holds; does then what follows from it.
  bool ends_declaration(char c) {
    Scope& scope = scopes_.back();
    if (c == ':') {
      const std::optional<bool> now_public = label(head_);
      if (!now_public) return false;
      scope.accessible = *now_public && scope.enclosed_accessible;
    } else if (c == '{') {
      const Scope inner = scope_behind(head_, scope);
      if (!inner.declares) judge(scope);
      scopes_.push_back(inner);
    } else if (c == '}') {
      if (scopes_.size() > 1) scopes_.pop_back();
    } else if (c == ';') {
      judge(scope);
    } else {
      return false;
    }
    head_.clear();
    return true;
  }

  void judge(const Scope& scope) {
    if (scope.declares && scope.accessible) append_parameters(head_, head_line_, found_);
  }

  std::vector<Scope> scopes_{{true, true, true}};
  std::string head_;  ///< of the declaration so far
  int line_ = 1, head_line_ = 1;
  int parentheses_ = 0;
  std::vector<BoolParameter> found_;
};

}  // namespace

std::vector<BoolParameter> bool_parameters(const std::string& header) { return Declarations().in(header); }

}  // namespace tramline::architecture
