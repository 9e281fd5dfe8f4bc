#include "server/data/probe.hpp"

#include "core/base/rounding.hpp"
#include "core/field/sampled_field.hpp"
#include "server/data/node_fields.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <limits>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

/// Which points are in the fluid, and have a velocity then.
core::Result<std::vector<bool>>
inside(const core::Flow& flow, const ProbeRequest& request, const std::stop_token& stop) {
    const std::vector<double> times(request.points.size(), request.time);
    std::vector<std::uint8_t> gap(request.points.size());
    return flow.mark_gaps(request.points, times, gap, stop).map([&] {
        std::vector<bool> out;
        for (std::size_t i = 0; i < gap.size(); ++i)
            out.push_back(gap[i] == 0 &&
                          flow.status(request.points[i]) == core::PointStatus::Inside);
        return out;
    });
}

core::Result<ProbeField> sample(const ProbedData& data,
                                const std::string& name,
                                const std::vector<core::Vec3>& places,
                                double time,
                                const std::stop_token& stop) {
    if (name == data.info.velocity) {
        ProbeField out{name, std::vector<core::Vec3>(places.size()), {}};
        const std::vector<double> times(places.size(), time);
        return data.flow.sample(places, times, out.vectors, stop).map([&] {
            return std::move(out);
        });
    }
    return find_node_field(name, data.info, data.scalars, "fields")
        .and_then([&](const NodeField& field) {
            return core::sample_field(sampled(field, data.scalars), data.flow, places, time, stop);
        })
        .map([&](std::vector<float> values) {
            return ProbeField{name, {}, std::move(values)};
        });
}

/// Values of the points that are inside, as values of all of them: outside a flow answers with the value at the nearest place, which is no
/// measurement.
template <class Value>
std::vector<Value>
spread(const std::vector<Value>& values, const std::vector<bool>& inside, const Value& nothing) {
    std::vector<Value> out(inside.size(), nothing);
    std::size_t next = 0;
    for (std::size_t i = 0; i < inside.size(); ++i)
        if (inside[i])
            out[i] = values[next++];
    return out;
}

} // namespace

core::Result<ProbeResult>
probe(const ProbedData& data, const ProbeRequest& asked, const std::stop_token& stop) {
    ProbeRequest request = asked;
    for (core::Vec3& point : request.points)
        point = core::onto_faces(point, data.flow.domain());
    if (const auto range = data.flow.time_bounds();
        range && !core::within_rounding(request.time, (*range)[0], (*range)[1]))
        return fail(Error::Code::OutOfTime,
                    fmt::format("time {} is outside the data's {} to {}", request.time, (*range)[0],
                                (*range)[1]),
                    "choose `time` inside it");
    auto found = inside(data.flow, request, stop);
    if (!found)
        return tl::unexpected(found.error());
    ProbeResult result{std::move(*found), {}};
    std::vector<core::Vec3> places;
    for (std::size_t i = 0; i < result.inside.size(); ++i)
        if (result.inside[i])
            places.push_back(request.points[i]);
    const auto wanted = request.fields.empty() ? std::vector{data.info.velocity} : request.fields;
    for (const std::string& name : wanted) {
        auto field = sample(data, name, places, request.time, stop);
        if (!field)
            return tl::unexpected(field.error());
        constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
        if (name == data.info.velocity)
            field->vectors = spread(field->vectors, result.inside, core::Vec3(nothing));
        else
            field->scalars = spread(field->scalars, result.inside, nothing);
        result.fields.push_back(std::move(*field));
    }
    return result;
}

} // namespace wakesurf::server
