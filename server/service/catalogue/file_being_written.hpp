// Finds files of a source that are still being written: their errors are no damage.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace wakesurf::server {

/// The age below which a file may still grow.
inline constexpr std::chrono::seconds still_written{5};

/// Returns the name of a file in the source's folder, or up to three folders below, that `words` (of a
/// reader) mention and that was changed within the last `still_written`. A time folder of a case stands for
/// the files in it. Empty if there is none.
std::optional<std::string> file_being_written(const std::filesystem::path& source,
                                              const std::string& words);

} // namespace wakesurf::server
