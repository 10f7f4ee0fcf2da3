#include "io/terminal/task_set_form.h"

#include <iterator>
#include <map>
#include <pugixml.hpp>
#include <regex>
#include <set>
#include <utility>

namespace tramline::testing_terminal {
namespace {

/// An attribute: what its value has to look like, and whether it has to be there. Of an id the form is that
/// of version 4, "PFD1" or "PFD-1"; a reference is to an id of that element.
struct Attribute {
  std::string form;
  bool required = false;
  std::string refers_to{};
};

struct Element {
  std::set<std::string> parents;
  std::map<std::string, Attribute> attributes;
};

const std::string kName = "[\\x20-\\x7E]{0,32}";
const std::string kNumber = "0|[1-9][0-9]{0,9}";
const std::string kDegrees = "-?[0-9]{1,3}\\.[0-9]{1,9}";

std::string id_of(const std::string& element) { return "(" + element + "|" + element + "-)[0-9]+"; }

/// ISO 11783-10, annex D, as far as fields and lines go. The words of version 3 are fewer.
std::map<std::string, Element> grammar(bool version4) {
  std::map<std::string, Element> out;
  out["ISO11783_TaskData"] = {{""},
                              {{"VersionMajor", {version4 ? "4" : "3", true}},
                               {"VersionMinor", {version4 ? "2" : "[0-3]", true}},
                               {"ManagementSoftwareManufacturer", {kName, true}},
                               {"ManagementSoftwareVersion", {kName, true}},
                               {"TaskControllerManufacturer", {kName}},
                               {"TaskControllerVersion", {kName}},
                               {"DataTransferOrigin", {"1", true}}}};
  out["CTR"] = {{"ISO11783_TaskData"}, {{"A", {id_of("CTR"), true}}, {"B", {kName, true}}}};
  out["FRM"] = {{"ISO11783_TaskData"},
                {{"A", {id_of("FRM"), true}}, {"B", {kName, true}}, {"I", {id_of("CTR"), false, "CTR"}}}};
  out["PFD"] = {{"ISO11783_TaskData"},
                {{"A", {id_of("PFD"), true}},
                 {"C", {kName, true}},
                 {"D", {kNumber, true}},
                 {"E", {id_of("CTR"), false, "CTR"}},
                 {"F", {id_of("FRM"), false, "FRM"}}}};
  out["TSK"] = {{"ISO11783_TaskData"},
                {{"A", {id_of("TSK"), true}},
                 {"B", {kName}},
                 {"C", {id_of("CTR"), false, "CTR"}},
                 {"D", {id_of("FRM"), false, "FRM"}},
                 {"E", {id_of("PFD"), false, "PFD"}},
                 {"G", {"[1-6]", true}}}};
  // No treatment zones (2): those belong to tasks. Version 3 has 1 to 8 only. A headland is 10 there too, as
  // readers of version 3 expect it.
  out["PLN"] = {{"PFD"},
                {{"A", {version4 ? "[13-9]|1[0-2]" : "[13-8]|10", true}}, {"B", {kName}}, {"C", {kNumber}}}};
  out["LSG"] = {{"PLN"}, {{"A", {version4 ? "[1-9]" : "[1-8]", true}}, {"B", {kName}}, {"C", {kNumber}}}};
  out["PNT"] = {
      {"LSG"},
      {{"A", {version4 ? "[1-9]|1[01]" : "[1-5]", true}}, {"C", {kDegrees, true}}, {"D", {kDegrees, true}}}};
  if (!version4) {
    out["LSG"].parents.insert("PFD");
    return out;
  }
  out["LSG"].parents.insert("GPN");
  out["GGP"] = {{"PFD"}, {{"A", {id_of("GGP"), true}}, {"B", {kName}}}};
  out["GPN"] = {{"GGP"},
                {{"A", {id_of("GPN"), true}},
                 {"B", {kName}},
                 {"C", {"[1-5]", true}},
                 {"E", {"[1-4]"}},
                 {"F", {"[1-4]"}},
                 {"G", {"([0-9]|[1-9][0-9]|[12][0-9]{2}|3[0-5][0-9])(\\.[0-9]+)?|360(\\.0+)?"}},
                 {"H", {kNumber}},
                 {"I", {"[0-8]|16|17"}}}};
  return out;
}

bool has_form(const std::string& text, const std::string& form) {
  static std::map<std::string, std::regex> made;
  return std::regex_match(text, made.try_emplace(form, form).first->second);
}

class Examination {
 public:
  explicit Examination(bool version4) : version4_(version4), grammar_(grammar(version4)) {}

