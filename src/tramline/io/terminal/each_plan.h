#pragma once
// The plans of several files, one after the other.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tramline/io/export/export_format.h"
#include "tramline/io/terminal/terminal_field.h"
#include "tramline/model/plan.h"

namespace tramline::io {

/// Calls `use` with every plan of the files, in their order, and with the name of its file; one plan is in
/// memory at a time. `field`: key or id of the only one wanted, which has to be in the only file; empty: all.
/// Throws Error(kBadInput) where there is no file, `field` is given with several, a file is one of coverage,
/// or as read_plan().
void for_each_plan(const std::vector<std::filesystem::path>& files, const std::string& field,
                   const std::function<void(const Plan& plan, const std::string& file)>& use);

/// The same for terminals; files may be coverage files as well, of which each connected part of the field is
/// one.
void for_each_field(const std::vector<std::filesystem::path>& files, const std::string& field,
                    LineChoice choice, double tolerance_m,
                    const std::function<void(TerminalField field)>& use);

}  // namespace tramline::io
