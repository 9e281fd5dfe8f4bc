// A number that changes when a source changes on disk: how a simulation that is still running is noticed.
#pragma once

#include <cstdint>
#include <filesystem>

namespace wakesurf::server {

/// Of a file: itself and its neighbours in the folder, among them the rest of its series. Of a folder: what is in it and in its folders'
/// listings (the processors' of a decomposed case). Names, sizes and times only; about 2 microseconds an entry. Never fails: what
/// cannot be looked at counts as nothing.
std::uint64_t source_stamp(const std::filesystem::path& source);

} // namespace wakesurf::server
