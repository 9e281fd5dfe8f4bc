#include "importer/base/text.hpp"
#include "importer/sources/files/source_files.hpp"
#include "importer/sources/openfoam/openfoam_case.hpp"
#include "importer/sources/openfoam/openfoam_file.hpp"

#include <algorithm>
#include <charconv>
#include <map>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;
namespace fs = std::filesystem;

namespace {

bool has_mesh(const fs::path& constant) {
    return foam_file(constant / "polyMesh" / "faces").has_value();
}

core::Result<std::vector<std::string>> processors_of(const FoamCase& found) {
    std::map<unsigned, std::string> out;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(found.folder, error)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("processor") || !entry.is_directory(error))
            continue;
        if (name.starts_with("processors"))
            return core::fail(Error::Code::Unsupported,
                              found.file + " is decomposed in the collated format (" + name +
                                  "), which cannot be read",
                              "run reconstructPar first");
        unsigned number = 0;
        const char* const end = name.data() + name.size();
        if (std::from_chars(name.data() + 9, end, number).ptr == end)
            out[number] = name;
    }
    std::vector<std::string> names;
    for (const auto& [number, name] : out) {
        if (number != names.size())
            return core::fail(Error::Code::NotFound,
                              found.file + " has " + name + ", but no processor" +
                                  std::to_string(names.size()),
                              "copy all processor folders, or run reconstructPar first");
        names.push_back(name);
    }
    return names;
}

std::vector<std::string> regions_in(const fs::path& constant) {
    std::vector<std::string> out;
    if (has_mesh(constant))
        out.emplace_back();
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(constant, error))
        if (entry.is_directory(error) && has_mesh(entry.path()))
            out.push_back(entry.path().filename().string());
    std::sort(out.begin(), out.end());
    return out;
}

bool is_wall(const std::string& type) {
    return type == "wall" || type.ends_with("Wall");
}

// Says whether faces are an end of the fluid that is no wall, not one that is only reckoned with.
bool is_other(const std::string& type) {
    return !is_wall(type) && type != "empty" && type != "wedge" && !type.starts_with("cyclic") &&
           !type.starts_with("processor");
}

// Collects the patches of all parts: in some versions of OpenFOAM a part lists only those that touch it.
core::Result<void> find_patches(const FoamCase& found, FoamRegion& region) {
    region.walls.clear();
    region.cyclic.clear();
    region.conformal.clear();
    region.groups.clear();
    region.empty.clear();
    region.wedges.clear();
    region.others.clear();
    for (const auto& part : found.parts) {
        const auto file = found.file_at(found.mesh_file(part, region.name, "boundary"));
        const auto patches = read_foam_patches(file.path, file.name);
        if (!patches)
            return tl::unexpected(patches.error());
        for (const auto& patch : *patches) {
            auto& walls = region.walls;
            if (is_wall(patch.type) &&
                std::find(walls.begin(), walls.end(), patch.name) == walls.end())
                walls.push_back(patch.name);
            region.groups[patch.name] = patch.groups;
            if (patch.faces == 0) // what blockMesh leaves of its defaultFaces
                continue;
            if (patch.type == "empty")
                region.empty = patch.name;
            if (patch.type == "wedge")
                region.wedges.insert(patch.name);
            if (patch.type.starts_with("cyclic"))
                region.cyclic[patch.name] = patch.neighbour;
            if (is_other(patch.type))
                region.others.insert(patch.name);
            if (patch.type == "cyclic")
                region.conformal.insert(patch.name);
            if (patch.type == "processorCyclic")
                region.cyclic.try_emplace(patch.part_of);
        }
    }
    return {};
}

core::Result<std::vector<FoamRegion>> find_regions(const FoamCase& found) {
    std::vector<FoamRegion> out;
    const auto first = regions_in(found.folder / found.parts.front() / "constant");
    for (const auto& part : found.parts)
        if (regions_in(found.folder / part / "constant") != first)
            return core::fail(Error::Code::Corrupt,
                              part + " of " + found.file + " has different meshes from " +
                                  found.parts.front() + ", or none",
                              "decompose the case again, or copy the whole case");
    for (const auto& name : first) {
        FoamRegion region;
        region.name = name;
        if (auto walls = find_patches(found, region); !walls)
            return tl::unexpected(walls.error());
        out.push_back(std::move(region));
    }
    return out;
}

// OpenFOAM computes in a plane where the mesh is one cell across and there is no equation for that direction. Such a
// slab is read as it is: nothing leaves through its sides, where the velocity has no component across. Regions without a
// velocity may be anything: a film is often a plane.
void note_planes(FoamCase& found) {
    for (const auto& region : found.regions)
        if (region.fluid && region.wedges.empty() && !region.empty.empty())
            add_note(found.note, "a plane flow, one cell thick (the patch " + region.empty +
                                     " is of the type empty)");
}

int components_of(const FoamHeader& header) {
    return header.type == "volVectorField" ? 3 : header.type == "volScalarField" ? 1 : 0;
}

