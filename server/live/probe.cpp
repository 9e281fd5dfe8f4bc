#include "server/live/probe.hpp"

#include "core/base/either_stop.hpp"
#include "core/base/rounding.hpp"
#include "core/field/sample_scalar.hpp"
#include "server/base/field_names.hpp"
#include "server/data/dataset_suggestion.hpp"

#include <fmt/format.h>

#include <limits>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

core::Result<ProbeField> sample_velocity(const OpenDataset& dataset,
                                         const ProbeRequest& request,
                                         const std::vector<double>& times,
                                         const std::stop_token& stop) {
    ProbeField field{dataset.info.velocity, std::vector<core::Vec3>(request.points.size()), {}};
    return dataset.flow->sample(request.points, times, field.vectors, stop).map([&] {
        return std::move(field);
    });
}

core::Result<ProbeField> sample_field(const OpenDataset& dataset,
                                      const ProbeRequest& request,
                                      const std::string& name,
                                      const std::vector<double>& times,
                                      const std::stop_token& stop) {
    if (name == dataset.info.velocity)
        return sample_velocity(dataset, request, times, stop);
    const auto scalar = dataset.scalars
                            ? dataset.scalars->find(name)
                            : fail(Error::Code::NotFound, "a built-in flow stores none");
    if (!scalar) {
        auto there = dataset.scalars ? dataset.scalars->names() : std::vector<std::string>();
        there.push_back(dataset.info.velocity);
        return tl::unexpected(no_such_field("fields", name, there, dataset.info.fields));
    }
    return core::sample_scalar(*dataset.flow, *dataset.scalars, *scalar, request.points, times,
                               stop)
        .map([&](std::vector<float> values) {
            return ProbeField{name, {}, std::move(values)};
        });
}

} // namespace

core::Result<ProbeResult>
probe(const OpenDataset& dataset, const ProbeRequest& asked, const std::stop_token& stop) {
    ProbeRequest request = asked;
    for (core::Vec3& point : request.points)
        point = core::onto_faces(point, dataset.flow->domain());
    if (const auto range = dataset.flow->time_bounds();
        range && !core::within_rounding(request.time, (*range)[0], (*range)[1]))
        return fail(Error::Code::OutOfTime,
                    fmt::format("time {} is outside the data's {} to {}", request.time, (*range)[0],
                                (*range)[1]),
                    "choose `time` inside it");
    ProbeResult result;
    const std::vector<double> times(request.points.size(), request.time);
    const auto wanted =
        request.fields.empty() ? std::vector{dataset.info.velocity} : request.fields;
    for (const std::string& name : wanted) {
        auto field = sample_field(dataset, request, name, times, stop);
        if (!field)
            return tl::unexpected(field.error());
        result.fields.push_back(std::move(*field));
    }
    std::vector<std::uint8_t> gap(request.points.size());
    if (auto marked = dataset.flow->mark_gaps(request.points, times, gap, stop); !marked)
        return tl::unexpected(marked.error());
    for (std::size_t i = 0; i < gap.size(); ++i)
        result.inside.push_back(gap[i] == 0 && dataset.flow->status(request.points[i]) ==
                                                   core::PointStatus::Inside);
    // A flow answers everywhere, outside with the value at the nearest place, which is no measurement.
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    for (ProbeField& field : result.fields)
        for (std::size_t i = 0; i < gap.size(); ++i) {
            if (!result.inside[i] && !field.vectors.empty())
                field.vectors[i] = core::Vec3(nothing);
            if (!result.inside[i] && !field.scalars.empty())
                field.scalars[i] = static_cast<float>(nothing);
        }
    return result;
}

void Prober::ask(OpenDataset dataset,
                 ProbeRequest request,
                 const std::string& line,
                 const std::stop_token& unwanted,
                 std::function<void(core::Result<ProbeResult>)> answer) {
    compute<ProbeResult>(
        loop_, pool_, line,
        [dataset = std::move(dataset), request = std::move(request),
         stop = std::make_shared<core::EitherStop>(stop_.get_token(), unwanted)] {
            return probe(dataset, request, stop->token());
        },
        std::move(answer));
}

void Prober::suggest(OpenDataset dataset,
                     const std::string& line,
                     const std::stop_token& unwanted,
                     std::function<void(core::Result<core::SceneSuggestion>)> answer) {
    compute<core::SceneSuggestion>(
        loop_, pool_, line,
        [dataset = std::move(dataset),
         stop = std::make_shared<core::EitherStop>(stop_.get_token(), unwanted)] {
            return suggest_for(dataset.info, *dataset.flow, dataset.store.get(), stop->token());
        },
        std::move(answer));
}

} // namespace wakesurf::server
