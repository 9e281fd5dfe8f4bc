#include "server/net/field_downloads.hpp"

#include "server/data/node_fields.hpp"
#include "server/data/open_dataset.hpp"
#include "server/net/download_request.hpp"

#include <fmt/format.h>

#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

core::Result<double> read_field_time(const std::string& text) {
    const auto time = finite_number(text);
    return time ? core::Result<double>(*time)
                : fail(Error::Code::InvalidArgument, "`time` is not a finite number",
                       "as in ?time=2.5");
}

namespace {

/// Returns the time to sample at.
core::Result<double> time_of(std::optional<double> asked, const LoadedDataset& dataset) {
    const bool stands = dataset.info.steady || dataset.info.times.size() < 2;
    if (stands)
        return dataset.info.times.empty() ? asked.value_or(0.0) : dataset.info.times.front();
    if (!asked)
        return fail(Error::Code::InvalidArgument, "`time` is missing",
                    "the data change with time: add ?time=2.5");
    return *asked;
}

} // namespace

core::Result<FieldAtTime>
field_at(const std::string& field, std::optional<double> time, const FieldSource& source) {
    const auto dataset = source.catalogue.find(source.dataset);
    if (!dataset)
        return tl::unexpected(dataset.error());
    const LoadedDataset& data = **dataset;
    const store::StoreScalars* const scalars = data.scalars.get();
    const auto at = time_of(time, data);
    if (!at)
        return tl::unexpected(at.error());
    return find_node_field(field.empty() ? data.info.velocity : field, data.info, scalars)
        .map([&](const NodeField& found) {
            return FieldAtTime{*dataset, sampled(found, scalars), *at,
                               fmt::format("{} {} {} {} {}", source.dataset, values_of(data),
                                           scalars ? scalars->mark() : "", found.name, *at)};
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