// Finds the fields of cells that every fluid region has at all time-steps, and notes those that only some
// have.
void find_fields(FoamCase& found) {
    std::map<std::string, std::size_t> counts;
    std::map<std::string, std::string> first;
    std::size_t places = 0;
    for (const auto& region : found.regions)
        for (const auto& time : found.times)
            for (const auto& part : found.parts) {
                if (!region.fluid)
                    continue;
                ++places;
                for (const auto& name :
                     foam_fields(found.folder / found.relative(part, time.name, region.name, ""))) {
                    ++counts[name];
                    first.try_emplace(name, found.relative(part, time.name, region.name, name));
                }
            }
    std::string left_out;
    for (const auto& [name, count] : counts) {
        const auto header = read_foam_header(found.file_at(first.at(name)).path);
        if (!header || components_of(*header) == 0)
            continue;
        if (count == places)
            found.fields.push_back(
                {name, components_of(*header), FieldInfo::Source::Cell, {0.0, 0.0}, header->unit});
        else
            left_out += (left_out.empty() ? "" : ", ") + name;
    }
    if (!left_out.empty())
        add_note(found.note, "not at every time-step: " + left_out);
}

// Takes the first phase of several, in the order of their names: U.air of U.air and U.water.
void choose_phase(FoamCase& found) {
    std::string names;
    std::string first;
    const bool has_plain =
        std::ranges::any_of(found.fields, [](const FieldInfo& field) { return field.name == "U"; });
    for (const auto& field : found.fields)
        if (field.components == 3 && field.name.starts_with("U.")) {
            names += (names.empty() ? "" : ", ") + field.name;
            if (first.empty())
                first = field.name;
        }
    if (names.empty() || has_plain)
        return;
    found.velocity = first;
    if (names != found.velocity)
        add_note(found.note,
                 found.velocity + " is taken, of the phases " + names + ": choose with --velocity");
}

core::Result<FoamCase> scan_parts(FoamCase found, std::vector<std::string> parts) {
    found.parts = std::move(parts);
    auto regions = find_regions(found);
    if (!regions)
        return tl::unexpected(regions.error());
    found.regions = std::move(*regions);
    if (found.regions.empty())
        return core::fail(Error::Code::NotFound,
                          found.file + " has no mesh: constant/polyMesh/faces is not there",
                          "also copy the case's constant folder");
    if (auto times = find_foam_times(found); !times)
        return tl::unexpected(times.error());
    return found;
}

core::Result<FoamCase> better_of(FoamCase found, const std::vector<std::string>& processors) {
    auto serial = scan_parts(found, {""});
    if (processors.empty())
        return serial;
    auto decomposed = scan_parts(found, processors);
    const auto count = [](const auto& scanned) { return scanned ? scanned->times.size() : 0; };
    // A case that is still decomposed has its initial fields outside the processor folders, too.
    if (count(serial) == 0 || (!decomposed && count(serial) == 1))
        return decomposed;
    if (!decomposed && decomposed.error().code != Error::Code::NotFound) {
        add_note(serial->note, "its processor folders are left out: " + decomposed.error().message);
        return serial;
    }
    const bool whole = count(serial) >= count(decomposed);
    auto& chosen = whole ? serial : decomposed;
    add_note(chosen->note,
             (whole ? "read from the reconstructed time folders (" + std::to_string(count(serial)) +
                          "), not from the processors' (" + std::to_string(count(decomposed)) + ")"
                    : "read from the processor folders, which have " +
                          std::to_string(count(decomposed)) + " times; reconstructed are " +
                          std::to_string(count(serial))));
    return std::move(chosen);
}

} // namespace

fs::path openfoam_folder(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error))
        return path;
    const fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
    if (path.filename() != "controlDict")
        return folder;
    return folder.filename() == "system" && folder.has_parent_path() ? folder.parent_path()
                                                                     : folder / "..";
}

core::Result<FoamCase> scan_openfoam_case(const fs::path& path, const std::string& velocity) {
    FoamCase found;
    found.velocity = velocity;
    found.folder = openfoam_folder(path);
    std::error_code error;
    fs::path whole = fs::weakly_canonical(found.folder, error);
    if (!whole.has_filename())
        whole = whole.parent_path();
    found.name = whole.filename().string();
    found.file = fs::is_directory(path, error) ? found.name : path.filename().string();
    if (!fs::is_directory(found.folder, error))
        return core::fail(Error::Code::NotFound, found.file + " is not there");
    if (auto links = check_links(found.folder, found.file); !links)
        return tl::unexpected(links.error());
    const auto processors = processors_of(found);
    if (!processors)
        return tl::unexpected(processors.error());
    auto chosen = better_of(std::move(found), *processors);
    if (!chosen)
        return chosen;
    if (auto one = keep_times_of_last_mesh(*chosen); !one)
        return tl::unexpected(one.error());
    for (auto& region : chosen->regions)
        if (auto walls = find_patches(*chosen, region); !chosen->mesh_times.empty() && !walls)
            return tl::unexpected(walls.error());
    note_planes(*chosen);
    find_fields(*chosen);
    if (chosen->velocity.empty())
        choose_phase(*chosen);
    return chosen;
}

} // namespace wakesurf::importer
