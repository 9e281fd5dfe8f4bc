// Made by protocol/api/generate from session.schema.json: do not edit.
// Sessions: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/checked_json.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Parameters of session.create: Makes a new, empty session. One without a name that no one edits,
/// shares or is in goes again when there are too many; no other does.
struct SessionCreate {
    static constexpr std::string_view method = "session.create";

    /// for people
    std::string name;

    bool operator==(const SessionCreate&) const = default;
};

void read(CheckedJson& in, SessionCreate& out);

/// Parameters of session.fork: Makes a new session with the records of another, but none of its
/// people, links and history. Not for share links.
struct SessionFork {
    static constexpr std::string_view method = "session.fork";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// for people
    std::string name;

    bool operator==(const SessionFork&) const = default;
};

void read(CheckedJson& in, SessionFork& out);

/// Parameters of session.list: The sessions of this server; with a share link, its own.
struct SessionList {
    static constexpr std::string_view method = "session.list";

    /// true: those that were deleted instead
    bool trash = false;

    bool operator==(const SessionList&) const = default;
};

void read(CheckedJson& in, SessionList& out);

/// Parameters of session.join: Enters a session: its changes are told to this WebSocket from now
/// on.
struct SessionJoin {
    static constexpr std::string_view method = "session.join";

    /// an id from session.list or session.create; left out: the share link's, else `main`
    std::optional<std::string> session;
    /// for people
    std::string name;
    /// #rrggbb; left out: one that few others have
    std::optional<std::string> colour;
    /// of an earlier stay, to take up its place again
    std::optional<std::string> resume_token;
    /// with resumeToken: the last seq seen; what was missed comes instead of the snapshot
    std::optional<std::uint64_t> last_seq;

    bool operator==(const SessionJoin&) const = default;
};

void read(CheckedJson& in, SessionJoin& out);

/// Parameters of session.leave: Leaves the session joined; its changes are not told any more.
struct SessionLeave {
    static constexpr std::string_view method = "session.leave";
};

void read(CheckedJson& in, SessionLeave& out);

/// Parameters of session.state: Every record of a session.
struct SessionState {
    static constexpr std::string_view method = "session.state";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;

    bool operator==(const SessionState&) const = default;
};

void read(CheckedJson& in, SessionState& out);

/// Parameters of session.rename: Gives a session another name; everyone in it is told.
struct SessionRename {
    static constexpr std::string_view method = "session.rename";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// for people
    std::string name;

    bool operator==(const SessionRename&) const = default;
};

void read(CheckedJson& in, SessionRename& out);

/// Parameters of session.delete: Moves a session to the trash, from where session.restore brings it
/// back for 30 days; its people are told, its share links let no one in meanwhile. `main` cannot be
/// deleted.
struct SessionDelete {
    static constexpr std::string_view method = "session.delete";

    /// an id from session.list
    std::string session;
    /// true: removes a session that is in the trash for good
    bool forever = false;

    bool operator==(const SessionDelete&) const = default;
};

void read(CheckedJson& in, SessionDelete& out);

/// Parameters of session.restore: Brings a session back from the trash as it was, with its share
/// links.
struct SessionRestore {
    static constexpr std::string_view method = "session.restore";

    /// an id from session.list
    std::string session;

    bool operator==(const SessionRestore&) const = default;
};

void read(CheckedJson& in, SessionRestore& out);

/// Parameters of session.export: A session as one document: its records, and the names and
/// fingerprints of their datasets. A large one is refused here: GET
/// /api/v1/sessions/SESSION/session.json answers with any.
struct SessionExport {
    static constexpr std::string_view method = "session.export";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;

    bool operator==(const SessionExport&) const = default;
};

void read(CheckedJson& in, SessionExport& out);

/// Parameters of session.import: Makes a new session of such a document. POST /api/v1/sessions
/// takes larger documents than a message may be.
struct SessionImport {
    static constexpr std::string_view method = "session.import";

    /// what session.export answered
    std::string file;
    /// left out: the document's
    std::string name;

    bool operator==(const SessionImport&) const = default;
};

void read(CheckedJson& in, SessionImport& out);

/// Parameters of session.thumbnail: Keeps a small picture of the session for lists: the newest one
/// sent. GET /api/v1/sessions/SESSION/thumbnail answers with it.
struct SessionThumbnail {
    static constexpr std::string_view method = "session.thumbnail";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;
    /// base64 of a PNG, JPEG or WebP picture of at most 24 KiB
    std::string image;

    bool operator==(const SessionThumbnail&) const = default;
};

void read(CheckedJson& in, SessionThumbnail& out);

} // namespace wakesurf::protocol
