#include "server/live/prober.hpp"

#include "core/base/either_stop.hpp"
#include "server/data/dataset_suggestion.hpp"

namespace wakesurf::server {

void Prober::ask(OpenDataset dataset,
                 ProbeRequest request,
                 const std::string& line,
                 const std::stop_token& unwanted,
                 std::function<void(core::Result<ProbeResult>)> answer) {
    compute<ProbeResult>(
        loop_, pool_, line,
        [dataset = std::move(dataset), request = std::move(request),
         stop = std::make_shared<core::EitherStop>(stop_.get_token(), unwanted)] {
            return probe({dataset.info, *dataset.flow, dataset.scalars.get()}, request,
                         stop->token());
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
