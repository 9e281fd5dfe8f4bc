// mean.make, mean.remove.
#include "protocol/api/dataset_json.hpp"
#include "protocol/api/generated/mean.hpp"
#include "server/data/mean_making.hpp"
#include "server/net/methods/kept_field_calls.hpp"
#include "server/net/methods/method.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

void mean_make(const Call& call, const protocol::MeanMake& of, Reply reply) {
    MeanWish wish{of.fields, of.from, of.to, of.period, of.phases, of.label};
    if (!call.identity.grant.empty()) // which links cannot remove
        wish.most = means_of_links;
    const std::string names = fmt::format("{}", fmt::join(of.fields, ", "));
    make_kept_field(
        call, of.dataset,
        {"this mean", "averaging " + names, "averaging", "of the values", of.work_done_token},
        [wish = std::move(wish)](const LoadedDataset& dataset, const auto& stop,
                                 const core::WorkPart& work) {
            return make_means(dataset, wish, stop, work).map([](const auto& made) {
                json all = json::array();
                for (const core::MeanRecord& each : made)
                    all.push_back(protocol::written(each));
                return json{{"means", std::move(all)}};
            });
        },
        std::move(reply));
}

void mean_remove(const Call& call, const protocol::MeanRemove& of, Reply reply) {
    remove_kept_field(
        call, of.dataset,
        [name = of.name](const LoadedDataset& dataset) { return remove_mean(dataset, name); },
        std::move(reply));
}

} // namespace

std::vector<Method> mean_methods() {
    return {method(mean_make), method(mean_remove)};
}

} // namespace wakesurf::server
