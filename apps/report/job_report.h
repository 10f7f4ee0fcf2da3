#pragma once
// The report of `evaluate` on one job among several.

#include <nlohmann/json.hpp>
#include <string>

#include "report/evaluate_report.h"
#include "request/log_jobs.h"

namespace tramline::app {

/// The line "job 2 of 3    TLG00002 …".
std::string job_heading(const NumberedJob& job);

/// The keys of an evaluation with those of its job before them (docs/json.md).
nlohmann::ordered_json job_json(const NumberedJob& job, const Evaluation& evaluation);
/// A job that was left out, with the reason.
nlohmann::ordered_json job_json(const NumberedJob& job, const std::string& why);

}  // namespace tramline::app
