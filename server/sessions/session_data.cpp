// A session and the values of its datasets: it remembers which they were, so that others in their place are
// noticed, also after a restart.
#include "server/sessions/session.hpp"

#include <set>

namespace wakesurf::server {

void Session::dataset_changed(const std::string& dataset) {
    const bool replaced = builds_.dataset_changed(dataset);
    const auto& surfaces = records_.all<protocol::SurfaceRecord>();
    const bool used = std::any_of(surfaces.begin(), surfaces.end(),
                                  [&](const auto& each) { return each.second.dataset == dataset; });
    if (used)
        note_data(dataset, replaced);
}

/// @param replaced  it is known that the values are others than before
void Session::note_data(const std::string& dataset, bool replaced) {
    const auto open = services_.datasets.open(dataset);
    if (!open || open->store == nullptr)
        return;
    const std::string known = profile_.data(dataset);
    if (!replaced && !known.empty() && !open->store->contradicts(known))
        return;
    profile_.set_data(dataset, open->store->values());
    if (known.empty())
        return;
    if (participants_.present().empty())
        replaced_data_.insert(open->info.name);
    keep_profile();
    if (thumbnail_.empty())
        return;
    thumbnail_.clear(); // it shows what is there no more
    if (services_.journal != nullptr)
        services_.journal->write(id_, {{"thumbnail", "", std::nullopt}});
}

} // namespace wakesurf::server
