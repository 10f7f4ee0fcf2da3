#pragma once
// A file as an answer.

#include <httplib.h>

#include <filesystem>
#include <functional>
#include <string>

#include "server/store/store_folder.h"

namespace tramline::server {

/// Answers with the bytes of a file, to be kept under `name` with the extension. Throws failure where it
/// cannot be read.
void send_file(httplib::Response& response, const std::filesystem::path& file, const std::string& name,
               const std::string& extension, const char* type);

/// Lets `write` write a file of that extension in a folder of its own, and answers with it; the folder is
/// gone afterwards.
void send_written(httplib::Response& response, const StoreFolder& folder, const std::string& name,
                  const std::string& extension, const char* type,
                  const std::function<void(const std::filesystem::path&)>& write);

}  // namespace tramline::server
