#include "importer/sources/openfoam/openfoam_motion.hpp"

#include "importer/base/notes.hpp"
#include "importer/sources/openfoam/openfoam_file.hpp"
#include "importer/sources/openfoam/openfoam_times.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace wakesurf::importer {

using core::Error;

namespace {

/// The mesh becomes another one at a time.
struct MeshChange {
    std::string before; ///< files that differ
    std::string after;
    bool cells = false; ///< not only its points move
};

using MeshChanges = std::map<double, MeshChange>;

// Of one part, up to the last time-step; what was there before the first is no change.
core::Result<void> find_changes(const FoamCase& found, const std::string& part, MeshChanges& out) {
    constexpr std::array<const char*, 4> files{"points", "faces", "owner", "neighbour"};
    const auto times = list_foam_times(found.folder / part, part);
    if (!times)
        return tl::unexpected(times.error());
    for (const auto& region : found.regions)
        for (const std::string file : files) {
            std::string in_use = found.relative(part, "constant", region.name, "polyMesh/" + file);
            for (const auto& time : *times) {
                const std::string here =
                    found.relative(part, time.name, region.name, "polyMesh/" + file);
                if (time.value > found.times.back().value || !foam_file(found.folder / here))
                    continue;
                if (time.value > found.times.front().value &&
                    !same_foam_body(found.file_at(in_use).path, found.file_at(here).path)) {
                    auto& change =
                        out.try_emplace(time.value, MeshChange{in_use, here}).first->second;
                    change.cells = change.cells || file != "points";
                }
                in_use = here;
            }
        }
    return {};
}

std::vector<FoamTime> times_with_mesh(const FoamCase& found) {
    std::vector<FoamTime> out;
    for (const auto& part : found.parts)
        if (const auto times = list_foam_times(found.folder / part, part))
            for (const auto& time : *times) {
                const bool counts =
                    time.value <= found.times.back().value &&
                    std::any_of(found.regions.begin(), found.regions.end(), [&](const auto& one) {
                        return std::filesystem::is_directory(
                            found.folder / found.relative(part, time.name, one.name, "polyMesh"));
                    });
                if (counts && std::none_of(out.begin(), out.end(), [&](const FoamTime& other) {
                        return other.name == time.name;
                    }))
                    out.push_back(time);
            }
    std::sort(out.begin(), out.end(),
              [](const FoamTime& a, const FoamTime& b) { return a.value > b.value; });
    return out;
}

std::string left_out(const std::vector<FoamTime>& times, const MeshChange& change) {
    const std::string which =
        times.size() == 1 ? "time " + times.front().name + " is left out: its fields are"
                          : std::to_string(times.size()) + " times, " + times.front().name +
                                " to " + times.back().name + ", are left out: their fields are";
    return which + " not of the last mesh, which begins with " + change.after;
}

} // namespace

core::Result<void> keep_times_of_last_mesh(FoamCase& found) {
    MeshChanges changes;
    for (const auto& part : found.parts)
        if (auto looked = find_changes(found, part, changes); !looked)
            return looked;
    if (!changes.empty()) {
        const auto& [from, last] = *changes.rbegin();
        const auto kept =
            std::find_if(found.times.begin(), found.times.end(),
                         [from = from](const auto& time) { return time.value >= from; });
        // Meshes before the last one at which there is a velocity.
        std::size_t before = 0;
        double begin = -HUGE_VAL;
        for (const auto& [end, change] : changes) {
            before += std::any_of(found.times.begin(), found.times.end(), [&](const auto& time) {
                return time.value >= begin && time.value < end;
            });
            begin = end;
        }
        const bool cells = std::any_of(changes.begin(), changes.end(),
                                       [](const auto& change) { return change.second.cells; });
        if (std::distance(kept, found.times.end()) == 1 && (!cells || before > 1)) {
            const MeshChange& first = changes.begin()->second;
            return core::fail(Error::Code::Unsupported,
                              "the mesh moves: " + first.after + " of " + found.file +
                                  " differs from " + first.before,
                              "only meshes that do not move can be read");
        }
        add_note(found.note, left_out({found.times.begin(), kept}, last));
        found.times.erase(found.times.begin(), kept);
    }
    found.mesh_times = times_with_mesh(found);
    return {};
}

} // namespace wakesurf::importer
