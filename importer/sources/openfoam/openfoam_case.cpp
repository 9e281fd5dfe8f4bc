#include "importer/sources/openfoam/openfoam_case.hpp"

#include "importer/sources/openfoam/openfoam_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

namespace wakesurf::importer {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;
using Place = Words::const_iterator;

// Returns the range between the bracket that follows `name` and the one that closes it; empty if there is none.
std::pair<Place, Place> block_of(const Words& words, std::string_view name) {
    for (auto at = words.begin(); at != words.end(); ++at) {
        if (*at != name || at + 1 == words.end() || (at[1] != "{" && at[1] != "("))
            continue;
        const auto begin = at + 2;
        int depth = 1;
        for (auto end = begin; end != words.end(); ++end) {
            depth += *end == "{" || *end == "(" ? 1 : *end == "}" || *end == ")" ? -1 : 0;
            if (depth == 0)
                return {begin, end};
        }
    }
    return {words.end(), words.end()};
}

// Returns the last number of the entry `key`, and whether its unit is radians a second.
std::optional<std::pair<double, bool>> number_of(Place begin, Place end, std::string_view key) {
    std::optional<double> out;
    bool radians = false; // the unit stands behind the number, or before it
    for (auto at = std::find(begin, end, key); at != end && *at != ";"; ++at) {
        double value = 0.0;
        const char* const last = at->data() + at->size();
        if (std::from_chars(at->data(), last, value).ptr == last && std::isfinite(value))
            out = value;
        else
            radians = radians || at->find("rad") != std::string::npos;
    }
    return out ? std::optional(std::pair(*out, radians)) : std::nullopt;
}

std::optional<double> speed_of(Place begin, Place end) {
    constexpr double rpm = 60.0 / (2.0 * std::numbers::pi);
    for (const char* key : {"omega", "rpm"})
        if (const auto found = number_of(begin, end, key); found && found->first > 0.0)
            return found->first * (found->second ? rpm : 1.0);
    return std::nullopt;
}

} // namespace

std::set<std::string> fluid_regions(const fs::path& folder) {
    const auto words = foam_words(folder / "constant" / "regionProperties");
    const auto [begin, end] = block_of(words, "fluid");
    return {begin, end};
}

bool times_are_iterations(const fs::path& folder, const std::vector<std::string>& regions) {
    constexpr std::array<std::string_view, 4> without_time{"steadyState", "localEuler", "SLTS",
                                                           "CoEuler"};
    return !regions.empty() && std::ranges::all_of(regions, [&](const std::string& region) {
        auto words = foam_words(folder / "system" / region / "fvSchemes");
        if (words.empty())
            words = foam_words(folder / "system" / "fvSchemes");
        auto [begin, end] = block_of(words, "ddtSchemes");
        // What a default says counts, unless it is none: turbulence may be steady in a flow that is not.
        if (const auto usual = std::find(begin, end, "default");
            usual != end && usual + 1 != end && usual[1] != "none") {
            begin = usual;
            end = std::find(begin, end, ";");
        }
        return std::find_first_of(begin, end, without_time.begin(), without_time.end()) != end;
    });
}

std::optional<CrankTimes> crank_times(const fs::path& folder) {
    const auto control = foam_words(folder / "system" / "controlDict");
    const auto geometry = foam_words(folder / "constant" / "engineGeometry");
    const auto [begin, end] = block_of(control, "userTime");
    const auto plain =
        std::adjacent_find(control.begin(), control.end(), [](const auto& a, const auto& b) {
            return a == "userTime" && b == "engine";
        });
    if (std::find(begin, end, "engine") == end && plain == control.end() && geometry.empty())
        return std::nullopt;
    auto speed = speed_of(begin, end);
    for (const Words* words : {&geometry, &control})
        if (!speed)
            speed = speed_of(words->begin(), words->end());
    return CrankTimes{speed};
}

std::string FoamCase::relative(const std::string& part,
                               const std::string& instance,
                               const std::string& region,
                               const std::string& file_name) const {
    return (fs::path(part) / instance / region / file_name).string();
}

std::string FoamCase::mesh_file(const std::string& part,
                                const std::string& region,
                                const std::string& file_name) const {
    const std::string path = "polyMesh/" + file_name;
    for (const auto& time : mesh_times)
        if (std::string here = relative(part, time.name, region, path); foam_file(folder / here))
            return here;
    return relative(part, "constant", region, path);
}

NamedFile FoamCase::file_at(const std::string& relative_name) const {
    if (const auto there = foam_file(folder / relative_name))
        return {*there, there->extension() == ".gz" && !relative_name.ends_with(".gz")
                            ? relative_name + ".gz"
                            : relative_name};
    return {folder / relative_name, relative_name};
}

} // namespace wakesurf::importer
