#include "tramline/io/isoxml/task_data.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <pugixml.hpp>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/fixes/xml_budget.h"
#include "tramline/io/isoxml/guidance_lines.h"
#include "tramline/io/isoxml/partfield_rings.h"

namespace tramline::io {
namespace {

constexpr std::size_t kMostExternalFiles = 10000;

std::unique_ptr<pugi::xml_document> parse(std::string_view xml, const std::string& place) {
  require_bounded_xml(xml, place);
  auto document = std::make_unique<pugi::xml_document>();
  const pugi::xml_parse_result parsed = document->load_buffer(xml.data(), xml.size());
  if (!parsed)
    throw bad_input(fmt::format("{} is damaged XML at byte {} ({}); fetch or export it again", place,
                                parsed.offset, parsed.description()));
  return document;
}

long long number(const pugi::xml_attribute& attribute) { return digits_in(attribute.value()).value_or(0); }

unsigned identifier(const pugi::xml_attribute& attribute) {
  const std::string_view text = attribute.value();
  unsigned out = 0;
  std::from_chars(text.data(), text.data() + text.size(), out, 16);
  return out;
}

/// Of a DPT: a signed number of 32 bits (ISO 11783-10). A number that does not fit is ignored.
std::optional<long long> property_value(const pugi::xml_attribute& attribute) {
  const std::optional<double> value = number_in(attribute.value());
  if (!value || !(std::abs(*value) <= 2147483648.0)) return std::nullopt;
  return static_cast<long long>(*value);
}

void read_device(const pugi::xml_node& device, TaskData& out) {
  out.device_names[device.attribute("A").value()] = device.attribute("B").value();
  struct Property {
    unsigned ddi;
    long long value;
  };
  std::map<long long, Property> properties;
  for (const pugi::xml_node property : device.children("DPT"))
    if (const std::optional<long long> value = property_value(property.attribute("C")))
      properties[number(property.attribute("A"))] = {identifier(property.attribute("B")), *value};
  for (const pugi::xml_node node : device.children("DET")) {
    DeviceElement element;
    element.id = node.attribute("A").value();
    element.device = device.attribute("A").value();
    element.object = number(node.attribute("B"));
    element.type = static_cast<unsigned>(number(node.attribute("C")));
    element.number = number(node.attribute("E"));
    element.parent = number(node.attribute("F"));
    for (const pugi::xml_node reference : node.children("DOR"))
      if (const auto at = properties.find(number(reference.attribute("A"))); at != properties.end())
        element.properties[at->second.ddi] = at->second.value;
    out.elements.push_back(std::move(element));
  }
}

void read_task(const pugi::xml_node& task, TaskData& out) {
  for (const pugi::xml_node log : task.children("TLG"))
    out.logs.push_back({log.attribute("A").value(), task.attribute("A").value(), task.attribute("B").value(),
                        task.attribute("E").value()});
}

void read_top_level(const pugi::xml_node& root, const std::string& file, TaskData& out) {
  for (const pugi::xml_node node : root.children()) {
    const std::string_view name = node.name();
    if (name == "DVC") read_device(node, out);
    if (name == "TSK") read_task(node, out);
    if (name != "PFD") continue;
    add_partfield(node, file, out.partfields);
    add_guidance(node, file, out.guidance);
  }
}

/// Empty layers say nothing.
void drop_empty_layers(RawDataset& dataset) {
  std::erase_if(dataset.layers, [](const RawLayer& layer) { return layer.features.empty(); });
  for (RawLayer& layer : dataset.layers) layer.matching = std::ssize(layer.features);
}

}  // namespace

TaskData parse_task_data(std::string_view xml, const ExternalFile& external, const std::string& path) {
  TaskData out;
  out.partfields = empty_partfields(path);
  out.guidance = empty_guidance(path);
  const std::string place = fmt::format("'{}'", path);
  const auto document = parse(xml, place + ": TASKDATA.XML");
  const pugi::xml_node root = document->child("ISO11783_TaskData");
  if (!root) throw bad_input(fmt::format("{} is not ISOXML: it has no element ISO11783_TaskData", place));
  read_top_level(root, path, out);
  std::size_t count = 0;
  for (const pugi::xml_node reference : root.children("XFR")) {
    const std::string name = std::string(reference.attribute("A").value()) + ".XML";
    if (++count > kMostExternalFiles)
      throw bad_input(fmt::format("{} names more than {} external files", place, kMostExternalFiles));
    const auto text = external(name);
    if (!text)
      throw bad_input(fmt::format("{} names the external file {}, which is missing beside it", place, name));
    const auto part = parse(*text, place + ": " + name);
    read_top_level(part->first_child(), path, out);
  }
  drop_empty_layers(out.partfields);
  drop_empty_layers(out.guidance);
  return out;
}

TaskData read_task_data(const TaskFiles& files) {
  const auto xml = files.read("TASKDATA.XML");
  if (!xml) return {};
  return parse_task_data(
      *xml, [&](const std::string& name) { return files.read(name); }, files.path());
}

}  // namespace tramline::io
