// The long answers about datasets: their text is made once, and shared by all who ask until it changes.
#pragma once

#include "protocol/wire/lattice.hpp"
#include "server/data/dataset_catalogue.hpp"
#include "server/data/datasets.hpp"

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Returns a DatasetEntry, as the description of the API has it.
nlohmann::json dataset_entry(const DatasetStatus& status);

/// Returns a Lattice.
nlohmann::json lattice_json(const protocol::Lattice& lattice);

/// Loop thread only. What an answer of many time-steps costs beyond this is a copy of its text.
class DatasetAnswers {
  public:
    /// Returns the result of dataset.describe as JSON text.
    const std::string& description(const std::string& dataset, const OpenDataset& open);

    /// Returns the result of cache.status as JSON text.
    std::string cache(const std::string& dataset, const core::TimeStepCache::Status& status);

  private:
    struct Described {
        std::weak_ptr<const core::Flow> flow; ///< opened again, a dataset has another one of these
        std::weak_ptr<const store::StoreScalars> scalars;
        std::vector<double> times;
        std::string words; ///< the rest of what is known, which changes as an import goes on
        std::string text;
    };

    struct Steps {
        std::vector<core::StepHeld> steps;
        std::string text; ///< the members `steps` and `held`
    };

    std::map<std::string, Described> described_;
    std::map<std::string, Steps> steps_;
};

} // namespace wakesurf::server
