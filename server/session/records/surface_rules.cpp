#include "server/session/records/surface_rules.hpp"

#include "core/surface/surface_request.hpp"
#include "core/surface/time_direction.hpp"
#include "server/session/data/surface_fields.hpp"

#include <algorithm>

namespace wakesurf::server {

core::Result<void> complete_surface(protocol::SurfaceSetting& setting, const OpenDataset& dataset) {
    core::SurfaceParameters& p = setting.parameters;
    if (auto sound = protocol::check_rules(setting); !sound)
        return sound;
    if (auto sound = core::check_direction(p); !sound)
        return sound;
    p.direction = core::direction_of(p);
    if (auto there = core::check_interpolation(*dataset.flow, p.interpolation); !there)
        return there;
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
