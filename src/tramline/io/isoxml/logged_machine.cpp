#include "tramline/io/isoxml/logged_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tramline::io {
namespace {

constexpr unsigned kDevice = 1, kSection = 4;
constexpr unsigned kSectionsInOne = 16;
constexpr double kMillimetre = 1e-3;
constexpr double kWidest_m = 500;

/// Of the values that describe() looks at.
bool is_read(unsigned identifier) {
  using namespace ddi;
  return identifier == kActualWidth || identifier == kDefaultWidth || identifier == kMostWidth ||
         identifier == kOffsetY || identifier == kWorkState ||
         (identifier >= kFirstCondensed && identifier <= kLastCondensed);
}

bool is_rate(unsigned identifier) {
  return identifier == ddi::kVolumeRate || identifier == ddi::kMassRate || identifier == ddi::kCountRate;
}

/// To amounts a hectare: ISO 11783-11 has 0.01 mm³/m², 1 mg/m² and 0.001 pieces/m².
double rate_factor(unsigned identifier) {
  if (identifier == ddi::kVolumeRate) return 1e-4;
  return identifier == ddi::kMassRate ? 0.01 : 10;
}

bool tells_of_work(unsigned identifier) {
  return identifier == ddi::kActualWidth || identifier == ddi::kWorkState ||
         (identifier >= ddi::kFirstCondensed && identifier <= ddi::kLastCondensed);
}

}  // namespace

LoggedMachine::LoggedMachine(const TimeLogHeader& header, const std::vector<DeviceElement>& elements)
    : header_(header) {
  choose_device(elements);
  choose_elements();
  choose_rate();
  for (const LoggedValue& logged : header_.values)
    if (logged.fixed) values_[{logged.element, logged.ddi}] = *logged.fixed;
}

bool LoggedMachine::is_logged(const std::string& element, unsigned identifier) const {
  return std::any_of(header_.values.begin(), header_.values.end(), [&](const LoggedValue& logged) {
    return logged.element == element && logged.ddi == identifier;
  });
}

/// Elements that no device describes stand for themselves.
void LoggedMachine::choose_device(const std::vector<DeviceElement>& elements) {
  std::map<std::string, std::size_t> telling;
  std::map<std::string, const DeviceElement*> by_id;
  for (const DeviceElement& element : elements) by_id.emplace(element.id, &element);
  std::vector<std::string> order;
  for (const LoggedValue& logged : header_.values) {
    if (!tells_of_work(logged.ddi)) continue;
    const auto at = by_id.find(logged.element);
    const std::string device = at == by_id.end() ? std::string() : at->second->device;
    if (telling[device]++ == 0) order.push_back(device);
  }
  if (order.empty()) return;
  const std::string chosen = *std::max_element(
      order.begin(), order.end(), [&](const auto& a, const auto& b) { return telling[a] < telling[b]; });
  if (order.size() > 1)
    notes_.push_back(fmt::format("several devices tell what worked; {} counts",
                                 chosen.empty() ? "the one that is not described" : chosen));
  for (const DeviceElement& element : elements)
    if (element.device == chosen) elements_.push_back(element);
  if (!chosen.empty()) return;
  elements_.clear();
  for (const LoggedValue& logged : header_.values) {
    const bool known = by_id.contains(logged.element) ||
                       std::any_of(elements_.begin(), elements_.end(),
                                   [&](const DeviceElement& other) { return other.id == logged.element; });
    if (known) continue;
    DeviceElement element;
    element.id = logged.element;
    element.type = kDevice;
    elements_.push_back(std::move(element));
  }
  notes_.emplace_back(
      "the device is not described: the first width that is logged counts, in the middle of it");
}

void LoggedMachine::choose_elements() {
  bool condensed = false, of_sections = false;
  for (const DeviceElement& element : elements_) {
    for (unsigned i = ddi::kFirstCondensed; i <= ddi::kLastCondensed; ++i)
      condensed = condensed || is_logged(element.id, i);
    if (element.type != kSection) continue;
    sections_.push_back(element);
    of_sections =
        of_sections || is_logged(element.id, ddi::kWorkState) || is_logged(element.id, ddi::kActualWidth);
  }
  std::stable_sort(sections_.begin(), sections_.end(),
                   [](const DeviceElement& a, const DeviceElement& b) { return a.number < b.number; });
  if (sections_.size() > kMostSections) sections_.resize(kMostSections);
  if (!condensed && !of_sections) sections_.clear();
  const auto find_whole = [&](unsigned identifier, bool logged) {
    for (const DeviceElement& element : elements_) {
      if (whole_ || element.type == kSection) continue;
      if (logged ? is_logged(element.id, identifier) : element.properties.contains(identifier))
        whole_ = element;
    }
  };
  find_whole(ddi::kActualWidth, true);
  for (const unsigned identifier : {ddi::kActualWidth, ddi::kMostWidth, ddi::kDefaultWidth})
    find_whole(identifier, false);
}

void LoggedMachine::choose_rate() {
  std::size_t rates = 0;
  for (const LoggedValue& logged : header_.values) {
    const bool of_device = elements_.empty() ||
                           std::any_of(elements_.begin(), elements_.end(), [&](const DeviceElement& element) {
                             return element.id == logged.element;
                           });
    if (!of_device || !is_rate(logged.ddi)) continue;
    if (!rate_) rate_ = Key{logged.element, logged.ddi};
    ++rates;
  }
  if (rates > 1)
    notes_.push_back(fmt::format("{} applied rates are logged: that of {} counts", rates, rate_->first));
}

