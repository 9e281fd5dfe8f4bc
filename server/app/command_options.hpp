// Options that several commands on the data have, without a server.
#pragma once

#include "core/base/result.hpp"
#include "server/data/open_dataset.hpp"
#include "store/command/memory_size.hpp"
#include "store/command/source_options.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string_view>

namespace wakesurf::server {

/// Adds --memory, --threads where `options` have it, --store, and how sources are read.
template <class Options>
void add_process_options(CLI::App& command, Options& options) {
    command
        .add_option(
            "--memory", options.memory,
            "Memory for the process (default: 60 % of the memory of the machine or control group)")
        ->transform(command::as_memory_size());
    if constexpr (requires { options.threads; })
        command
            .add_option("--threads", options.threads, "Number of threads (default: one per core)")
            ->check(CLI::Range(1, 1024));
    command.add_option("--store", options.store,
                       "Folder for imported data (default: ~/.cache/wakesurf)");
    command::add_source_options(command, options.taken);
}

/// Adds the argument DATASET.
void add_dataset_argument(CLI::App& command, std::string& dataset);

/// Returns the time that --time says; says which is taken where several are and none is chosen. Error: InvalidArgument where the data have
/// no such time.
core::Result<double> chosen_time(std::optional<double> asked,
                                 const LoadedDataset& dataset,
                                 std::string_view option = "--time");

} // namespace wakesurf::server
