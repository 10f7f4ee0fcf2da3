#include "request/machines_asked.h"

#include <fmt/format.h>

#include <algorithm>

#include "request/map_directions.h"
#include "tramline/geometry/error.h"
#include "tramline/io/machine/read_machine.h"

namespace tramline::app {
std::vector<Machine> machines_asked(const Machine& machine, const std::string& widths,
                                    const std::string& files) {
  if (!widths.empty() && !files.empty())
    throw bad_input("--widths and --machines both say which machines to compare: give one of them");
  std::vector<Machine> out;
  if (!widths.empty()) {
    for (const double width_m : map_widths(widths)) {
      out.push_back(machine);
      out.back().width_m = width_m;
      out.back().name.clear();  // it is told by its width
    }
    return out;
  }
  if (files.empty()) return {machine};
  for (const std::string& file : words_of(files)) {
    out.push_back(io::read_machine(file));
    if (out.back().name.empty()) out.back().name = file;
    const std::string& name = out.back().name;
    const auto same = std::count_if(out.begin(), out.end(), [&](const Machine& m) { return m.name == name; });
    if (same > 1)
      throw bad_input(fmt::format("--machines: two machines are called '{}'; give one another name", name));
  }
  return out;
}

}  // namespace tramline::app
