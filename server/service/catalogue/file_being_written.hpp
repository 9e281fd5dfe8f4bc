// Which file of a source someone is still writing: what cannot be read of it is not damage.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace wakesurf::server {

/// A file that was changed so recently may still grow.
inline constexpr std::chrono::seconds still_written{5};

/// The name of a file in the source's folder, or three folders below, that `words` (of a reader) speak of
/// and that was changed within the last `still_written`. A time folder of a case stands for the files in it.
std::optional<std::string> file_being_written(const std::filesystem::path& source,
                                              const std::string& words);

} // namespace wakesurf::server
