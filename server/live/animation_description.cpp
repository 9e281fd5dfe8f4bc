#include "server/live/animation_description.hpp"

#include "core/base/plain_text.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "core/surface/time_direction.hpp"
#include "protocol/api/generated/names.hpp"
#include "protocol/wire/mesh_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace wakesurf::server {

namespace {

std::string with_unit(std::string words, const std::string& unit) {
    return unit.empty() ? words : fmt::format("{} ({})", words, unit);
}

std::string length_text(double value, const core::DatasetInfo& dataset) {
    return fmt::format("{:.2g}{}{}", value, dataset.length_unit.empty() ? "" : " ",
                       dataset.length_unit);
}

std::string
title_of(const std::string& name, const SurfaceJob& job, const core::DatasetInfo& dataset) {
    if (name == protocol::surface_attributes[0])
        return with_unit("Speed", core::unit_of(dataset, dataset.velocity));
    if (name == protocol::surface_attributes[2])
        return job.plan.parameters.kind == core::SurfaceKind::Time
                   ? "Position across the patch"
                   : with_unit("Age", dataset.time_unit);
    if (name == core::deformation_name)
        return "Stretching (log₂ of area)";
    if (name == core::error_name)
        return with_unit("Estimated error", dataset.length_unit);
    return with_unit(name, core::unit_of(dataset, name));
}

/// Names of values with a sign that says something.
bool is_signed(const AnnouncedRange& value) {
    return value.range.least < 0.0 && value.range.greatest > 0.0;
}

std::vector<protocol::AnimationDescription::Value> values_of(const SurfaceAnimation& animation,
                                                             const SurfaceJob& job,
                                                             const core::DatasetInfo& dataset) {
    std::vector<protocol::AnimationDescription::Value> values;
    const bool released = job.plan.parameters.kind != core::SurfaceKind::Level;
    for (const AnnouncedRange& each : animation.ranges)
        if (released || each.attribute != protocol::surface_attributes[2])
            values.push_back({each.attribute,
                              title_of(each.attribute, job, dataset),
                              {each.range.low, each.range.high},
                              is_signed(each)});
    // Fields were asked for, so they come first.
    std::ranges::rotate(values,
                        values.begin() + std::min<std::ptrdiff_t>(values.size(), released ? 2 : 1));
    return values;
}

std::vector<std::string> facts_of(const SurfaceAnimation& animation,
                                  const SurfaceJob& job,
                                  const core::DatasetInfo& dataset,
                                  const std::string& version) {
    const core::SurfaceParameters& p = job.plan.parameters;
    const core::SurfaceStatistics& s = animation.last.statistics;
    std::vector<std::string> facts;
    const std::string unit = dataset.time_unit.empty() ? "" : " " + dataset.time_unit;
    facts.push_back(fmt::format(
        "A {} surface of {}, from {} to {}{}, separation {}, accuracy {}, by wakesurf {}.",
        protocol::name(p.kind), dataset.name, core::time_text(p.from), core::time_text(p.to), unit,
        length_text(s.separation, dataset), protocol::name(p.accuracy), version));
    facts.push_back(fmt::format("{} steps, up to {} vertices each.", animation.times.size(),
                                animation.most_vertices));
    if (s.error)
        facts.push_back(fmt::format(
            "Tracing error at the last step: 99 % of the vertices are within {} of the surface of "
            "the interpolated flow{}.",
            length_text(s.error->error99, dataset),
            s.error->uncertain > 0
                ? fmt::format("; {} of {} are uncertain", s.error->uncertain, s.vertices)
                : ""));
    else
        facts.push_back("Tracing error: none was estimated.");
    if (s.interval_error)
        facts.push_back(fmt::format(
            "Error between stored times at the last step: 99 % of the vertices that are resolved "
            "are within {}; {:.0f} % are not resolved.",
            length_text(s.interval_error->error99, dataset), 100.0 * s.interval_error->unresolved));
    else
        facts.push_back("Error between stored times: none is stated, because " +
                        (s.interval_left_out.empty() ? std::string("it was not estimated")
                                                     : s.interval_left_out) +
                        ".");
    const protocol::Tolerance t = protocol::live_tolerance;
    const double off = std::sqrt(3.0) * (t.position + 0.5) * job.lattice.step;
    const core::Vec3 extent = dataset.bounds.extent();
    facts.push_back(fmt::format(
        "This file moves vertices by up to {}, 1/{:.0f} of the domain's longest side, and rounds "
        "values to 1/{:.0f} of their range.",
        length_text(off, dataset), std::max({extent.x, extent.y, extent.z}) / off,
        65535.0 / (t.speed + 0.5)));
    return facts;
}

} // namespace

protocol::AnimationDescription description_of(const SurfaceAnimation& animation,
                                              const SurfaceJob& job,
                                              const core::DatasetInfo& dataset,
                                              const std::string& version) {
    const core::Box& box = dataset.bounds;
    std::vector<std::string> attributes(protocol::surface_attributes.begin(),
                                        protocol::surface_attributes.end());
    for (const SurfaceField& field : job.fields)
        attributes.push_back(field.name);
    const core::SurfaceParameters& p = job.plan.parameters;
    return {.title = fmt::format("{}: {} surface", core::display_name(dataset.name, 200),
                                 protocol::name(p.kind)),
            .kind = std::string(protocol::name(p.kind)),
            .from = p.from,
            .bounds = {box.lo.x, box.hi.x, box.lo.y, box.hi.y, box.lo.z, box.hi.z},
            .lattice_origin = job.lattice.origin,
            .lattice_step = job.lattice.step,
            .lattice_bits = static_cast<int>(job.lattice.bits),
            .attributes = std::move(attributes),
            .values = values_of(animation, job, dataset),
            .times = animation.times,
            .length_unit = core::display_name(dataset.length_unit, 40),
            .time_unit = core::display_name(dataset.time_unit, 40),
            .facts = facts_of(animation, job, dataset, version)};
}

} // namespace wakesurf::server
