// What `mean.make` will do for each of its fields: which time-steps count, with which weights, and which fields
// come of it. Made and checked before any value is read.
#pragma once

#include "core/dataset/mean_record.hpp"
#include "core/dataset/time_means.hpp"
#include "server/data/node_fields.hpp"
#include "server/data/open_dataset.hpp"
#include "store/stored_means.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

struct MeanWish {
    std::vector<std::string> fields; ///< the velocity, stored scalars, and what is derived
    std::optional<double> from{}, to{};
    std::optional<double> period{};      ///< phase means instead of mean and rms
    std::optional<std::size_t> phases{}; ///< of a period
    std::string label{};
    std::size_t most = store::most_means; ///< with those that there are
};

/// One field that comes of a mean, place by place.
struct MeanOutput {
    const char* suffix;
    double (*value)(const core::TimeMeans& means, std::size_t place);
};

/// What is averaged, and over which time-steps.
struct MeanPlan {
    core::MeanRecord record; ///< without the ranges
    NodeField source;        ///< Speed: the velocity, by components
    std::size_t column = 0;  ///< of the store whose values it is made of
    std::vector<std::size_t> steps{};
    std::vector<double> weights{};
    std::vector<MeanOutput> outputs{};

    std::size_t components() const { return source.source == NodeField::Source::Speed ? 3 : 1; }

    /// Returns the numbers, among its steps, of those in a file.
    std::vector<std::size_t> steps_in(std::size_t file, const std::vector<double>& times) const {
        std::vector<std::size_t> out;
        for (std::size_t i = 0; i < steps.size(); ++i)
            if (record.phases == 0 ||
                core::phase_of(times[steps[i]], record.period, record.phases) == file)
                out.push_back(i);
        return out;
    }

    std::size_t files() const { return std::max<std::size_t>(1, record.phases); }
};

/// Checks whether means can be kept beside the dataset. Error: Unsupported (a built-in flow, the web, a Zarr).
core::Result<void> check_kept_here(const LoadedDataset& dataset);

/// Plans each field once. Error: Unsupported, InvalidArgument (a missing field, a name that is taken, a phase
/// without a time-step), OutOfTime (fewer than two time-steps).
core::Result<std::vector<MeanPlan>> plan_means(const LoadedDataset& dataset, const MeanWish& wish);

} // namespace wakesurf::server
