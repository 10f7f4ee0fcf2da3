#pragma once
// Results that consist of several files: a folder or a zip, written whole or not at all.

#include <filesystem>
#include <string>
#include <vector>

namespace tramline::io {

/// A file of such a result. The name is a path in it, with '/': "TASKDATA/TASKDATA.XML".
struct NamedFile {
  std::string name;
  std::string content;
};

/// Writes the files as one zip, in this order, with the time of time_of_files(); an older file of that name
/// is replaced. Throws Error(kFailure) naming the file where it cannot be written.
void write_zip(const std::vector<NamedFile>& files, const std::filesystem::path& zip);

/// Writes the files into a new folder: into one beside it, which gets the name once all are there. The folder
/// that it lies in has to exist. Throws Error(kBadInput) where there is a folder of that name with something
/// in it, a file, or no folder to make it in; Error(kFailure) naming the folder and the cause where it cannot
/// be written.
void write_folder(const std::vector<NamedFile>& files, const std::filesystem::path& folder);

/// The first half of write_folder(): is the name free? Throws Error(kBadInput) where it is not.
void require_free(const std::filesystem::path& folder);

}  // namespace tramline::io
