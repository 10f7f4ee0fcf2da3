#include "tramline/io/machine/machine_table.h"

#include "tramline/io/geopackage/rows.h"
#include "tramline/io/geopackage/table.h"
#include "tramline/io/geopackage/write_geopackage.h"

namespace tramline::io {
namespace {

constexpr FileKind kMachineFile{"list of machines", "tramline serve"};
constexpr const char* kTable = "machines";

}  // namespace

void write_machines(const std::vector<ListedMachine>& machines, const std::filesystem::path& path) {
  write_geopackage(path, kMachineFile, LocalFrame{}, [&](const Target& target) {
    Table table(target.file, kTable, wkbNone, nullptr,
                {text("id"), text("name"), real("width_m"), real("radius_m"), real("min_length_m")});
    for (const auto& [id, machine] : machines)
      table.add(nullptr, {id, machine.name, machine.width_m, machine.radius_m,
                          machine.min_length_m >= 0 ? Cell(machine.min_length_m) : Cell()});
  });
}

std::vector<ListedMachine> read_machines(const std::filesystem::path& path) {
  GdalErrors errors;
  Rows file(path, kMachineFile, errors);
  std::vector<ListedMachine> out;
  file.each(kTable, [&](const Row& row) {
    Machine machine{row.text("name"), row.number("width_m"), row.number("radius_m")};
    machine.min_length_m = row.number_if_any("min_length_m").value_or(machine.min_length_m);
    out.push_back({row.text("id"), machine});
  });
  return out;
}

}  // namespace tramline::io
