// A NetCDF file of any of its classic versions: the list of what is in it, then its last time-step on its axes. NetCDF-4 is HDF5, whose
// library crashes on damaged files (1.10.8 on one of 2,000): the importer runs it in a process of its own and says so.
#include "importer/sources/files/formats.hpp"
#include "tests/fuzz/targets/all.hpp"
#include "tests/fuzz/targets/scratch_file.hpp"
#include "tests/importer/netcdf_files.hpp"

#include <algorithm>
#include <functional>

namespace wakesurf::fuzz {

namespace {

std::string file_of(const importer::Flow& flow) {
    const auto path = scratch_file("seed.nc", "");
    importer::write_flow(path, flow);
    return tests::read_file(path);
}

importer::Flow small_flow(int format) {
    importer::Flow flow;
    flow.format = format;
    flow.type = NC_FLOAT;
    flow.axes = {{"x", {0, 0.5, 1}}, {"y", {-1, 0, 1}}, {"z", {2, 3, 5}}};
    flow.times = {0.5, 1.5};
    flow.units = {{"x", "km"}, {"y", "m"}, {"u", "cm s-1"}};
    return flow;
}

void run(Input input) {
    if (text_of(input).starts_with("\x89HDF"))
        return;
    const auto source = importer::open_netcdf(scratch_file("a.nc", text_of(input)));
    if (!source)
        return;
    const auto& found = (*source)->description();
    demand(std::adjacent_find(found.times.begin(), found.times.end(), std::greater_equal<>()) ==
               found.times.end(),
           "times rise");
    const auto last = (*source)->read(found.times.size() - 1, found.fields);
    if (last)
        for (const auto& field : found.fields)
            demand(last->blocks.front()->GetPointData()->HasArray(field.name.c_str()) != 0,
                   "a step that was read has the fields that were asked for");
}

std::vector<std::string> seeds() {
    std::vector<std::string> seeds;
    for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA})
        seeds.push_back(file_of(small_flow(format)));
    auto packed = small_flow(0);
    packed.type = NC_SHORT;
    packed.scale = 0.01;
    packed.time_units = "hours since 2000-01-01 00:00:00";
    packed.axes["z"] = {5, 3, 2};
    seeds.push_back(file_of(packed));
    auto bare = small_flow(0);
    bare.with_axis_attributes = false;
    bare.order = {"time", "x", "y", "z"};
    bare.time_units = "";
    seeds.push_back(file_of(bare));
    seeds.push_back(seeds.front().substr(0, seeds.front().size() / 2));
    seeds.push_back(importer::file_with_name(400));
    std::string streamed = seeds.front(); // as many time-steps as a number can say
    seeds.push_back(streamed.replace(4, 4, 4, '\xff'));
    std::string twice = seeds.front(); // u has the name of the axis
    twice.at(twice.find(std::string{0, 0, 0, 1, 'u', 0, 0, 0}) + 4) = 'x';
    seeds.push_back(twice);
    auto endless = small_flow(0);
    endless.units["x"] = "1e308 m";
    endless.axes["x"] = {0, 1, 10};
    seeds.push_back(file_of(endless));
    return seeds;
}

} // namespace

const Target netcdf_target{"netcdf", run, seeds};

} // namespace wakesurf::fuzz
