#include "importer/sources/openfoam/openfoam_case.hpp"

#include "importer/sources/openfoam/openfoam_file.hpp"

namespace wakesurf::importer {

namespace fs = std::filesystem;

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
