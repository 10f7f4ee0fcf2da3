#pragma once
// Can the files asked for be written? Found out before the work, not after it.

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

namespace tramline::app {

/// Does nothing for an empty name. Throws kBadInput where the name has none of the extensions, in
/// whatever case, is a folder or is one of the `inputs`, and where nothing can be written into its folder.
/// Finds out by writing there, and leaves nothing behind.
void require_writable(const std::string& name, const char* option,
                      std::initializer_list<const char*> extensions, const std::vector<std::string>& inputs);

/// Does nothing for an empty name. Throws kBadInput where the name is that of a file, where there is
/// no such folder and none can be made, and where nothing can be written into it. Finds out by making and
/// writing, and leaves nothing behind.
void require_folder(const std::string& name, const char* option);

}  // namespace tramline::app
