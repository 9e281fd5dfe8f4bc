// A ParaView collection (.pvd): a small XML file that gives each file of a series its time.
#pragma once

#include "server/import/series.hpp"

namespace wakesurf::server {

/// Files in order of time. Error: Corrupt (not XML, no DataSet, bad or repeated times), Unsupported (several
/// parts a time-step).
core::Result<Series> read_pvd(const std::filesystem::path& file);

} // namespace wakesurf::server
