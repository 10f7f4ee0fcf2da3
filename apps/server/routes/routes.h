#pragma once
// The routes of the API, a file for each family. Those that are given the App keep a reference to it.

#include <string>

#include "server/app.h"
#include "server/http/router.h"

namespace tramline::server {

inline constexpr const char* kApi = "/api/v1";
/// "/api/v1/fields" for "/fields".
inline std::string api(const std::string& path) { return kApi + path; }

void add_about_routes(Router& router, App& app);
void add_background_routes(Router& router, App& app);
void add_session_routes(Router& router, App& app);
void add_upload_routes(Router& router, App& app);
void add_field_routes(Router& router, App& app);
void add_machine_routes(Router& router, App& app);
void add_turn_routes(Router& router);
void add_plan_routes(Router& router, App& app);
void add_drive_routes(Router& router, App& app);
/// Also takes up the drives of feeds that a server before has left.
void add_feed_routes(Router& router, App& app);
void add_plan_file_routes(Router& router, App& app);
void add_front_routes(Router& router, App& app);
void add_job_routes(Router& router, App& app);
void add_page_routes(Router& router, App& app);

}  // namespace tramline::server
