#include "server/live/announced_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wakesurf::server {

namespace {

constexpr double same_length = 1e-6; ///< relative: ends of time are sums and rounded

void append(ValueRanges& to,
            std::string_view attribute,
            const std::vector<double>& values,
            std::span<const float> areas) {
    if (const auto range = core::value_range(values, areas))
        to.push_back({std::string(attribute), *range});
}

AnnouncedRange* find(ValueRanges& ranges, const std::string& attribute) {
    const auto found = std::ranges::find(ranges, attribute, &AnnouncedRange::attribute);
    return found == ranges.end() ? nullptr : &*found;
}

ValueRanges joined(ValueRanges all, const ValueRanges& more) {
    for (const AnnouncedRange& each : more) {
        if (AnnouncedRange* held = find(all, each.attribute))
            held->range = core::joined(held->range, each.range);
        else
            all.push_back(each);
    }
    return all;
}

} // namespace

ValueRanges ranges_of(const SurfaceJob& job,
                      const core::QuadComplex& mesh,
                      const protocol::MeshFields& fields,
                      double time) {
    ValueRanges out;
    const std::vector<float> areas = core::vertex_areas(mesh);
    std::vector<double> values(mesh.vertices());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = mesh.speed(static_cast<core::VertexId>(i));
    append(out, protocol::surface_attributes[0], values, areas);
    const bool released = job.plan.parameters.kind == core::SurfaceKind::Streak;
    std::ranges::transform(mesh.t, values.begin(),
                           [&](double t) { return released ? time - t : t; });
    append(out, protocol::surface_attributes[2], values, areas);
    if (!out.empty() && out.back().attribute == protocol::surface_attributes[2]) {
        core::ValueRange& age = out.back().range;
        age.low = age.least;
        age.high = age.greatest;
    }
    for (std::size_t k = 0; k < fields.size() && k < job.fields.size(); ++k) {
        values.assign(fields[k].begin(), fields[k].end());
        append(out, job.fields[k].name, values, areas);
    }
    return out;
}

bool plays_on(const SurfaceJob& before, const SurfaceJob& now) {
    core::SurfaceParameters p = before.plan.parameters;
    const double length = p.to - p.from,
                 length_now = now.plan.parameters.to - now.plan.parameters.from;
    const bool as_long = std::abs(length_now - length) <= same_length * std::abs(length);
    if (p.kind == core::SurfaceKind::Stream && as_long) {
        p.from = now.plan.parameters.from;
        p.to = now.plan.parameters.to;
    }
    p.deformation = now.plan.parameters.deformation;
    p.tangents = now.plan.parameters.tangents;
    return before.plan.flow == now.plan.flow && before.plan.rake == now.plan.rake &&
           p == now.plan.parameters;
}

void AnnouncedRanges::begin() {
    full_.clear();
}

bool AnnouncedRanges::add(const ValueRanges& ranges, bool early) {
    ValueRanges all = joined(full_, ranges);
    if (!early)
        full_ = all;
    if (all == announced_)
        return false;
    announced_ = std::move(all);
    return true;
}

} // namespace wakesurf::server
