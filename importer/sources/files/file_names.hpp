// What file names and texts in collections say: extensions, numbers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::importer {

/// With its dot, in lower case: ".vtu".
std::string lower_extension(const std::filesystem::path& path);

/// The whole text as a finite number; spaces round it do not count.
std::optional<double> finite_number(std::string_view text);

/// Without the folder and the last extension, and without the _, - and dots before it: "flow" of "flow_.vtu".
std::string tidy_name(std::string_view name);

} // namespace wakesurf::importer
