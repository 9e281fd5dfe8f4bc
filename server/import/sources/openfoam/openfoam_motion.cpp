#include "server/import/sources/openfoam/openfoam_motion.hpp"

#include "server/import/sources/openfoam/openfoam_file.hpp"
#include "server/import/sources/openfoam/openfoam_times.hpp"

#include <array>

namespace wakesurf::server {

using core::Error;

core::Result<void> check_foam_mesh_stands_still(const FoamCase& found) {
    constexpr std::array<const char*, 4> files{"polyMesh/points", "polyMesh/faces",
                                               "polyMesh/owner", "polyMesh/neighbour"};
    for (const auto& part : found.parts) {
        const auto times = list_foam_times(found.folder / part, part);
        if (!times)
            return tl::unexpected(times.error());
        for (const auto& region : found.regions)
            for (const char* const file : files) {
                std::string in_use = found.relative(part, "constant", region.name, file);
                for (const auto& time : *times) {
                    const std::string here = found.relative(part, time.name, region.name, file);
                    if (time.value > found.times.back().value || !foam_file(found.folder / here))
                        continue;
                    if (time.value > found.times.front().value &&
                        !same_foam_body(found.file_at(in_use).path, found.file_at(here).path))
                        return core::fail(Error::Code::Unsupported,
                                          "the mesh moves: " + here + " of " + found.file +
                                              " differs from " + in_use,
                                          "only meshes that do not move can be read");
                    in_use = here;
                }
            }
    }
    return {};
}

} // namespace wakesurf::server
