
#include "importer/base/reading_bounds.hpp"
#include "importer/base/text.hpp"
#include "importer/sources/openfoam/openfoam_case.hpp"
#include "importer/sources/openfoam/openfoam_file.hpp"
#include "store/velocity_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>

namespace wakesurf::importer {

using core::Error;
namespace fs = std::filesystem;

namespace {

// Reads it as VTK does, so that both mean the same number.
bool is_time(const std::string& name, double& value) {
    if (name.empty() ||
        (std::isdigit(static_cast<unsigned char>(name[0])) == 0 && name[0] != '+' &&
         name[0] != '-') ||
        name.find_first_not_of("0123456789+-.eE") != std::string::npos)
        return false;
    char* end = nullptr;
    value = std::strtod(name.c_str(), &end);
    return *end == '\0' && std::isfinite(value);
}

} // namespace

core::Result<std::vector<FoamTime>> list_foam_times(const fs::path& folder,
                                                    const std::string& part) {
    std::vector<FoamTime> out;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        FoamTime time{0.0, entry.path().filename().string()};
        if (is_time(time.name, time.value) && entry.is_directory(error))
            out.push_back(std::move(time));
    }
    std::sort(out.begin(), out.end(),
              [](const FoamTime& a, const FoamTime& b) { return a.value < b.value; });
    const auto twice =
        std::adjacent_find(out.begin(), out.end(),
                           [](const FoamTime& a, const FoamTime& b) { return a.value == b.value; });
    if (twice != out.end())
        return core::fail(Error::Code::Corrupt,
                          part + " has the time folders " + twice->name + " and " +
                              std::next(twice)->name + ", which are the same time",
                          "remove one of them");
    return out;
}

namespace {

/// Describes a mesh that becomes another one at a time.
struct MeshChange {
    std::string before; ///< files that differ
    std::string after;
    bool cells = false; ///< not only its points move
};

using MeshChanges = std::map<double, MeshChange>;

// Compares one part's meshes, up to the last time-step; those before the first are no change.
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

using NamesAtTimes = std::map<double, std::pair<std::string, std::set<std::string>>>;

core::Result<NamesAtTimes>
fields_at_times(const FoamCase& found, const std::string& part, const std::string& region) {
    const auto times = list_foam_times(found.folder / part, part.empty() ? found.file : part);
    if (!times)
        return tl::unexpected(times.error());
    NamesAtTimes out;
    for (const auto& time : *times)
        out[time.value] = {time.name, foam_fields(found.folder / part / time.name / region)};
    return out;
}

bool is_of_something_else(const std::string& name) {
    return store::meaning_of_vector(name) == store::VectorName::Other;
}

// Returns the velocity asked for, U, or else the vector field that most times have and whose name does not
// say that it is something else.
std::string velocity_name(const FoamCase& found, const std::vector<NamesAtTimes>& regions) {
    std::map<std::string, std::size_t> counts;
    for (const auto& region : regions)
        for (const auto& [value, here] : region)
            for (const auto& name : here.second)
                ++counts[name];
    if (const auto first = found.velocity.substr(0, found.velocity.find(','));
        counts.contains(first))
        return first;
    if (counts.contains("U"))
        return "U";
    std::string best;
    for (const auto& [name, count] : counts) {
        const bool other = is_of_something_else(name);
        const bool alike = is_of_something_else(best) == other;
        if (!best.empty() && (alike ? counts[best] >= count : other))
            continue;
        for (std::size_t r = 0; r < regions.size(); ++r) {
            const auto last = std::find_if(
                regions[r].rbegin(), regions[r].rend(),
                [&field = name](const auto& here) { return here.second.second.contains(field); });
            if (last == regions[r].rend())
                continue;
            const auto header = read_foam_header(
                found
                    .file_at(found.relative(found.parts.front(), last->second.first,
                                            found.regions[r].name, name))
                    .path);
            if (header && header->type == "volVectorField")
                best = name;
            break;
        }
    }
    return best;
}

std::map<double, std::string> times_with(const NamesAtTimes& times, const std::string& field) {
    std::map<double, std::string> out;
    for (const auto& [value, here] : times)
        if (here.second.contains(field))
            out[value] = here.first;
    return out;
}

// Describes times on some processors only, as a run leaves them that was ended, or is running, while it
// writes.
struct LeftOut {
    std::map<double, std::string> times; ///< and the name of each time's folder
    std::string part;                    ///< one that does not have the last of them

    void add(double value, const std::string& time, const std::string& without) {
        if (times.empty() || value >= times.rbegin()->first)
            part = without;
        times.emplace(value, time);
    }

