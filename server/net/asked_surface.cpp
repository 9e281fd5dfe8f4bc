#include "server/net/asked_surface.hpp"

#include "server/data/open_dataset.hpp"

#include <fmt/format.h>

#include <utility>

namespace wakesurf::server {

core::Result<AskedSurface> find_surface(const SessionDirectory& sessions,
                                        const DatasetCatalogue& catalogue,
                                        const std::string& session_id,
                                        const std::string& surface) {
    auto session = sessions.find(session_id);
    if (!session)
        return tl::unexpected(session.error());
    auto record = (*session)->records().get<protocol::SurfaceRecord>(surface);
    if (!record)
        return tl::unexpected(record.error());
    auto live = (*session)->live(surface);
    if (!live)
        return tl::unexpected(live.error());
    const auto dataset = catalogue.find(record->dataset);
    if (!dataset)
        return tl::unexpected(dataset.error());
    const auto status = catalogue.status(record->dataset);
    std::string mark =
        fmt::format("{} {}{}", status ? status->steps_ready : 0, values_of(**dataset),
                    (*dataset)->scalars ? (*dataset)->scalars->mark() : "");
    return AskedSurface{*std::move(session), *std::move(record), *std::move(live), *dataset,
                        std::move(mark)};
}

std::string turns_of(const std::string& session, const Identity& identity) {
    return "\n" + session + "\n" + identity.grant; // no session has such a name
}

} // namespace wakesurf::server
