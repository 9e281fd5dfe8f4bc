#include "server/net/slice_downloads.hpp"

#include "core/surface/measures/region.hpp"
#include "core/surface/slice/slice_raster.hpp"
#include "protocol/wire/slice_file.hpp"
#include "server/base/limits.hpp"
#include "server/data/open_dataset.hpp"
#include "server/data/region_text.hpp"
#include "server/net/download_request.hpp"

#include <fmt/format.h>

#include <charconv>
#include <memory>
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

/// Holds the input of a file.
struct SliceWork {
    core::SliceRequest request;
    std::shared_ptr<const LoadedDataset> dataset; ///< keeps what the field needs
    const core::MemoryAccount* account;

    core::Result<std::string> make(const std::stop_token& stop,
                                   core::MemoryAccount::Share& share) const {
        const auto window = core::plane_window(request.plane, dataset->flow->domain());
        if (!window)
            return tl::unexpected(window.error());
        const auto [columns, rows] = core::raster_size(*window, request.samples);
        const std::size_t bytes =
            core::slice_memory(columns, rows) + protocol::slice_file_bytes(columns, rows);
        if (!share.grow_to(bytes))
            return tl::unexpected(account->refusal("this slice", bytes));
        return core::sample_slice(request, *dataset->flow, stop)
            .map([&](const core::SliceRaster& raster) {
                return protocol::slice_file(raster, request.time);
            });
    }

    PriorityClass priority() const {
        const bool velocity = std::holds_alternative<core::SpeedField>(request.field) ||
                              std::holds_alternative<core::VelocityAlong>(request.field);
        const std::size_t cost = velocity ? 1 : 3;
        return request.samples * request.samples * cost <= quick_samples ? PriorityClass::Quick
                                                                         : PriorityClass::Long;
    }
};

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
        else
            read = fail(Error::Code::InvalidArgument,
                        "a slice has no parameter `" + name.substr(0, 64) + "`",
                        "the parameters are ?plane=0,0,0:1,0,0, ?field=p, ?time=2.5 and "
                        "?samples=640");
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
    const auto values = field_at(wanted->field, wanted->time, source);
    if (!values)
        return tl::unexpected(values.error());
    const core::Plane& plane = wanted->plane;
    const SliceWork work{
        {plane, values->field, values->time, wanted->samples}, values->dataset, &source.account};
    return FieldFile{
        fmt::format("slice {} {},{},{} {},{},{} {}", values->tag, plane.point.x, plane.point.y,
                    plane.point.z, plane.normal.x, plane.normal.y, plane.normal.z, wanted->samples),
        work.priority(), [work](const std::stop_token& stop, core::MemoryAccount::Share& share) {
            return work.make(stop, share);
        }};
}

} // namespace wakesurf::server
