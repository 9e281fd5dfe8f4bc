#include "server/net/methods/session_import.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace wakesurf::server {

core::Result<nlohmann::json> import_session(SessionDirectory& sessions,
                                            const Datasets& datasets,
                                            ReadSession read,
                                            std::string name) {
    const auto notes = dataset_notes(read, datasets);
    const auto session = sessions.import(std::move(read.records), std::move(name));
    if (!session)
        return tl::unexpected(session.error());
    return nlohmann::json{{"session", (*session)->id()},
                          {"name", (*session)->name()},
                          {"remaining", sessions.remaining()},
                          {"notes", notes}};
}

} // namespace wakesurf::server
