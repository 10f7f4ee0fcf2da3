#include "tramline/io/isoxml/part_states.h"

#include <algorithm>
#include <cstdint>

namespace tramline::io {
namespace {

constexpr std::size_t kSectionsInOne = 16;
constexpr unsigned kBitsOfAll = 32;

unsigned condensed_bits(std::int64_t value, std::size_t place) {
  return static_cast<std::uint32_t>(value) >> (2 * (place % kSectionsInOne)) & 3U;
}

}  // namespace

PartStates::PartStates(const DeviceTree& tree, const LoggedValues& values) : tree_(tree), values_(values) {
  for (std::size_t i = 0; i < tree.size(); ++i)
    if (values.has_condensed_states(i)) condensed_.push_back({i, numbered(i)});
}

std::vector<std::size_t> PartStates::numbered(std::size_t element) const {
  for (const unsigned kind : {element_kind::kSection, element_kind::kUnit})
    for (const bool own : {true, false}) {
      std::vector<std::size_t> out;
      for (std::size_t i = 0; i < tree_.size(); ++i)
        if (tree_[i].type == kind && tree_[i].device == tree_[element].device &&
            (!own || tree_.is_within(i, element)))
          out.push_back(i);
      std::stable_sort(out.begin(), out.end(),
                       [&](std::size_t a, std::size_t b) { return tree_[a].number < tree_[b].number; });
      if (!out.empty()) return out;
    }
  return {};
}

std::vector<StateSource> PartStates::sources_of(std::size_t element) const {
  std::vector<StateSource> out;
  for (const std::size_t at : tree_.path_to_root(element)) {
    if (values_.is_logged(at, ddi::kWorkState)) out.push_back({at, StateSource::Kind::kWorkState, 0});
    for (const Condensed& condensed : condensed_) {
      const auto place = std::find(condensed.numbered.begin(), condensed.numbered.end(), at);
      if (place != condensed.numbered.end())
        out.push_back({condensed.element, StateSource::Kind::kCondensed,
                       static_cast<std::size_t>(place - condensed.numbered.begin())});
      else if (condensed.numbered.empty() && condensed.element == at)
        out.push_back({at, StateSource::Kind::kAnyCondensed, 0});
    }
  }
  return out;
}

std::optional<bool> PartStates::state(const StateSource& source) const {
  if (source.kind == StateSource::Kind::kWorkState) {
    const auto value = values_.logged(source.element, ddi::kWorkState);
    if (!value) return std::nullopt;
    const unsigned type = tree_[source.element].type;
    // An error of a section is a section that does not work; of the machine, nothing is known.
    if (type == element_kind::kSection || type == element_kind::kUnit) return *value == 1;
    return *value == 0 || *value == 1 ? std::optional(*value == 1) : std::nullopt;
  }
  if (source.kind == StateSource::Kind::kCondensed) {
    const unsigned identifier = ddi::kFirstCondensed + static_cast<unsigned>(source.place / kSectionsInOne);
    const auto value = values_.logged(source.element, identifier);
    return value ? std::optional(condensed_bits(*value, source.place) == 1) : std::nullopt;
  }
  std::optional<bool> any;
  for (unsigned i = ddi::kFirstCondensed; i <= ddi::kLastCondensed; ++i)
    if (const auto value = values_.logged(source.element, i))
      for (unsigned place = 0; 2 * place < kBitsOfAll; ++place)
        any = any.value_or(false) || condensed_bits(*value, place) == 1;
  return any;
}

std::optional<bool> PartStates::state(const std::vector<StateSource>& sources) const {
  std::optional<bool> out;
  for (const StateSource& source : sources)
    if (const auto on = state(source)) out = out.value_or(true) && *on;
  return out;
}

}  // namespace tramline::io
