// Bookmarks in messages: a view of the session somebody gave a name. What a view holds is the client's affair.
// Twin: web-client/src/protocol/messages.ts.
#pragma once

#include "protocol/api/checked_json.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace wakesurf::protocol {

struct BookmarkLimits {
    std::size_t name_bytes = 120;
    std::size_t view_bytes = std::size_t{4} << 10;
};

struct BookmarkSetting {
    std::optional<std::string> bookmark; ///< nothing: create one
    std::string name;
    std::string view;           ///< an object as JSON text: camera, colours, ...
    std::optional<double> time; ///< the session's time the view belongs to
    std::optional<std::uint64_t> if_rev;
};

/// Reads the parameters of bookmark.set; faults stay in `in`.
BookmarkSetting read_bookmark_setting(CheckedJson& in, const BookmarkLimits& limits);

struct BookmarkRecord {
    std::string bookmark;
    std::uint64_t rev = 0;
    std::string name;
    std::string view; ///< an object as JSON text
    std::optional<double> time;

    bool operator==(const BookmarkRecord&) const = default;
};

nlohmann::json bookmark_json(const BookmarkRecord& record);

/// What bookmark_json gave; faults stay in `in`.
BookmarkRecord read_bookmark_record(CheckedJson& in, const BookmarkLimits& limits);

} // namespace wakesurf::protocol
