#pragma once
// Can the files asked for be written? Found out before the work, not after it.

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

namespace tramline::app {

/// Does nothing for an empty name. Throws kBadInput where the name has none of the extensions, is a
/// folder or is one of the `inputs`; kFailure where its folder is missing or cannot be written.
void require_writable(const std::string& name, const char* option,
                      std::initializer_list<const char*> extensions, const std::vector<std::string>& inputs);

/// Does nothing for an empty name. Throws kBadInput where the name is that of a file, and where there is
/// no such folder and none can be made. Makes nothing itself.
void require_folder(const std::string& name, const char* option);

}  // namespace tramline::app
