#include "server/net/slice_downloads.hpp"

#include "core/surface/measures/region.hpp"
#include "core/surface/slice/slice_raster.hpp"
#include "protocol/wire/slice_file.hpp"
#include "server/base/limits.hpp"
#include "server/data/node_fields.hpp"
#include "server/data/open_dataset.hpp"
#include "server/data/region_text.hpp"
#include "server/data/slice_field.hpp"
#include "server/net/download_request.hpp"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <variant>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

/// Up to so many samples of the velocity a raster is a quick job, of some 10 ms; those of other fields cost up to ten times as much.
constexpr std::size_t quick_samples = 120'000;

core::Result<std::size_t> read_samples(const std::string& text) {
    std::size_t samples = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, samples);
    if (read.ec != std::errc{} || read.ptr != end || samples < 1 || samples > limits::slice_samples)
        return fail(
            Error::Code::InvalidArgument,
            fmt::format("`samples` is not a whole number from 1 to {}", limits::slice_samples),
            "?samples=640 takes 640 along the longer side");
    return samples;
}

core::Result<core::Plane> read_plane(const std::string& text) {
    return parse_region("plane:" + text, "`plane`")
        .map([](const core::Region& region) { return std::get<core::Plane>(region); })
        .map_error([](Error error) {
            error.hint = "write ?plane=0,0,0:1,0,0, a point and the normal";
            return error;
        });
}

/// What is sampled, and where.
struct Sampled {
    core::SliceRequest request;
    std::shared_ptr<const LoadedDataset> dataset; ///< keeps what the field needs
};

/// Holds the input of a file.
struct SliceWork {
    Sampled sampled;
    std::optional<Sampled> minus;
    const core::MemoryAccount* account;

    core::Result<std::string> make(const std::stop_token& stop,
                                   core::MemoryAccount::Share& share) const {
        const auto& [request, dataset] = sampled;
        const auto window = core::plane_window(request.plane, dataset->flow->domain());
        if (!window)
            return tl::unexpected(window.error());
        const auto [columns, rows] = core::raster_size(*window, request.samples);
        const std::size_t bytes = core::slice_memory(columns, rows) * (minus ? 2 : 1) +
                                  protocol::slice_file_bytes(columns, rows);
        if (!share.grow_to(bytes))
            return tl::unexpected(account->refusal("this slice", bytes));
        return core::sample_slice(request, *dataset->flow, stop)
            .and_then([&](core::SliceRaster&& raster) {
                return minus
                           ? core::slice_minus(raster, minus->request, *minus->dataset->flow, stop)
                           : core::Result<core::SliceRaster>(std::move(raster));
            })
            .map([&](const core::SliceRaster& raster) {
                return protocol::slice_file(raster, request.time);
            });
    }

    PriorityClass priority() const {
        const core::SliceRequest& request = sampled.request;
        const bool velocity = std::holds_alternative<core::SpeedField>(request.field) ||
                              std::holds_alternative<core::VelocityAlong>(request.field);
        const std::size_t cost = (velocity ? 1 : 3) * (minus ? 2 : 1);
        return request.samples * request.samples * cost <= quick_samples ? PriorityClass::Quick
                                                                         : PriorityClass::Long;
    }
};

/// A part of what is made, and what sets it apart.
struct Part {
    Sampled sampled;
    std::string tag;
};

/// Returns what a query subtracts from a field.
core::Result<Part>
subtracted(const SliceQuery& query, const FieldAtTime& from, const FieldSource& source) {
    const auto found = query.minus
                           ? source.catalogue.find(*query.minus)
                           : core::Result<std::shared_ptr<const LoadedDataset>>(from.dataset);
    if (!found)
        return tl::unexpected(found.error());
    const LoadedDataset& data = **found;
    const store::StoreScalars* const scalars = data.scalars.get();
    // A flow that stands still has a time of its own, whatever is asked for.
    const auto time = time_of(query.minus_time ? query.minus_time : query.time, data);
    if (!time)
        return tl::unexpected(time.error());
    return subtracted_field(from.name, from.dataset->info, data.info, scalars, query.plane.normal)
        .map([&](const core::SampledField& field) {
            // The field is that of the tag before, by whatever name.
            return Part{{{query.plane, field, *time, query.samples}, *found},
                        fmt::format("minus {}", values_tag(query.minus.value_or(source.dataset),
                                                           data, from.name, *time))};
        });
}

} // namespace

core::Result<SliceQuery> read_slice_query(const std::map<std::string, std::string>& query) {
    SliceQuery out;
    for (const auto& [name, value] : query) {
        core::Result<void> read;
        if (name == "plane")
            read = read_plane(value).map([&](const core::Plane& plane) { out.plane = plane; });
        else if (name == "samples")
            read = read_samples(value).map([&](std::size_t samples) { out.samples = samples; });
        else if (name == "time")
            read = read_field_time(value).map([&](double time) { out.time = time; });
        else if (name == "field")
            out.field = value;
        else if (name == "minus")
            out.minus = value;
        else if (name == "minusTime")
            read = read_field_time(value, name).map([&](double time) { out.minus_time = time; });
        else
            read = fail(Error::Code::InvalidArgument,
                        "a slice has no parameter `" + name.substr(0, 64) + "`",
                        "the parameters are ?plane=0,0,0:1,0,0, ?field=p, ?time=2.5, "
                        "?samples=640, ?minus=DATASET and ?minusTime=2");
        if (!read)
            return tl::unexpected(read.error());
    }
    if (!query.contains("plane"))
        return fail(Error::Code::InvalidArgument, "`plane` is missing",
                    "write ?plane=0,0,0:1,0,0, a point and the normal");
    return out;
}

core::Result<FieldFile> plan_slice(const std::map<std::string, std::string>& query,
                                   const FieldSource& source) {
    const auto wanted = read_slice_query(query);
    if (!wanted)
        return tl::unexpected(wanted.error());
    const auto values = field_at(wanted->field, wanted->time, source, wanted->plane.normal);
    if (!values)
        return tl::unexpected(values.error());
    const core::Plane& plane = wanted->plane;
    SliceWork work{{{plane, values->field, values->time, wanted->samples}, values->dataset},
                   {},
                   &source.account};
    std::string tag =
        fmt::format("slice {} {},{},{} {},{},{} {}", values->tag, plane.point.x, plane.point.y,
                    plane.point.z, plane.normal.x, plane.normal.y, plane.normal.z, wanted->samples);
    if (wanted->minus || wanted->minus_time) {
        auto minus = subtracted(*wanted, *values, source);
        if (!minus)
            return tl::unexpected(minus.error());
        tag += minus->tag;
        work.minus = std::move(minus->sampled);
    }
    return FieldFile{tag, work.priority(),
                     [work](const std::stop_token& stop, core::MemoryAccount::Share& share) {
                         return work.make(stop, share);
                     }};
}

} // namespace wakesurf::server
