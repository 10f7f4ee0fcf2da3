#include "tramline/io/isoxml/logged_values.h"

#include <string>

namespace tramline::io {
namespace {

bool is_place(unsigned identifier) {
  using namespace ddi;
  return identifier == kActualWidth || identifier == kDefaultWidth || identifier == kMostWidth ||
         identifier == kOffsetX || identifier == kOffsetY;
}

bool is_condensed(unsigned identifier) {
  return identifier >= ddi::kFirstCondensed && identifier <= ddi::kLastCondensed;
}

bool is_state(unsigned identifier) { return identifier == ddi::kWorkState || is_condensed(identifier); }

}  // namespace

LoggedValues::LoggedValues(const TimeLogHeader& header, const DeviceTree& tree) : tree_(tree) {
  std::map<std::string, std::size_t> by_id;
  for (std::size_t i = 0; i < tree.size(); ++i) by_id.emplace(tree[i].id, i);
  for (const LoggedValue& logged : header.values) {
    keys_.emplace_back();
    fixed_.push_back(logged.fixed.has_value());
    const auto at = by_id.find(logged.element);
    if (at == by_id.end() || !(is_place(logged.ddi) || is_state(logged.ddi))) continue;
    keys_.back() = Key{at->second, logged.ddi};
    auto& value = logged_[*keys_.back()];
    if (logged.fixed) value = *logged.fixed;
  }
}

LoggedValues::Change LoggedValues::update(const TimeLogRecord& record) {
  Change out;
  for (const auto& [index, value] : record.values) {
    if (fixed_[index] || !keys_[index]) continue;
    auto& known = logged_[*keys_[index]];
    if (known == value) continue;
    known = value;
    out.places = out.places || is_place(keys_[index]->second);
    out.states = out.states || is_state(keys_[index]->second);
  }
  return out;
}

bool LoggedValues::has_condensed_states(std::size_t element) const {
  const auto at = logged_.lower_bound({element, ddi::kFirstCondensed});
  return at != logged_.end() && at->first.first == element && is_condensed(at->first.second);
}

std::optional<std::int64_t> LoggedValues::logged(std::size_t element, unsigned identifier) const {
  const auto at = logged_.find({element, identifier});
  return at == logged_.end() ? std::nullopt : at->second;
}

std::optional<std::int64_t> LoggedValues::value(std::size_t element, unsigned identifier) const {
  if (const auto as_logged = logged(element, identifier)) return as_logged;
  const auto& properties = tree_[element].properties;
  const auto at = properties.find(identifier);
  return at == properties.end() ? std::nullopt : std::optional<std::int64_t>(at->second);
}

}  // namespace tramline::io
