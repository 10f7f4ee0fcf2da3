// Task sets as the standard has them, and as our own reader finds them: for the long test of curated fields.
// Usage: task_set_check SET.zip…   It prints what is wrong, and ends with 1 where anything is.

#include <cstdio>
#include <exception>
#include <pugixml.hpp>
#include <string>

#include "io/terminal/task_set_form.h"
#include "tramline/io/isoxml/read_task_log.h"
#include "tramline/io/isoxml/task_files.h"

namespace {

using tramline::RawDataset;
using tramline::RawFeature;

/// Elements of a name below a node, with this value of A; any where it is empty.
std::size_t count(const pugi::xml_node& node, const char* name, const std::string& type) {
  std::size_t out = 0;
  for (const pugi::xml_node child : node.children()) {
    out +=
        child.name() == std::string(name) && (type.empty() || child.attribute("A").value() == type) ? 1 : 0;
    out += count(child, name, type);
  }
  return out;
}

std::size_t points_read(const RawDataset& guidance) {
  std::size_t out = 0;
  for (const RawFeature& feature : guidance.layers.at(0).features) out += feature.lines.at(0).size();
  return out;
}

std::size_t points_written(const pugi::xml_node& node) {
  std::size_t out = 0;
  for (const pugi::xml_node child : node.children())
    out += child.name() == std::string("LSG") && child.attribute("A").value() == std::string("5")
               ? count(child, "PNT", "")
               : points_written(child);
  return out;
}

int faults_of(const std::string& file) {
  int faults = 0;
  const auto say = [&](const std::string& what) {
    std::printf("%s: %s\n", file.c_str(), what.c_str());
    ++faults;
  };
  const std::string xml = tramline::io::TaskFiles::open(file).read("TASKDATA.XML").value();
  for (const std::string& fault : tramline::testing_terminal::faults_of_task_set(xml)) say(fault);
  pugi::xml_document document;
  document.load_string(xml.c_str());
  const RawDataset fields = tramline::io::read_partfields(file);
  if (fields.layers.at(0).features.size() != count(document, "PFD", "") || !fields.skipped.empty())
    say("our reader does not find every field");
  const RawDataset guidance = tramline::io::read_guidance(file);
  if (guidance.layers.at(0).features.size() != count(document, "LSG", "5") || !guidance.skipped.empty() ||
      points_read(guidance) != points_written(document))
    say("our reader does not find every guidance line");
  return faults;
}

}  // namespace

int main(int argc, char** argv) {
  int faults = 0;
  try {
    for (int i = 1; i < argc; ++i) faults += faults_of(argv[i]);
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    ++faults;
  }
  return faults == 0 ? 0 : 1;
}
