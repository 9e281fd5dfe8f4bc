#include "server/app/command_options.hpp"

#include "server/app/command_output.hpp"

#include <fmt/format.h>

namespace wakesurf::server {

void add_dataset_argument(CLI::App& command, std::string& dataset) {
    command
        .add_option("DATASET", dataset,
                    "A file or folder of simulation results, a store or a Zarr or the https:// "
                    "address of one, or flow:NAME[?k=v,...]")
        ->required();
}

core::Result<double>
chosen_time(std::optional<double> asked, const LoadedDataset& dataset, std::string_view option) {
    const auto& times = dataset.info.times;
    if (times.empty() || dataset.info.steady)
        return asked.value_or(times.empty() ? 0.0 : times.front());
    if (asked && !(*asked >= times.front() && *asked <= times.back()))
        return core::fail(
            core::Error::Code::InvalidArgument,
            fmt::format("{}: {:g} is outside the data", option, *asked),
            fmt::format("{} has {:g} to {:g}", dataset.info.name, times.front(), times.back()));
    if (!asked && times.size() > 1)
        tell(stderr, "wakesurf: without --time: {:g}, the last\n", times.back());
    return asked.value_or(times.back());
}

} // namespace wakesurf::server
