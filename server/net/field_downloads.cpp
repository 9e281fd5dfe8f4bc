#include "server/net/field_downloads.hpp"

#include "server/data/node_fields.hpp"
#include "server/data/open_dataset.hpp"
#include "server/data/slice_field.hpp"
#include "server/net/download_request.hpp"

#include <fmt/format.h>

#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

core::Result<double> read_field_time(const std::string& text, std::string_view name) {
    const auto time = finite_number(text);
    return time ? core::Result<double>(*time)
                : fail(Error::Code::InvalidArgument,
                       fmt::format("`{}` is not a finite number", name),
                       fmt::format("as in ?{}=2.5", name));
}

core::Result<double> time_of(std::optional<double> asked, const LoadedDataset& dataset) {
    const bool stands = dataset.info.steady || dataset.info.times.size() < 2;
    if (stands)
        return dataset.info.times.empty() ? asked.value_or(0.0) : dataset.info.times.front();
    if (!asked)
        return fail(Error::Code::InvalidArgument, "`time` is missing",
                    "the data change with time: add ?time=2.5");
    return *asked;
}

std::string values_tag(const std::string& id,
                       const LoadedDataset& data,
                       const std::string& field,
                       double time) {
    return fmt::format("{} {} {} {} {}", id, values_of(data),
                       data.scalars ? data.scalars->mark() : "", field, time);
}

core::Result<FieldAtTime> field_at(const std::string& field,
                                   std::optional<double> time,
                                   const FieldSource& source,
                                   const std::optional<core::Vec3>& normal) {
    const auto dataset = source.catalogue.find(source.dataset);
    if (!dataset)
        return tl::unexpected(dataset.error());
    const LoadedDataset& data = **dataset;
    const store::StoreScalars* const scalars = data.scalars.get();
    const auto at = time_of(time, data);
    if (!at)
        return tl::unexpected(at.error());
    const std::string& name = field.empty() ? data.info.velocity : field;
    const auto found =
        normal ? slice_field(name, data.info, scalars, *normal)
               : find_node_field(name, data.info, scalars).map([&](const NodeField& node_field) {
                     return sampled(node_field, scalars);
                 });
    return found.map([&](const core::SampledField& sampled_field) {
        return FieldAtTime{*dataset, sampled_field, name, *at,
                           values_tag(source.dataset, data, name, *at)};
    });
}

void FieldDownloads::get(const HttpRequest& request,
                         const std::string& line,
                         const std::string& dataset,
                         Plan plan,
                         const Respond& respond) {
    auto file = url_query(request.query).and_then([&](const auto& query) {
        return plan(query, FieldSource{catalogue_, account_, dataset});
    });
    if (!file)
        return respond(http_error(file.error()));
    files_.get(
        file->tag, line, std::move(file->make), request.gone,
        [respond](const core::Result<File>& made) {
            if (!made)
                return respond(http_error(made.error()));
            respond({200,
                     {{"Content-Type", "application/octet-stream"}, {"Cache-Control", "no-cache"}},
                     *made});
        },
        file->priority);
}

} // namespace wakesurf::server