  void look_at(const pugi::xml_node& node) {
    const auto known = grammar_.find(node.name());
    if (known == grammar_.end()) return say(node, "is not known to this version");
    if (known->second.parents.count(node.parent().name()) == 0)
      say(node, std::string("may not stand in ") + node.parent().name());
    look_at_attributes(node, known->second);
    const std::string name = node.name();
    if (name == "PLN") look_at_polygon(node);
    if (name == "LSG") look_at_line(node);
    if (name == "GGP" && std::distance(node.children("GPN").begin(), node.children("GPN").end()) != 1)
      say(node, "does not hold one pattern");
    if (name == "GPN" && std::distance(node.children("LSG").begin(), node.children("LSG").end()) != 1)
      say(node, "does not hold one line");
    for (const pugi::xml_node child : node.children()) look_at(child);
  }

  std::vector<std::string> faults() {
    for (const auto& [id, where] : references_)
      if (ids_.count(id) == 0) faults_.push_back(where + " refers to " + id + ", which is not there");
    return faults_;
  }

 private:
  void say(const pugi::xml_node& node, const std::string& what) {
    faults_.push_back(std::string(node.name()) + " " + node.attribute("A").value() + " " + what);
  }

  void look_at_attributes(const pugi::xml_node& node, const Element& element) {
    for (const auto& [name, attribute] : element.attributes)
      if (attribute.required && !node.attribute(name.c_str())) say(node, "lacks " + name);
    for (const pugi::xml_attribute given : node.attributes()) {
      const auto known = element.attributes.find(given.name());
      if (known == element.attributes.end()) {
        say(node, std::string("has an unknown attribute ") + given.name());
        continue;
      }
      const std::string value = given.value();
      if (!has_form(value, known->second.form)) say(node, std::string(given.name()) + " is '" + value + "'");
      if (!known->second.refers_to.empty())
        references_.emplace_back(value, node.name());
      else if (known->first == "A" && known->second.form.front() == '(')
        look_at_id(node, value);
    }
  }

  void look_at_id(const pugi::xml_node& node, const std::string& id) {
    if (id.size() > 14) say(node, "has an id that is too long");
    if (!ids_.insert(id).second) say(node, "has an id that was given before");
  }

  /// Version 4: one exterior each; version 3 may have several.
  void look_at_polygon(const pugi::xml_node& polygon) {
    int exteriors = 0;
    for (const pugi::xml_node line : polygon.children("LSG")) {
      const std::string type = line.attribute("A").value();
      if (type != "1" && type != "2") say(line, "is no ring, and stands in a polygon");
      exteriors += type == "1" ? 1 : 0;
    }
    if (exteriors < 1 || (version4_ && exteriors > 1)) say(polygon, "has no exterior ring, or several");
  }

  void look_at_line(const pugi::xml_node& line) {
    std::vector<std::string> places, types;
    for (const pugi::xml_node point : line.children("PNT")) {
      places.push_back(point.attribute("C").value() + std::string(" ") + point.attribute("D").value());
      types.emplace_back(point.attribute("A").value());
    }
    const bool ring = std::string(line.parent().name()) == "PLN";
    if (places.size() < (ring ? 4U : 2U)) return say(line, "has too few points");
    if (ring && places.front() != places.back()) say(line, "is an open ring");
    if (ring) return;
    if (line.attribute("A").value() != std::string("5")) say(line, "is no guidance line");
    look_at_guidance(line, types);
  }

  void look_at_guidance(const pugi::xml_node& line, const std::vector<std::string>& types) {
    const bool ab = std::string(line.parent().attribute("C").value()) == "1";
    if (version4_ && ab && types.size() != 2) say(line, "is an AB line that has not two points");
    for (std::size_t i = 0; i < types.size(); ++i) {
      const char* const wanted = !version4_ ? "2" : i == 0 ? "6" : i + 1 == types.size() ? "7" : "9";
      if (types[i] != wanted) say(line, "has a point of type " + types[i]);
    }
  }

  bool version4_;
  std::map<std::string, Element> grammar_;
  std::set<std::string> ids_;
  std::vector<std::pair<std::string, std::string>> references_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faults_of_task_set(const std::string& xml) {
  pugi::xml_document document;
  if (!document.load_buffer(xml.data(), xml.size())) return {"it is no XML"};
  const pugi::xml_node root = document.child("ISO11783_TaskData");
  if (!root) return {"it has no element ISO11783_TaskData"};
  Examination examination(root.attribute("VersionMajor").value() == std::string("4"));
  examination.look_at(root);
  return examination.faults();
}

}  // namespace tramline::testing_terminal
