// What the dictionaries of an OpenFOAM case say of its regions and of what its times count. A case may lack
// any of them: it is then read as a transient one in seconds, whose regions tell by their fields what they are.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Returns the regions that constant/regionProperties calls fluid; empty if it is not there or names none.
std::set<std::string> fluid_regions(const std::filesystem::path& folder);

/// Says whether times count a solver's iterations: system/fvSchemes of a region, or else of the case, has no
/// time derivative, or one that goes at another pace in each cell. @param regions  the fluid ones
bool times_are_iterations(const std::filesystem::path& folder,
                          const std::vector<std::string>& regions);

/// Describes times in degrees of an engine's crank.
struct CrankTimes {
    std::optional<double> revolutions_per_minute; ///< nothing: the case does not say it
};

/// Returns a value if times are degrees of the crank: `userTime` of system/controlDict is engine, or there is
/// a constant/engineGeometry, which only engines' solvers read.
std::optional<CrankTimes> crank_times(const std::filesystem::path& folder);

} // namespace wakesurf::importer
