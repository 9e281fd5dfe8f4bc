#include "server/session/records/surface_rules.hpp"

#include "core/field/velocity_gradient.hpp"
#include "core/surface/surface_request.hpp"
#include "core/surface/vertex_attributes.hpp"
#include "server/session/data/surface_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

core::Result<void> wrong(const std::string& message, const std::string& hint) {
    return fail(Error::Code::InvalidArgument, message, hint);
}

} // namespace

core::Result<void> check_kind(const protocol::SurfaceSetting& setting) {
    const core::SurfaceParameters& p = setting.parameters;
    const bool time = p.kind == core::SurfaceKind::Time;
    if (p.release_until && p.kind != core::SurfaceKind::Streak)
        return wrong("`releaseUntil` belongs to streak surfaces", "leave it out");
    if (setting.rake2 && !time)
        return wrong("`rake2` belongs to time surfaces", "leave it out");
    if (p.sweep && !time)
        return wrong("`sweep` belongs to time surfaces", "leave it out");
    if (time && setting.rake2.has_value() == p.sweep.has_value())
        return wrong("a time surface takes one of `rake2` and `sweep`",
                     "the patch lies between two rakes, or is one swept along a vector");
    if (setting.rake2 == setting.rake)
        return wrong("`rake2` is the rake itself", "name another rake of the session");
    if (p.sweep == core::Vec3(0.0))
        return wrong("`sweep` has no length", "give a vector that is not zero");
    if (p.release_until) {
        const double released = *p.release_until - p.from;
        const double shown = p.to - p.from;
        if (!(released * shown > 0.0) || std::abs(released) > std::abs(shown))
            return wrong(fmt::format("`releaseUntil` {} does not lie between `from` {} and `to` {}",
                                     *p.release_until, p.from, p.to),
                         "leave it out to release until `to`");
    }
    return {};
}

core::Result<void> complete_surface(protocol::SurfaceSetting& setting, const OpenDataset& dataset) {
    core::SurfaceParameters& p = setting.parameters;
    if (auto sound = check_kind(setting); !sound)
        return sound;
    std::vector<std::string> fields;
    for (const std::string& name : setting.fields) {
        if (auto known = find_field(dataset, name); !known)
            return tl::unexpected(known.error());
        if (std::ranges::find(fields, name) == fields.end())
            fields.push_back(name);
    }
    setting.fields = std::move(fields);
    if (p.separation == 0.0)
        p.separation = dataset.flow->finest_spacing();
    return core::check_separation(*dataset.flow, p.separation);
}

} // namespace wakesurf::server
