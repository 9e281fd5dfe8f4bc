// The values of a field's file, text and binary, plain and compressed. VTK's reader is asked for the mesh only: it
// takes a field's name from inside the file, fails on dimensions that name units, "[m s^-1]", and on entries for
// groups of patches.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct FoamValues {
    std::vector<float> inside; ///< the value of one cell, if it counts for all, or of each
    /// The values of faces, by patch, likewise; patches without a value are left out.
    std::map<std::string, std::vector<float>> patches;
};

/// Reads the values. Error: Corrupt, Unsupported (numbers of another machine). @param name  of the file in
/// messages
core::Result<FoamValues>
read_foam_values(const std::filesystem::path& file, const std::string& name, int components);

} // namespace wakesurf::importer
