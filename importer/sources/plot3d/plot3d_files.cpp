#include "importer/sources/plot3d/plot3d_files.hpp"

#include "importer/base/text.hpp"
#include "importer/sources/files/source_files.hpp"
#include "importer/sources/series/numbered_files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>

namespace wakesurf::importer {

using nlohmann::json;
namespace fs = std::filesystem;
using core::Error;

bool is_plot3d_grid(const fs::path& path) {
    constexpr std::array extensions{".xyz", ".x", ".g", ".grd", ".p3d"};
    return std::find(extensions.begin(), extensions.end(), lower_extension(path)) !=
           extensions.end();
}

namespace {

ListedFile listed(const fs::path& path) {
    return {path, path.filename().string(), {}};
}

bool is_meta(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    char first = '\0';
    return lower_extension(path) == ".p3d" && (in >> first) && first == '{';
}

std::vector<fs::path> siblings(const fs::path& path) {
    std::vector<fs::path> out;
    std::error_code error;
    const fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        out.push_back(path.parent_path() / entry->path().filename());
    std::sort(out.begin(), out.end());
    return out;
}

core::Result<fs::path> grid_of(const fs::path& solution, const std::string& stem) {
    std::vector<fs::path> grids;
    for (const auto& file : siblings(solution))
        if (is_plot3d_grid(file) && !is_meta(file)) {
            if (file.stem() == stem || file.stem() == solution.stem())
                return file;
            grids.push_back(file);
        }
    if (grids.size() == 1)
        return grids.front();
    const std::string name = solution.filename().string();
    if (grids.empty())
        return core::fail(Error::Code::NotFound, "there is no grid beside " + name,
                          "put " + stem + ".xyz into the same folder");
    return core::fail(Error::Code::InvalidArgument,
                      "several grids are beside " + name + ", and none is called " + stem,
                      "name the grid " + stem + ".xyz");
}

// FDS names its files by their times: fire_1_0012_50.q, or fire_1_00000012p50.q, of mesh 1 is at 12.5 s.
struct NameOfFds {
    std::string mesh; ///< what stands before the time
    double time = 0.0;
};

std::optional<NameOfFds> name_of_fds(const fs::path& file) {
    const std::string stem = file.stem().string();
    const auto digits = [&](std::size_t end) {
        std::size_t begin = end;
        while (begin > 0 && std::isdigit(static_cast<unsigned char>(stem[begin - 1])) != 0)
            --begin;
        return begin;
    };
    const std::size_t hundredths = digits(stem.size());
    if (stem.size() - hundredths != 2 || hundredths == 0 ||
        (stem[hundredths - 1] != '_' && stem[hundredths - 1] != 'p'))
        return std::nullopt;
    const std::size_t seconds = digits(hundredths - 1);
    if (hundredths - 1 - seconds < 4 || seconds < 2 || stem[seconds - 1] != '_')
        return std::nullopt;
    const auto time = finite_number(stem.substr(seconds, hundredths - 1 - seconds) + "." +
                                    stem.substr(hundredths));
    return time ? std::optional(NameOfFds{stem.substr(0, seconds - 1), *time}) : std::nullopt;
}

// Returns the solutions of one mesh with the times in their names; none if that of `first` has none.
std::vector<std::pair<double, fs::path>> timed_by_name(const fs::path& first) {
    std::vector<std::pair<double, fs::path>> out;
    const auto wanted = name_of_fds(first);
    for (const auto& file : siblings(first))
        if (const auto name = name_of_fds(file);
            wanted && name && name->mesh == wanted->mesh && lower_extension(file) == ".q")
            out.emplace_back(name->time, file);
    std::sort(out.begin(), out.end());
    return out;
}

core::Result<fs::path> first_solution_of(const fs::path& grid) {
    const std::string stem = grid.stem().string();
    std::vector<fs::path> solutions;
    std::size_t grids = 0;
    for (const auto& file : siblings(grid)) {
        grids += is_plot3d_grid(file) ? 1 : 0;
        if (lower_extension(file) != ".q")
            continue;
        if (const auto series = numbered_files(file); series && series->name == stem)
            return file;
        solutions.push_back(file);
    }
    const std::string name = grid.filename().string();
    if (solutions.empty() || grids > 1)
        return core::fail(Error::Code::NotFound, "there are no solutions beside " + name,
                          "put " + stem + ".q, or " + stem +
                              "_0001.q and so on, into the same folder");
    const auto series = numbered_files(solutions.front());
    if (!series)
        return tl::unexpected(series.error());
    if (series->files.size() != solutions.size() &&
        timed_by_name(solutions.front()).size() != solutions.size())
        return core::fail(Error::Code::InvalidArgument,
                          "several series of solutions are beside " + name,
                          "name those of one " + stem + "_0001.q and so on, or give one of them");
    return solutions.front();
}

core::Result<Plot3dFiles> read_meta(const fs::path& file) {
    const std::string name = file.filename().string();
    std::ifstream in(file, std::ios::binary);
    const json root = json::parse(in, nullptr, false);
    const auto files = root.is_object() ? root.find("filenames") : root.end();
    if (!root.is_object() || files == root.end() || !files->is_array() || files->empty())
        return core::fail(Error::Code::Corrupt, name + " is not JSON with a list of filenames");
    Plot3dFiles out{file.stem().string(), {file}, {}};
    for (const auto& entry : *files) {
        const auto text = [&](const char* key) {
            return entry.is_object() && entry.contains(key) && entry[key].is_string()
                       ? entry[key].get<std::string>()
                       : std::string();
        };
        const auto grid = text("xyz");
        const auto solution = text("q");
        if (grid.empty() || solution.empty())
            return core::fail(Error::Code::Corrupt,
                              name + " has an entry without an xyz and a q file");
        const auto grid_path = named_path(file.parent_path(), grid, name);
        const auto solution_path = named_path(file.parent_path(), solution, name);
        if (!grid_path || !solution_path)
            return tl::unexpected(grid_path ? solution_path.error() : grid_path.error());
        Plot3dStep step{{*grid_path, name_for_messages(grid), {}},
                        {*solution_path, name_for_messages(solution), {}},
                        std::nullopt};
        if (entry.contains("time")) {
            if (!entry["time"].is_number() || !std::isfinite(entry["time"].get<double>()))
                return core::fail(Error::Code::Corrupt, name + " gives " + solution +
                                                            " a time that is not a finite number");
            step.time = entry["time"].get<double>();
        }
        out.steps.push_back(std::move(step));
    }
    return out;
}

} // namespace

core::Result<Plot3dFiles> find_plot3d_files(const fs::path& path, bool alone) {
    if (is_meta(path))
        return read_meta(path);
    const bool grid_given = is_plot3d_grid(path);
    const auto first = grid_given ? first_solution_of(path) : core::Result<fs::path>(path);
    if (!first)
        return tl::unexpected(first.error());
    const auto solutions = numbered_files(*first, alone && !grid_given);
    if (!solutions)
        return tl::unexpected(solutions.error());
    const auto grid = grid_given ? core::Result<fs::path>(path)
                                 : grid_of(solutions->files.front(), solutions->name);
    if (!grid)
        return tl::unexpected(grid.error());
    Plot3dFiles out{grid->stem().string(), {}, {}};
    const auto timed = timed_by_name(*first);
    std::vector<fs::path> beside{*grid, *first};
    for (const auto& [time, solution] : timed)
        beside.push_back(solution);
    for (const auto& file : beside)
        if (file != path)
            if (const auto inside = named_path(path.parent_path(), file.filename().string(),
                                               "the folder of " + path.filename().string());
                !inside)
                return tl::unexpected(inside.error());
    if (timed.size() > solutions->files.size() && (grid_given || !alone)) {
        for (const auto& [time, solution] : timed)
            out.steps.push_back({listed(*grid), listed(solution), time});
        out.note = "the times are those in the names of the files";
        return out;
    }
    for (const auto& solution : solutions->files)
        out.steps.push_back({listed(*grid), listed(solution), std::nullopt});
    return out;
}

} // namespace wakesurf::importer
