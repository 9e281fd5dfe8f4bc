#include "server/service/session/data/dataset_mark.hpp"

#include "server/service/base/secret.hpp"

#include <fmt/format.h>

namespace wakesurf::server {

namespace {

/// Coordinates as they are in single precision, so that a store of either precision has the same.
std::string words(const core::DatasetInfo& info) {
    const auto& [lo, hi] = info.bounds;
    std::string out = fmt::format("{} {} {} {} {} {} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {}",
                                  static_cast<int>(info.grid), info.dimensions[0],
                                  info.dimensions[1], info.dimensions[2], info.points, info.cells,
                                  lo.x, lo.y, lo.z, hi.x, hi.y, hi.z, info.velocity);
    if (info.grid == core::GridKind::Analytic)
        out += " " + info.name;
    for (const core::FieldInfo& each : info.fields)
        if (!each.family) // anybody may make one of the same data
            out += fmt::format(";{}:{}", each.name, each.components);
    return out;
}

} // namespace

protocol::DatasetMark mark_of(const OpenDataset& dataset) {
    const core::DatasetInfo& info = dataset.info;
    protocol::DatasetMark mark;
    mark.dataset = info.dataset;
    mark.name = info.name;
    mark.fingerprint = digest_text(secret_digest(words(info)));
    if (dataset.store != nullptr)
        mark.values = dataset.store->values();
    mark.steps = info.times.size();
    if (!info.times.empty()) {
        mark.first = info.times.front();
        mark.last = info.times.back();
    }
    mark.bounds = info.bounds;
    return mark;
}

} // namespace wakesurf::server
