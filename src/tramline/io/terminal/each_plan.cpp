#include "tramline/io/terminal/each_plan.h"

#include "tramline/geometry/error.h"
#include "tramline/io/plan/fields_in.h"
#include "tramline/io/plan/read_plan.h"

namespace tramline::io {

void for_each_plan(const std::vector<std::filesystem::path>& files, const std::string& field,
                   const std::function<void(const Plan& plan, const std::string& file)>& use) {
  if (files.empty()) throw bad_input("there is no plan to export; name a plan file");
  if (!field.empty() && files.size() > 1)
    throw bad_input("--id chooses a field of one plan file; name that file alone");
  for (const std::filesystem::path& file : files) {
    const std::vector<FieldNames> fields = fields_in(file);
    if (fields.empty() || !field.empty()) {
      use(read_plan(file, field), file.string());
      continue;
    }
    for (const FieldNames& one : fields) use(read_plan(file, one.key), file.string());
  }
}

}  // namespace tramline::io
