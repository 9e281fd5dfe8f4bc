// Made by protocol/api/generate from bookmark.schema.json: do not edit.
// Bookmarks: what methods take, and the record. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/checked_json.hpp"

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

nlohmann::json bookmark_json(const BookmarkRecord& record);

/// As it is kept: what read() reads.
nlohmann::json kept_json(const BookmarkRecord& record);

/// Parameters of bookmark.set: Creates a bookmark, or replaces one as a whole.
struct BookmarkSetting {
    static constexpr std::string_view method = "bookmark.set";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
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

    bool operator==(const BookmarkSetting&) const = default;
};

void read(CheckedJson& in, BookmarkSetting& out);

/// Parameters of bookmark.delete: Deletes a bookmark.
struct BookmarkDelete {
    static constexpr std::string_view method = "bookmark.delete";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// an id from bookmark.list
    std::string bookmark;
    /// a name for what the user is doing; consecutive edits with the same name are one step of undo
    std::optional<std::string> gesture;
    /// the edit is refused if the record is at another revision
    std::optional<std::uint64_t> if_rev;

    bool operator==(const BookmarkDelete&) const = default;
};

void read(CheckedJson& in, BookmarkDelete& out);

/// Parameters of bookmark.list: Lists the bookmarks of a session.
struct BookmarkList {
    static constexpr std::string_view method = "bookmark.list";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;

    bool operator==(const BookmarkList&) const = default;
};

void read(CheckedJson& in, BookmarkList& out);

} // namespace wakesurf::protocol
