#include "server/net/field_request.hpp"

#include "server/net/download_request.hpp"

#include <fmt/format.h>

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

core::Result<NodeField> field_of(const std::string& name, const LoadedDataset& dataset) {
    return find_node_field(name.empty() ? dataset.info.velocity : name, dataset.info,
                           dataset.scalars.get());
}

} // namespace wakesurf::server
