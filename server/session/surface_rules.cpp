#include "server/session/surface_rules.hpp"

#include "protocol/surface_names.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace wakesurf::server {

using core::Error;
using core::fail;

core::Result<void> complete_surface(protocol::SurfaceSetting& setting, const OpenDataset& dataset) {
    core::SurfaceParameters& p = setting.parameters;
    if (p.kind != core::SurfaceKind::Stream && p.kind != core::SurfaceKind::Path)
        return fail(Error::Code::Unsupported,
                    fmt::format("{} surfaces are not offered yet", protocol::name(p.kind)),
                    "use stream or path");
    for (const std::string& field : setting.fields) {
        const auto named = [&](const core::FieldInfo& each) { return each.name == field; };
        if (std::none_of(dataset.info.fields.begin(), dataset.info.fields.end(), named))
            return fail(Error::Code::InvalidArgument,
                        "`fields` names a field the dataset does not have",
                        "dataset.describe lists the fields");
    }
    if (p.separation == 0.0)
        p.separation = dataset.flow->finest_spacing();
    return {};
}

} // namespace wakesurf::server
