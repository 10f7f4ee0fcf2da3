#pragma once
// Is a TASKDATA.XML of fields and lines as ISO 11783-10 has it? Written from the standard's description, for
// the tests: it shares nothing with the writer.

#include <string>
#include <vector>

namespace tramline::testing_terminal {

/// What is wrong with it: elements in the wrong place, missing or unknown attributes, values that are no
/// member of their enumeration or too long, ids of the wrong form, given twice or referred to without being
/// there, rings that are open or too short, lines of guidance whose points are of the wrong types. Empty:
/// nothing.
std::vector<std::string> faults_of_task_set(const std::string& xml);

}  // namespace tramline::testing_terminal
