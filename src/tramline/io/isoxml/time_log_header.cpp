#include "tramline/io/isoxml/time_log_header.h"

#include <fmt/format.h>

#include <charconv>
#include <pugixml.hpp>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/fixes/xml_budget.h"

namespace tramline::io {
namespace {

constexpr std::array kPartNames = {"A", "B", "C", "D", "E", "F", "G", "H", "I"};
// A record numbers its values with one byte.
constexpr std::size_t kMostValues = 255;

unsigned hexadecimal(std::string_view text, const std::string& place) {
  unsigned out = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), out, 16);
  if (error != std::errc() || stop != text.data() + text.size())
    throw bad_input(fmt::format("{}: '{}' is not a data dictionary identifier", place, text.substr(0, 20)));
  return out;
}

void read_position(const pugi::xml_node& position, TimeLogHeader& header) {
  header.has_position = true;
  for (std::size_t i = 0; i < kPositionParts; ++i) {
    const pugi::xml_attribute part = position.attribute(kPartNames[i]);
    header.in_record[i] = part && *part.value() == '\0';
  }
  header.fixed_lat_deg = number_in(position.attribute("A").value());
  header.fixed_lon_deg = number_in(position.attribute("B").value());
}

}  // namespace

TimeLogHeader read_time_log_header(std::string_view xml, const std::string& place) {
  require_bounded_xml(xml, place);
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
  if (!parsed)
    throw bad_input(
        fmt::format("{} is damaged XML at byte {} ({})", place, parsed.offset, parsed.description()));
  // Some wrap the element, against the standard.
  pugi::xml_node time = document.child("TIM");
  if (!time) time = document.first_child().child("TIM");
  if (!time) throw bad_input(fmt::format("{} has no element TIM: it is not the header of a time log", place));
  const pugi::xml_attribute start = time.attribute("A");
  if (!start || *start.value() != '\0')
    throw bad_input(
        fmt::format("{} leaves the times out of the records (TIM has no empty attribute A)", place));
  TimeLogHeader header;
  if (const pugi::xml_node position = time.child("PTN")) read_position(position, header);
  for (const pugi::xml_node value : time.children("DLV")) {
    LoggedValue logged;
    logged.ddi = hexadecimal(value.attribute("A").value(), place);
    logged.element = value.attribute("C").value();
    logged.fixed = digits_in(value.attribute("B").value());
    header.values.push_back(std::move(logged));
    if (header.values.size() > kMostValues)
      throw bad_input(
          fmt::format("{} lists more than {} values; a record cannot hold as many", place, kMostValues));
  }
  return header;
}

}  // namespace tramline::io
