// What people type into records, so that nothing in it acts: see core/base/plain_text.
#pragma once

#include "server/service/session/records/session_records.hpp"

namespace wakesurf::server {

/// Names of rakes and bookmarks, texts of notes, names of authors.
void clean_names(Record& record);

} // namespace wakesurf::server
