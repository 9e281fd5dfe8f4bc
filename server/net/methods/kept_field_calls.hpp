// What the calls have in common that make and remove fields kept with the data, families and means: the budget,
// the progress, the answer.
#pragma once

#include "server/net/methods/kept_field_jobs.hpp"
#include "server/net/methods/method.hpp"

#include <functional>
#include <optional>
#include <string>

namespace wakesurf::server {

struct KeptFieldWords {
    std::string what;    ///< "this family"
    std::string title;   ///< of the progress
    std::string subject; ///< of the progress, before a colon: a name, which may be anything
    std::string done;    ///< what the percentage is of: "of the nodes traced"
    std::optional<std::string> token{}; ///< that came with the call
};

/// Makes fields, and replies with what `make` returns.
void make_kept_field(const Call& call,
                     const std::string& dataset,
                     KeptFieldWords words,
                     KeptFieldJobs::Make make,
                     Reply reply);

/// Removes one, and replies with an empty object.
void remove_kept_field(const Call& call,
                       const std::string& dataset,
                       std::function<core::Result<void>(const LoadedDataset&)> remove,
                       Reply reply);

} // namespace wakesurf::server
