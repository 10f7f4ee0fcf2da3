#pragma once
// Evaluates stored logs as stored drives.

#include <filesystem>
#include <memory>
#include <string>

#include "request/evaluate_input.h"
#include "server/app.h"
#include "server/drives/drive_rooms.h"
#include "server/jobs/job.h"
#include "server/store/drive_store.h"
#include "server/work/ready_drive.h"

namespace tramline::server {

/// A drive to be evaluated. Its log is at DriveStore::log_file().
struct DriveOrder {
  std::string id, name, created;  ///< of the drive to be
  std::string field;              ///< id; empty: none
  std::string plan;               ///< id; empty: none
  DriveSource source;
  /// The field is what the log's task names, and not what the user says: where the log lies elsewhere, it is
  /// evaluated without.
  bool field_is_a_guess = false;
};

/// The ground of a field that is kept; none for an empty id. Throws HttpError(kNotFound).
app::WorkGround ground_of(const App& app, const std::string& field);

/// The partfield that the task of a log names, as a field that is kept, and was before where it is the same;
/// empty where the log is of no task set, or its task names none that can be worked. Throws as
/// io::list_logs().
std::string partfield_of(App& app, const std::filesystem::path& task_set, const std::string& log);

/// Evaluates the drive as `tramline evaluate` does, and keeps it. Where it has a plan but no field, the
/// ground is the plan's. Throws kBadInput, JobCancelled; nothing is kept then but the log, which is its
/// taker's.
KeptDrive work_drive(App& app, DriveOrder order, JobRun& run);

/// The same for a drive that is kept already, by the field as it is now. What was kept stays where that
/// fails. Throws HttpError(kNotFound) where the drive has been deleted, also meanwhile.
KeptDrive work_again(App& app, const KeptDrive& drive, JobRun& run);

/// The drive as it can be replayed: on the ground it was evaluated on.
std::shared_ptr<const ReadyDrive> ready_to_replay(App& app, const KeptDrive& drive);

}  // namespace tramline::server
