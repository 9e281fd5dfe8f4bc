// Addresses of stores on the web: https://host/path/STORE. They name a dataset on the command line, like a
// folder.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Says whether a text begins like an address, of any scheme: then it names no file.
bool is_web_address(std::string_view text);

/// Whether the files are below an address that store_address() returned.
bool is_on_the_web(const std::filesystem::path& folder);

/// Returns the address of a store, without store.json and slashes at its end. Error: InvalidArgument for
/// another scheme than http and https, for one with a user, a query, a fragment, or steps up; Unsupported for
/// anything but a store.
core::Result<std::string> store_address(std::string_view text);

/// Says whether the connection is private: https, or this machine.
bool is_private_address(std::string_view address);

} // namespace wakesurf::server
