#include "tramline/model/front.h"

#include <algorithm>
#include <array>

namespace tramline {
namespace {

struct Mark {
  std::size_t FrontMarks::*index;
  const char* word;
};

constexpr std::array<Mark, 5> kMarks = {{{&FrontMarks::given_prices, "given prices"},
                                         {&FrontMarks::knee, "knee"},
                                         {&FrontMarks::least_overlap, "least overlap"},
                                         {&FrontMarks::least_uncovered, "least uncovered"},
                                         {&FrontMarks::fewest_turns, "fewest turns and stops"}}};

}  // namespace

std::vector<const char*> marks_of(const Front& front, std::size_t point) {
  std::vector<const char*> out;
  for (const Mark& mark : kMarks)
    if (front.marks.*mark.index == point) out.push_back(mark.word);
  return out;
}

std::size_t* mark_named(FrontMarks& marks, std::string_view word) {
  for (const Mark& mark : kMarks)
    if (word == mark.word) return &(marks.*mark.index);
  return nullptr;
}

std::vector<std::size_t> marked_points(const Front& front) {
  std::vector<std::size_t> out;
  if (front.points.empty()) return out;
  for (const Mark& mark : kMarks) out.push_back(front.marks.*mark.index);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace tramline
