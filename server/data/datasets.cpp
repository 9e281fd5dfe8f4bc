#include "server/data/datasets.hpp"

namespace wakesurf::server {

std::vector<std::string> CatalogueDatasets::ids() const {
    std::vector<std::string> out;
    for (const DatasetStatus& each : catalogue_.list())
        if (catalogue_.find(each.dataset))
            out.push_back(each.dataset);
    return out;
}

core::Result<OpenDataset> CatalogueDatasets::open(const std::string& id) const {
    return catalogue_.find(id).map([](const std::shared_ptr<const LoadedDataset>& loaded) {
        return OpenDataset{
            loaded->info,   protocol::lattice_over(loaded->info.bounds, loaded->info.periodic),
            loaded->flow,   loaded->cache,
            loaded->store,  loaded->scalars,
            loaded->levels, loaded->flow_text};
    });
}

bool replaced_since(const Datasets& datasets,
                    const std::string& id,
                    const std::shared_ptr<const store::StoreReader>& before) {
    if (before == nullptr)
        return false;
    const auto now = datasets.open(id);
    return !now || now->store == nullptr ||
           (now->store != before && !now->store->marks().continues(before->marks()));
}

} // namespace wakesurf::server
