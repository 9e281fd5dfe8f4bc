// The values of a field's file, read without VTK: its reader stops at dimensions that name units, "[m s^-1]", as OpenFOAM writes them
// since version 10. Text and binary, plain and compressed.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct FoamValues {
    std::vector<float> inside; ///< of one cell, where it counts for all, or of each
    std::map<std::string, std::vector<float>>
        patches; ///< likewise of their faces; without those that state no value
};

/// @param name  of the file in messages. Error: Corrupt, Unsupported (numbers of another machine).
core::Result<FoamValues>
read_foam_values(const std::filesystem::path& file, const std::string& name, int components);

} // namespace wakesurf::importer
