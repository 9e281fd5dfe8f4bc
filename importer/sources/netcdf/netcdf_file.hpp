// A NetCDF file (classic, 64-bit, NetCDF-4) read with the netCDF library itself: VTK's reader turns packed
// fill values into velocities. Packing and missing values as in the CF conventions 1.8, sections 2.5.1 and
// 8.1. Variables and dimensions of groups are listed with those of the file: by their names alone where these
// are clear, else as "group/name".
#pragma once

#include "importer/sources/series/file_series.hpp"

#include <netcdf.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct NetcdfDimension {
    std::string name;
    std::size_t length = 0;
};

struct NetcdfVariable {
    int id = 0;
    std::string name;
    nc_type type = NC_NAT;
    std::vector<int> dimensions; ///< indices, slowest first
    int group = 0;               ///< the library's number of its group
};

inline bool has_numbers(const NetcdfVariable& variable) {
    return variable.type != NC_CHAR && variable.type < NC_STRING;
}

/// Returns the name without its groups.
inline std::string last_of_path(const std::string& name) {
    return name.substr(name.find_last_of('/') + 1);
}

/// Reads one file. Not thread-safe. All errors name the file.
class NetcdfFile {
  public:
    /// Error: Io, Corrupt (not NetCDF, cut off).
    static core::Result<NetcdfFile> open(const ListedFile& file);

    const std::vector<NetcdfDimension>& dimensions() const { return dimensions_; }

    const std::vector<NetcdfVariable>& variables() const { return variables_; }

    const NetcdfVariable* variable(const std::string& name) const;

    const std::string& name() const { return name_; }

    /// Has the attributes of the whole file, as a variable without values.
    NetcdfVariable whole() const { return {NC_GLOBAL, {}, NC_NAT, {}, *id_}; }

    /// Returns a text attribute; "" if it is missing, or no text.
    std::string text(const NetcdfVariable& variable, const char* attribute) const;

    /// Returns a numeric attribute; empty if it is missing, or text.
    std::vector<double> numbers(const NetcdfVariable& variable, const char* attribute) const;

    /// Returns `count` values from `start` along each dimension, unpacked; NaN for fill values, missing
    /// values and those outside the valid range. Error: Corrupt, OverLimit (memory).
    core::Result<std::vector<double>> read(const NetcdfVariable& variable,
                                           const std::vector<std::size_t>& start,
                                           const std::vector<std::size_t>& count) const;

    /// Returns the texts of a variable of text, of one dimension or more: the last of characters counts within
    /// each. Empty if they cannot be read, or are more than a million characters.
    std::vector<std::string> texts(const NetcdfVariable& variable) const;

    /// Returns all values of a variable.
    core::Result<std::vector<double>> read(const NetcdfVariable& variable) const;

  private:
    struct Closer {
        void operator()(const int* id) const {
            nc_close(*id);
            delete id;
        }
    };

    struct Listing;
    core::Result<void> list();
    core::Result<void> list_group(int group, const std::string& path, Listing& listing) const;

    std::string name_;
    std::unique_ptr<int, Closer> id_;
    std::vector<NetcdfDimension> dimensions_;
    std::vector<NetcdfVariable> variables_;
};

} // namespace wakesurf::importer