    std::string note(const std::string& velocity) const {
        if (times.empty())
            return {};
        const auto& last = times.rbegin()->second;
        const std::string which = times.size() == 1 ? "time " + last + " is left out"
                                                    : std::to_string(times.size()) +
                                                          " times up to " + last + " are left out";
        return which + ": " + part + " has no " + velocity + " at " + last +
               ", other processors have";
    }
};

// Keeps of `wanted` the times at which all processors have the velocity, under one name.
core::Result<void> keep_common_times(const FoamCase& found,
                                     const FoamRegion& region,
                                     const std::string& velocity,
                                     std::map<double, std::string>& wanted,
                                     LeftOut& left_out) {
    const auto of_first = wanted;
    for (const auto& part : found.parts) {
        const auto all = fields_at_times(found, part, region.name);
        if (!all)
            return tl::unexpected(all.error());
        const auto here = times_with(*all, velocity);
        std::erase_if(wanted, [&](const auto& time) {
            const auto same = here.find(time.first);
            const bool gone = same == here.end() || same->second != time.second;
            if (gone)
                left_out.add(time.first, time.second, part);
            return gone;
        });
        for (const auto& [value, name] : here)
            if (!of_first.contains(value))
                left_out.add(value, name, found.parts.front());
    }
    return {};
}

// Finds the regions of the fluid: of those with the velocity the ones that constant/regionProperties names. Where it
// names none, solids may have a velocity at the first time that was left there when the mesh was split. What is
// left behind of the mesh before it was split is no region.
void mark_fluid_regions(FoamCase& found,
                        const std::vector<NamesAtTimes>& names,
                        const std::vector<std::map<double, std::string>>& with) {
    std::size_t most = 0;
    double last = -HUGE_VAL;
    for (const auto& times : with) {
        most = std::max(most, times.size());
        if (!times.empty())
            last = std::max(last, times.rbegin()->first);
    }
    auto listed = fluid_regions(found.folder);
    std::erase_if(listed, [&](const std::string& name) {
        for (std::size_t r = 0; r < with.size(); ++r)
            if (found.regions[r].name == name && !with[r].empty())
                return false;
        return true;
    });
    for (std::size_t r = 0; r < found.regions.size(); ++r) {
        auto& region = found.regions[r];
        const bool split = std::any_of(names[r].begin(), names[r].end(), [](const auto& here) {
            return here.second.second.contains("cellToRegion");
        });
        const bool remnant =
            region.name.empty() && (with[r].size() < most || (split && names.size() > 1));
        const bool left_behind = with[r].size() == 1 && with[r].begin()->first < last &&
                                 with[r].begin()->first == names[r].begin()->first;
        region.fluid = !with[r].empty() && !remnant &&
                       (listed.empty() ? !left_behind : listed.contains(region.name));
    }
}

// Returns a note on the times that have fields, but not the velocity, and on the vectors that they have.
std::string note_on_other_times(const FoamCase& found,
                                const std::vector<NamesAtTimes>& names,
                                const std::string& velocity) {
    std::map<double, std::string> times;
    std::set<std::string> vectors;
    for (std::size_t r = 0; r < found.regions.size(); ++r)
        for (const auto& [value, here] : names[r]) {
            if (!found.regions[r].fluid || here.second.contains(velocity))
                continue;
            for (const auto& name : here.second) {
                const auto header =
                    read_foam_header(found
                                         .file_at(found.relative(found.parts.front(), here.first,
                                                                 found.regions[r].name, name))
                                         .path);
                if (!header || !header->type.starts_with("vol"))
                    continue;
                times[value] = here.first;
                if (header->type == "volVectorField" && !is_of_something_else(name))
                    vectors.insert(name);
            }
        }
    if (times.empty())
        return {};
    const auto& first = times.begin()->second;
    std::string out = times.size() == 1
                          ? "time " + first + " is left out: it has no " + velocity
                          : std::to_string(times.size()) + " times, " + first + " to " +
                                times.rbegin()->second + ", are left out: they have no " + velocity;
    std::string which;
    for (const auto& name : vectors)
        which += (which.empty() ? "" : ", ") + name;
    if (!vectors.empty())
        out += ", but " + which + ", which --velocity " + *vectors.begin() + " takes";
    return out;
}

// Finds what the times count, of a case whose regions and times are known.
void find_time_unit(FoamCase& found) {
    std::vector<std::string> fluid;
    for (const auto& region : found.regions)
        if (region.fluid)
            fluid.push_back(region.name);
    if (const auto crank = crank_times(found.folder)) {
        found.time_unit = "degrees";
        std::string words = "times are stored as degrees of the crank";
        if (crank->revolutions_per_minute) {
            found.time_unit = "s";
            found.time_scale = 1.0 / (6.0 * *crank->revolutions_per_minute);
            words += ", which are made seconds by " +
                     length_text(*crank->revolutions_per_minute, 6) + " revolutions a minute";
        } else {
            words += ", and no file says how fast it turns: paths through them are wrong";
        }
        add_note(found.note, words);
    } else if (times_are_iterations(found.folder, fluid)) {
        found.time_unit = "iterations";
        add_note(found.note, "the times are iterations of a steady solver: the last one is the "
                             "result, and a path from one to the next means nothing");
    }
}

// Leaves out the last time if it is half written. Fields are written one after the other: some processors may
// have files that others do not have yet, and one file may be written in part.
void leave_out_last_time_half_written(FoamCase& found) {
    const std::string last = found.times.back().name;
    for (const auto& region : found.regions) {
        const auto names = [&](const std::string& part) {
            return foam_fields(found.folder / found.relative(part, last, region.name, ""));
        };
        const auto of_first = names(found.parts.front());
        for (const auto& part : found.parts) {
            const auto here = names(part);
            std::set<std::string> one_of_them;
            std::set_symmetric_difference(of_first.begin(), of_first.end(), here.begin(),
                                          here.end(),
                                          std::inserter(one_of_them, one_of_them.end()));
            if (!region.fluid || found.times.size() == 1)
                continue;
            const auto leave_out = [&](const std::string& why) {
                add_note(found.note, "time " + last + " is left out: " + why);
                found.times.pop_back();
            };
            if (!one_of_them.empty()) {
                const std::string& name = *one_of_them.begin();
                const auto& without = here.contains(name) ? found.parts.front() : part;
                return leave_out(without + " has no " + name + " there, other processors have");
            }
            for (const auto& name : here) {
                const std::string file = found.relative(part, last, region.name, name);
                const auto header = read_foam_header(found.folder / file);
                if (header && header->type.starts_with("vol") &&
                    !ends_as_written(found.folder / file))
                    return leave_out(file + " ends too early");
            }
        }
    }
}

} // namespace

