// NetCDF files for tests, written with the netCDF library.
#pragma once

#include "tests/importer/known_flow.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace wakesurf::importer {

using Names = std::vector<std::string>;

// A file under construction; every netCDF call is checked.
class NetcdfWriter {
  public:
    explicit NetcdfWriter(const std::filesystem::path& file, int format = NC_NETCDF4) {
        ok(nc_create(file.c_str(), NC_CLOBBER | format, &id_));
        nc_set_fill(id_, NC_NOFILL, nullptr);
    }

    ~NetcdfWriter() { ok(nc_close(id_)); }

    NetcdfWriter(const NetcdfWriter&) = delete;
    NetcdfWriter& operator=(const NetcdfWriter&) = delete;

    static void ok(int status) { ASSERT_EQ(status, NC_NOERR) << nc_strerror(status); }

    void dimension(const std::string& name, std::size_t length) {
        int dimension = 0;
        ok(nc_def_dim(id_, name.c_str(), length, &dimension));
        dimensions_[name] = dimension;
    }

    int variable(const std::string& name, nc_type type, const Names& dimensions) {
        std::vector<int> ids;
        for (const auto& dimension : dimensions)
            ids.push_back(dimensions_.at(dimension));
        int variable = 0;
        ok(nc_def_var(id_, name.c_str(), type, static_cast<int>(ids.size()), ids.data(),
                      &variable));
        return variable;
    }

    void text(int variable, const char* attribute, const std::string& value) {
        ok(nc_put_att_text(id_, variable, attribute, value.size(), value.c_str()));
    }

    void number(int variable, const char* attribute, nc_type type, double value) {
        ok(nc_put_att_double(id_, variable, attribute, type, 1, &value));
    }

    void end() { nc_enddef(id_); }

    void put(int variable,
             const std::vector<std::size_t>& start,
             const std::vector<std::size_t>& count,
             const std::vector<double>& values) {
        ok(nc_put_vara_double(id_, variable, start.data(), count.data(), values.data()));
    }

    void text_values(int variable, const std::string& values) {
        ok(nc_put_var_text(id_, variable, values.c_str()));
    }

    void put(int variable, const std::vector<double>& values) {
        put(variable, {0}, {values.size()}, values);
    }

  private:
    int id_ = 0;
    std::map<std::string, int> dimensions_;
};

struct Flow {
    int format = NC_NETCDF4;
    Names order{"time", "z", "y", "x"};
    nc_type type = NC_DOUBLE;
    std::map<std::string, std::vector<double>> axes{
        {"x", {0, 0.5, 1, 1.5}}, {"y", {-1, 0, 1, 2, 3}}, {"z", {2, 2.25, 2.5}}};
    std::vector<double> times{0.5, 1.5, 4};
    double scale = 0;                           // packed where not 0
    std::map<std::string, std::string> units{}; ///< of axes; of the velocity m s-1 where not named
    bool with_axis_attributes = true;
    std::string time_units = "seconds since 2000-01-01 00:00:00";
    std::string calendar{};
    Names velocity{"u", "v", "w"};
};

// Returns the raw value of component c at (x, y, z) of step t; `spoil` may replace it.
using Spoil = std::function<void(std::size_t index, double& raw)>;

inline void
write_flow(const std::filesystem::path& file, const Flow& flow, const Spoil& spoil = {}) {
    NetcdfWriter out(file, flow.format);
    out.dimension("time", NC_UNLIMITED);
    std::map<std::string, int> coordinates;
    for (const auto& [name, nodes] : flow.axes)
        out.dimension(name, nodes.size());
    const int time = out.variable("time", NC_DOUBLE, {"time"});
    if (!flow.time_units.empty())
        out.text(time, "units", flow.time_units);
    if (!flow.calendar.empty())
        out.text(time, "calendar", flow.calendar);
    for (const auto& [name, nodes] : flow.axes) {
        coordinates[name] = out.variable(name, NC_DOUBLE, {name});
        if (flow.with_axis_attributes)
            out.text(coordinates[name], "axis", std::string(1, static_cast<char>(name[0] - 32)));
        if (flow.units.contains(name))
            out.text(coordinates[name], "units", flow.units.at(name));
    }
    std::vector<int> variables;
    for (const auto& name : flow.velocity) {
        variables.push_back(out.variable(name, flow.type, flow.order));
        const auto stated = flow.units.find(name);
        if (const std::string units = stated == flow.units.end() ? "m s-1" : stated->second;
            !units.empty())
            out.text(variables.back(), "units", units);
        if (flow.scale > 0) {
            out.number(variables.back(), "scale_factor", NC_DOUBLE, flow.scale);
            out.number(variables.back(), "add_offset", NC_DOUBLE, 1.0);
            out.number(variables.back(), "_FillValue", flow.type, -32768);
        }
    }
    out.end();
    for (const auto& [name, nodes] : flow.axes)
        out.put(coordinates[name], nodes);
    out.put(time, flow.times);
    for (std::size_t t = 0; t < flow.times.size(); ++t) {
        std::vector<std::size_t> start, count;
        for (const auto& name : flow.order) {
            start.push_back(name == "time" ? t : 0);
            count.push_back(name == "time" ? 1 : flow.axes.at(name).size());
        }
        std::size_t total = 1;
        for (const auto n : count)
            total *= n;
        for (std::size_t c = 0; c < 3; ++c) {
            std::vector<double> values(total);
            for (std::size_t i = 0; i < total; ++i) {
                std::map<std::string, double> p{{"x", 0}, {"y", 0}, {"z", 0}};
                std::size_t rest = i;
                for (std::size_t d = flow.order.size(); d-- > 0; rest /= count[d])
                    if (flow.order[d] != "time")
                        p[flow.order[d]] = flow.axes.at(flow.order[d])[rest % count[d]];
                const std::array<double, 3> at{p["x"], p["y"], p["z"]};
                values[i] = tests::known_velocity(at.data(), static_cast<int>(t))[c];
                if (flow.scale > 0)
                    values[i] = std::round((values[i] - 1.0) / flow.scale);
                if (spoil)
                    spoil(i, values[i]);
            }
            out.put(variables[c], start, count, values);
        }
    }
}

/// Returns a file of the classic format with one dimension, whose name has this many bytes: the library
/// writes no more than 256.
inline std::string file_with_name(std::size_t bytes) {
    const auto number = [](std::uint32_t value) {
        std::string out;
        for (int shift = 24; shift >= 0; shift -= 8)
            out.push_back(static_cast<char>(value >> shift & 0xff));
        return out;
    };
    constexpr std::uint32_t dimensions = 10; // the tag of their list
    const std::string none = number(0) + number(0);
    return "CDF\1" + number(0) + number(dimensions) + number(1) +
           number(static_cast<std::uint32_t>(bytes)) + std::string((bytes + 3) / 4 * 4, 'a') +
           number(4) + none + none;
}

} // namespace wakesurf::importer