AmountUnit LoggedMachine::rate_unit() const {
  if (!rate_) return AmountUnit::kUnknown;
  if (rate_->second == ddi::kVolumeRate) return AmountUnit::kLitres;
  return rate_->second == ddi::kMassRate ? AmountUnit::kKilograms : AmountUnit::kSeeds;
}

double LoggedMachine::rate_per_ha() const {
  const auto at = rate_ ? values_.find(*rate_) : values_.end();
  if (at == values_.end() || at->second < 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(at->second) * rate_factor(rate_->second);
}

void LoggedMachine::update(const TimeLogRecord& record) {
  for (const auto& [index, value] : record.values) {
    const LoggedValue& logged = header_.values[index];
    if (!logged.fixed && is_rate(logged.ddi)) values_[{logged.element, logged.ddi}] = value;
    if (logged.fixed || !is_read(logged.ddi)) continue;
    const auto [at, is_new] = values_.try_emplace({logged.element, logged.ddi}, value);
    if (!is_new && at->second == value) continue;
    at->second = value;
    described_.reset();
  }
}

std::optional<std::int64_t> LoggedMachine::value(const DeviceElement& element, unsigned identifier) const {
  if (const auto at = values_.find({element.id, identifier}); at != values_.end()) return at->second;
  if (const auto at = element.properties.find(identifier); at != element.properties.end()) return at->second;
  return std::nullopt;
}

std::optional<double> LoggedMachine::width_m(const DeviceElement& element) const {
  for (const unsigned identifier : {ddi::kActualWidth, ddi::kMostWidth, ddi::kDefaultWidth}) {
    const auto width = value(element, identifier);
    if (!width) continue;
    const double metres = static_cast<double>(*width) * kMillimetre;
    return metres >= 0 && metres <= kWidest_m ? std::optional(metres) : std::nullopt;
  }
  return std::nullopt;
}

WorkState LoggedMachine::master() const {
  for (const DeviceElement& element : elements_) {
    if (element.type == kSection) continue;
    const auto at = values_.find({element.id, ddi::kWorkState});
    if (at == values_.end()) continue;
    if (at->second == 0) return WorkState::kOff;
    if (at->second == 1) return WorkState::kOn;
    return WorkState::kUnknown;
  }
  return WorkState::kUnknown;
}

std::optional<bool> LoggedMachine::state_of_section(std::size_t section) const {
  if (const auto at = values_.find({sections_[section].id, ddi::kWorkState}); at != values_.end())
    return at->second == 1;
  const unsigned identifier = ddi::kFirstCondensed + static_cast<unsigned>(section) / kSectionsInOne;
  const unsigned shift = 2 * (static_cast<unsigned>(section) % kSectionsInOne);
  for (const DeviceElement& element : elements_)
    if (const auto at = values_.find({element.id, identifier}); at != values_.end())
      return (static_cast<std::uint32_t>(at->second) >> shift & 3U) == 1;
  return std::nullopt;
}

/// The sections from left to right; `order`: which of sections_ each is. Empty where widths are missing.
Boom LoggedMachine::boom_of_sections(std::vector<std::size_t>& order) const {
  order.resize(sections_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> widths, offsets;
  for (const DeviceElement& section : sections_) {
    const auto width = width_m(section);
    if (!width) return {};
    widths.push_back(*width);
    if (const auto offset = value(section, ddi::kOffsetY))
      offsets.push_back(static_cast<double>(*offset) * kMillimetre);
  }
  const bool all_on_one_place =
      std::adjacent_find(offsets.begin(), offsets.end(), std::not_equal_to<>()) == offsets.end();
  if (offsets.size() < sections_.size() || (sections_.size() > 1 && all_on_one_place))
    return side_by_side(widths);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return offsets[a] < offsets[b]; });
  Boom out;
  for (const std::size_t i : order)
    out.push_back({-offsets[i] + 0.5 * widths[i], -offsets[i] - 0.5 * widths[i]});
  return out;
}

void LoggedMachine::describe(Fix& fix, BoomList& booms) {
  if (!described_) describe_anew(described_.emplace(), booms);
  fix.work = described_->work;
  fix.boom = described_->boom;
  fix.has_sections = described_->has_sections;
  fix.sections = described_->sections;
  fix.rate_per_ha = rate_per_ha();
}

void LoggedMachine::describe_anew(Fix& fix, BoomList& booms) const {
  fix.work = master();
  bool any_known = false, any_on = false;
  std::vector<std::size_t> order;
  Boom boom = boom_of_sections(order);
  for (std::size_t place = 0; place < sections_.size(); ++place) {
    const auto on = state_of_section(order[place]);
    any_known = any_known || on.has_value();
    any_on = any_on || on.value_or(false);
    fix.sections[place] = on.value_or(false);
  }
  if (any_known && fix.work == WorkState::kUnknown) fix.work = any_on ? WorkState::kOn : WorkState::kOff;
  std::optional<double> whole_width_m;
  if (whole_) whole_width_m = width_m(*whole_);
  if (boom.empty() && whole_width_m && any_known) {
    // Sections without widths of their own share that of the machine.
    boom = side_by_side(
        std::vector<double>(sections_.size(), *whole_width_m / static_cast<double>(sections_.size())));
  }
  if (!boom.empty()) {
    fix.has_sections = any_known;
    fix.boom = booms.number_of(boom);
    return;
  }
  fix.sections.reset();
  if (!whole_width_m) return;
  boom = one_section(*whole_width_m);
  const double right_m = static_cast<double>(value(*whole_, ddi::kOffsetY).value_or(0)) * kMillimetre;
  for (Section& section : boom) section = {section.left_m - right_m, section.right_m - right_m};
  fix.boom = booms.number_of(boom);
}

}  // namespace tramline::io