std::set<std::string> foam_fields(const fs::path& folder) {
    made_progress();
    std::set<std::string> out;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        std::string name = entry.path().filename().string();
        if (!entry.is_regular_file(error) || name.starts_with('.'))
            continue;
        if (name.ends_with(".gz"))
            name.resize(name.size() - 3);
        const auto ends = [&](const char* ending) { return name.ends_with(ending); };
        if (!ends("~") && !ends("_0") && !ends(".bak") && !ends(".BAK") && !ends(".old") &&
            !ends(".save"))
            out.insert(std::move(name));
    }
    return out;
}

core::Result<void> find_foam_times(FoamCase& found) {
    std::vector<NamesAtTimes> names;
    for (const auto& region : found.regions) {
        auto here = fields_at_times(found, found.parts.front(), region.name);
        if (!here)
            return tl::unexpected(here.error());
        names.push_back(std::move(*here));
    }
    const std::string velocity = velocity_name(found, names);
    if (velocity.empty())
        return core::fail(Error::Code::NotFound,
                          found.file + " has no time folder with a vector field",
                          "a case is read from folders named by their time, with a file U in each");
    std::vector<std::map<double, std::string>> with;
    std::size_t most = 0;
    for (const auto& region : names)
        with.push_back(times_with(region, velocity));
    mark_fluid_regions(found, names, with);
    add_note(found.note, note_on_other_times(found, names, velocity));
    std::map<double, std::string> times;
    LeftOut left_out;
    bool any = false;
    for (std::size_t r = 0; r < found.regions.size(); ++r) {
        if (!found.regions[r].fluid)
            continue;
        most = std::max(most, with[r].size());
        if (auto found_times =
                keep_common_times(found, found.regions[r], velocity, with[r], left_out);
            !found_times)
            return found_times;
        if (!any)
            times = with[r];
        any = true;
        std::erase_if(times, [&](const auto& time) { return !with[r].contains(time.first); });
    }
    if (found.regions.size() > 1)
        std::erase_if(found.regions, [](const FoamRegion& region) {
            return region.name.empty() && !region.fluid;
        });
    for (const auto& [value, name] : times)
        found.times.push_back({value, name});
    if (found.times.empty())
        return core::fail(Error::Code::NotFound,
                          std::string(left_out.times.empty() ? "the regions" : "the processors") +
                              " of " + found.file + " have no time with " + velocity +
                              " in common");
    if (found.times.size() + left_out.times.size() < most)
        add_note(found.note, "only times at which all fluid regions have " + velocity);
    add_note(found.note, left_out.note(velocity));
    leave_out_last_time_half_written(found);
    find_time_unit(found);
    return {};
}

core::Result<void> keep_times_of_last_mesh(FoamCase& found) {
    MeshChanges changes;
    for (const auto& part : found.parts)
        if (auto compared = find_changes(found, part, changes); !compared)
            return compared;
    if (!changes.empty()) {
        const auto& [from, last] = *changes.rbegin();
        const auto first_left =
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
        if (std::distance(first_left, found.times.end()) == 1 && (!cells || before > 1)) {
            const MeshChange& first = changes.begin()->second;
            return core::fail(Error::Code::Unsupported,
                              "the mesh moves: " + first.after + " of " + found.file +
                                  " differs from " + first.before,
                              "only meshes that do not move can be read");
        }
        add_note(found.note, left_out({found.times.begin(), first_left}, last));
        found.times.erase(found.times.begin(), first_left);
    }
    found.mesh_times = times_with_mesh(found);
    return {};
}

} // namespace wakesurf::importer
