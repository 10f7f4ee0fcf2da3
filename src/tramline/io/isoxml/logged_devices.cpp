#include "tramline/io/isoxml/logged_devices.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "tramline/io/isoxml/device_tree.h"

namespace tramline::io {
namespace {

bool tells_of_work(unsigned identifier) {
  return identifier == ddi::kActualWidth || identifier == ddi::kWorkState ||
         (identifier >= ddi::kFirstCondensed && identifier <= ddi::kLastCondensed);
}

bool describes_width(const DeviceElement& element) {
  for (const unsigned identifier : {ddi::kActualWidth, ddi::kMostWidth, ddi::kDefaultWidth}) {
    const auto at = element.properties.find(identifier);
    if (at != element.properties.end() && at->second > 0) return true;
  }
  return false;
}

std::string shown(const std::string& device) {
  return device.empty() ? "the one that is not described" : device;
}

class Telling {
 public:
  Telling(const TimeLogHeader& header, const std::vector<DeviceElement>& elements) {
    for (const DeviceElement& element : elements) {
      devices_.emplace(element.id, element.device);
      if (describes_width(element)) wide_.insert(element.device);
    }
    for (const LoggedValue& logged : header.values) {
      if (!tells_of_work(logged.ddi)) continue;
      const std::string device = device_of(logged.element);
      if (logged.ddi == ddi::kActualWidth)
        wide_.insert(device);
      else
        with_states_.insert(device);
      if (counts_[device]++ == 0) order_.push_back(device);
    }
  }

  bool described(const std::string& element) const { return devices_.contains(element); }
  const std::vector<std::string>& in_order() const { return order_; }

  std::vector<std::string> that_count() const {
    std::vector<std::string> out;
    for (const std::string& device : order_)
      if (wide_.contains(device)) out.push_back(device);
    if (out.empty() && !order_.empty())
      out.push_back(*std::max_element(order_.begin(), order_.end(), [&](const auto& a, const auto& b) {
        return counts_.at(a) < counts_.at(b);
      }));
    return out;
  }

  /// One that tells when the others work, which are silent on it; nullopt where they are not.
  std::optional<std::string> that_switches(const std::vector<std::string>& others) const {
    for (const std::string& device : others)
      if (with_states_.contains(device)) return std::nullopt;
    for (const std::string& device : order_)
      if (with_states_.contains(device)) return device;
    return std::nullopt;
  }

 private:
  std::string device_of(const std::string& element) const {
    const auto at = devices_.find(element);
    return at == devices_.end() ? std::string() : at->second;
  }

  std::map<std::string, std::string> devices_;  ///< of each element
  std::map<std::string, std::size_t> counts_;
  std::set<std::string> wide_, with_states_;
  std::vector<std::string> order_;
};

/// Elements of the header that no device has, each as often as it is there: once.
std::vector<DeviceElement> undescribed(const TimeLogHeader& header, const Telling& telling) {
  std::vector<DeviceElement> out;
  std::set<std::string> seen;
  for (const LoggedValue& logged : header.values) {
    if (telling.described(logged.element) || !seen.insert(logged.element).second) continue;
    DeviceElement element;
    element.id = logged.element;
    element.type = element_kind::kDevice;
    element.object = static_cast<long long>(out.size()) + 1;
    out.push_back(std::move(element));
  }
  return out;
}

}  // namespace

LoggedDevices logged_devices(const TimeLogHeader& header, const std::vector<DeviceElement>& elements) {
  const Telling telling(header, elements);
  LoggedDevices out;
  out.devices = telling.that_count();
  std::vector<std::string> counting;
  for (const std::string& device : out.devices) counting.push_back(shown(device));
  if (const auto device = telling.that_switches(out.devices)) {
    out.devices.push_back(*device);
    out.notes.push_back(fmt::format("{} tells when {} works", shown(*device), fmt::join(counting, ", ")));
  } else if (telling.in_order().size() > 1) {
    out.notes.push_back(out.devices.size() == 1
                            ? fmt::format("several devices tell what worked; {} counts", counting.front())
                            : fmt::format("several devices tell what worked; the ground of each counts: {}",
                                          fmt::join(counting, ", ")));
  }
  for (const std::string& device : out.devices) {
    if (device.empty()) {
      for (DeviceElement& element : undescribed(header, telling)) out.elements.push_back(std::move(element));
      out.notes.emplace_back("the device is not described; logged widths without offsets are centred on it");
    }
    for (const DeviceElement& element : elements)
      if (element.device == device) out.elements.push_back(element);
  }
  return out;
}

}  // namespace tramline::io
