// Made by protocol/api/generate from bookmark.schema.json: do not edit.
// Bookmarks: what methods take, and the record. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/generated/shared.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// A bookmark as the session keeps it.
struct BookmarkRecord {
    /// id of the bookmark
    std::string bookmark;
    /// counts the edits of a record
    std::uint64_t rev = 0;
    /// display name
    std::string name;
    /// camera, colours and so on, in whatever form the client chooses; at most 4 KiB as JSON text
    std::string view;
    /// the session's time that belongs to the view (the dataset's unit of time)
    std::optional<double> time;

    bool operator==(const BookmarkRecord&) const = default;
};

void read(CheckedJson& in, BookmarkRecord& out);

nlohmann::json record_json(const BookmarkRecord& record);

/// Returns it as it is kept: what read() reads.
nlohmann::json kept_json(const BookmarkRecord& record);

/// Holds the parameters of bookmark.set.
struct BookmarkSetting : InSession {
    static constexpr std::string_view method = "bookmark.set";

    /// id of the bookmark to replace; if left out, a new one is created
    std::optional<std::string> bookmark;
    /// display name
    std::string name;
    /// camera, colours and so on, in whatever form the client chooses; at most 4 KiB as JSON text
    std::string view;
    /// the session's time that belongs to the view (the dataset's unit of time)
    std::optional<double> time;
    /// a name for what the user is doing; consecutive edits with the same name are one step of undo
    std::optional<std::string> gesture;
    /// the edit is refused if the record is at another revision
    std::optional<std::uint64_t> if_rev;
};

/// Holds the parameters of bookmark.delete.
struct BookmarkDelete : InSession {
    static constexpr std::string_view method = "bookmark.delete";

    /// an id from bookmark.list
    std::string bookmark;
    /// a name for what the user is doing; consecutive edits with the same name are one step of undo
    std::optional<std::string> gesture;
    /// the edit is refused if the record is at another revision
    std::optional<std::uint64_t> if_rev;
};

/// Holds the parameters of bookmark.list.
struct BookmarkList : InSession {
    static constexpr std::string_view method = "bookmark.list";
};

void read(CheckedJson& in, BookmarkSetting& out);
void read(CheckedJson& in, BookmarkDelete& out);

} // namespace wakesurf::protocol
