// The meaning of file names, and of texts in collections: extensions, numbers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::importer {

/// Returns the extension with its dot, in lower case: ".vtu".
std::string lower_extension(const std::filesystem::path& path);

/// Returns the whole text as a finite number, ignoring spaces around it; empty if it is none.
std::optional<double> finite_number(std::string_view text);

/// Returns the name without folder and last extension, and without _, - and dots before it: "flow" of
/// "flow_.vtu".
std::string tidy_name(std::string_view name);

} // namespace wakesurf::importer
