// What of a session shows a field of a dataset beside its surfaces: slices and streamlines.
#include "core/surface/slice/plane_window.hpp"
#include "server/base/limits.hpp"
#include "server/data/node_fields.hpp"
#include "server/data/obstacle_mesh.hpp"
#include "server/data/slice_field.hpp"
#include "server/sessions/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

std::string& id_of(protocol::SliceRecord& record) {
    return record.slice;
}

std::string& id_of(protocol::LinesRecord& record) {
    return record.lines;
}

/// A field that is not there is a wrong argument here.
template <class Found>
core::Result<void> check_found(const core::Result<Found>& field) {
    if (field)
        return {};
    core::Error error = field.error();
    if (error.code == Error::Code::NotFound)
        error.code = Error::Code::InvalidArgument;
    return tl::unexpected(std::move(error));
}

core::Result<void> check_lines(const protocol::LinesRecord& record, const OpenDataset& dataset) {
    if (auto there =
            check_found(find_node_field(record.field, dataset.info, dataset.scalars.get()));
        !there)
        return there;
    const std::vector<core::BoundaryPatch>& patches = dataset.info.patches;
    std::size_t letters = 0;
    for (const std::string& name : record.places.patches) {
        if (std::ranges::find(patches, name, &core::BoundaryPatch::name) == patches.end())
            return tl::unexpected(no_patch(name, patches));
        letters += name.size();
    }
    // They are asked for in an address, where a byte may take three.
    if (3 * letters > limits::http_header_bytes / 2)
        return fail(Error::Code::InvalidArgument, "`patches`: the names are too long together",
                    "release the lines of some of them in a second set");
    if (core::of_walls(record.places.kind) && record.places.patches.empty() &&
        !dataset.info.obstacle)
        return fail(Error::Code::InvalidArgument, "`kind`: the data have no walls",
                    "release the lines from a line, a plane or a sphere");
    if (record.low.has_value() != record.high.has_value() ||
        (record.low && !(*record.low < *record.high)))
        return fail(Error::Code::InvalidArgument, "`low` and `high` are no range of colours",
                    "give both, the lower one first, or neither");
    return core::check_line_seeds(record.places, dataset.flow->domain());
}

/// Checks what a slice subtracts.
core::Result<void> check_minus(const protocol::SliceRecord& record,
                               const OpenDataset& dataset,
                               const Datasets& datasets) {
    if (record.minus_time && record.minus_offset)
        return fail(Error::Code::InvalidArgument,
                    "`minusTime` and `minusOffset` exclude each other",
                    "give the time of what is subtracted, or how much later it is");
    if (!record.minus && !record.minus_time && !record.minus_offset)
        return {};
    const auto other =
        record.minus ? datasets.open(*record.minus) : core::Result<OpenDataset>(dataset);
    if (!other)
        return tl::unexpected(other.error());
    if (auto there = check_found(subtracted_field(record.field, dataset.info, other->info,
                                                  other->scalars.get(), record.normal));
        !there)
        return there;
    const std::vector<double>& times = other->info.times;
    const bool beside =
        record.minus_time && times.size() > 1 &&
        !(*record.minus_time >= times.front() && *record.minus_time <= times.back());
    if (beside)
        return fail(Error::Code::InvalidArgument,
                    fmt::format("`minusTime` is {:g}, and {} has times from {:g} to {:g}",
                                *record.minus_time, other->info.name, times.front(), times.back()),
                    "give a time that is among them");
    return {};
}

} // namespace

/// Keeps a record of a field. An empty `field` is the velocity. @param check  of what the record says besides
template <class R, class Check>
core::Result<R>
Session::set_field_record(R record, bool is_new, const Author& author, const Check& check) {
    if (auto may = may_put({type_of_record<R>, id_of(record)}, is_new); !may)
        return tl::unexpected(may.error());
    const auto open = services_.datasets.open(record.dataset);
    if (!open)
        return tl::unexpected(open.error());
    if (record.field.empty())
        record.field = open->info.velocity;
    if (auto sound = check(record, *open); !sound)
        return tl::unexpected(sound.error());
    if (is_new)
        id_of(record) = records_.new_id(type_of_record<R>);
    if (auto sound = may_keep(record); !sound)
        return tl::unexpected(sound.error());
    edit({change_to(record)}, author);
    return *records_.find<R>(id_of(record));
}

core::Result<protocol::SliceRecord> Session::set_slice(const protocol::SliceSetting& setting,
                                                       const Author& author) {
    const protocol::SliceRecord record{setting.slice.value_or(""),
                                       0,
                                       setting.dataset,
                                       setting.origin,
                                       setting.normal,
                                       setting.field.value_or(""),
                                       setting.minus,
                                       setting.minus_time,
                                       setting.minus_offset};
    return set_field_record(
        record, !setting.slice, author,
        [this](const protocol::SliceRecord& made, const OpenDataset& dataset) {
            return check_found(
                       slice_field(made.field, dataset.info, dataset.scalars.get(), made.normal))
                .and_then([&] {
                    return core::plane_window({made.origin, made.normal}, dataset.flow->domain());
                })
                .and_then([&](const core::PlaneWindow&) {
                    return check_minus(made, dataset, services_.datasets);
                });
        });
}

core::Result<protocol::LinesRecord> Session::set_lines(const protocol::LinesSetting& setting,
                                                       const Author& author) {
    const protocol::LinesRecord record{setting.lines.value_or(""),
                                       0,
                                       setting.dataset,
                                       setting.places,
                                       setting.direction,
                                       setting.duration,
                                       setting.length,
                                       setting.low,
                                       setting.high,
                                       setting.field.value_or("")};
    return set_field_record(record, !setting.lines, author, check_lines);
}

} // namespace wakesurf::server
