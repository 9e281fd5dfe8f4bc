// A NetCDF file of any of its versions: the list of what is in it, then its first time-step on its axes.
#include "server/import/sources/netcdf_source.hpp"
#include "tests/fuzz/targets/all.hpp"
#include "tests/fuzz/targets/scratch_file.hpp"

#include <vtk_netcdf.h>

namespace wakesurf::fuzz {

namespace {

/// u, v and w on 2 x 2 x 2 nodes at one time, with units.
std::string small_file() {
    const auto path = scratch_file("seed.nc", "");
    int file = 0;
    nc_create(path.c_str(), NC_CLOBBER, &file);
    int dimensions[4] = {};
    static const char* const names[] = {"time", "z", "y", "x"};
    static const std::size_t sizes[] = {1, 2, 2, 2};
    int axes[4] = {};
    for (int i = 0; i < 4; ++i) {
        nc_def_dim(file, names[i], sizes[i], &dimensions[i]);
        nc_def_var(file, names[i], NC_DOUBLE, 1, &dimensions[i], &axes[i]);
        const std::string unit = i == 0 ? "hours since 2000-01-01" : "km";
        nc_put_att_text(file, axes[i], "units", unit.size(), unit.data());
    }
    int fields[3] = {};
    for (int i = 0; i < 3; ++i) {
        const std::string name(1, static_cast<char>('u' + i)), unit = "m s-1";
        nc_def_var(file, name.c_str(), NC_FLOAT, 4, dimensions, &fields[i]);
        nc_put_att_text(file, fields[i], "units", unit.size(), unit.data());
    }
    nc_enddef(file);
    const double values[] = {0.0, 1.0};
    const float ones[] = {1, 1, 1, 1, 1, 1, 1, 1};
    for (const int axis : axes)
        nc_put_var_double(file, axis, values);
    for (const int field : fields)
        nc_put_var_float(file, field, ones);
    nc_close(file);
    return tests::read_file(path);
}

} // namespace

void netcdf(Input input) {
    server::open_netcdf(scratch_file("a.nc", text_of(input)));
}

std::vector<std::string> netcdf_seeds() {
    const std::string whole = small_file();
    return {whole, whole.substr(0, whole.size() / 2), "CDF\1"};
}

} // namespace wakesurf::fuzz
