// A session as one JSON document that outlives its server: its records, and which datasets they were made
// with. Ids stay, so that surfaces find their rakes; revisions and epochs are a server's own and stay behind.
#pragma once

#include "core/base/box.hpp"
#include "core/base/result.hpp"
#include "protocol/api/record_text.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// Is raised whenever a file of before can no longer be read.
inline constexpr int session_file_version = 1;

/// Describes a dataset as a surface's record names it, and how to tell whether another server's is the same.
struct DatasetMark {
    std::string dataset; ///< id
    std::string name;
    std::string fingerprint; ///< of its mesh and fields; empty: it could not be opened
    std::string values{};    ///< of its time-steps; empty: a built-in flow, or a file of before
    std::uint64_t steps = 0;
    double first = 0.0; ///< times
    double last = 0.0;
    std::optional<core::Box> bounds;
};

/// Holds a record as the journal keeps it.
struct FileRecord {
    std::string type; ///< rake, surface, slice, bookmark, annotation, clock
    std::string id;   ///< of the clock: empty
    std::string text; ///< JSON
};

struct SessionFile {
    std::string name;
    std::string exported; ///< time, RFC 3339
    std::string wakesurf; ///< version
    std::vector<FileRecord> records;
    std::vector<DatasetMark> datasets;
    SessionUnits units{};
};

nlohmann::json session_file_json(const SessionFile& file);

/// Is the inverse of session_file_json, from its text. What the records say is not looked at: that is for
/// those who keep them. Error: Unsupported (a newer wakesurf's), OverLimit, Corrupt, naming what is wrong.
core::Result<SessionFile> read_session_file(std::string_view text, std::size_t most_bytes);

} // namespace wakesurf::protocol
