#pragma once
// The kinds of files that 'tramline export' writes; each run writes them and prints its report.

#include "exports/export_options.h"

namespace tramline::app {

/// Layers of a plan file. Throws kBadInput where several plan files are named, or as io::export_plan().
void run_layer_export(const ExportOptions& options);

/// An ISOXML task set of all plans. Throws as io::export_task_set().
void run_task_set_export(const ExportOptions& options);

/// Field folders of AgOpenGPS. Throws as io::export_agopengps().
void run_agopengps_export(const ExportOptions& options);

/// The route of a plan, in the format that the extension says. Throws as io::export_route(), and kBadInput
/// where several plan files are named.
void run_route_export(const ExportOptions& options, io::RouteFormat format);

/// A page for the driver of each field. Throws kBadInput for fields in plain metres.
void run_line_card_export(const ExportOptions& options);

}  // namespace tramline::app
