// Made by protocol/api/generate from session.schema.json: do not edit.
// Sessions: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/checked_json.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Parameters of session.create: Makes a new, empty session. When there are too many sessions, one
/// without a name that no one has edited or shared and no one is in is removed; no other session
/// ever is.
struct SessionCreate {
    static constexpr std::string_view method = "session.create";

    /// display name
    std::string name;

    bool operator==(const SessionCreate&) const = default;
};

void read(CheckedJson& in, SessionCreate& out);

/// Parameters of session.fork: Makes a new session with the records of another and the time it
/// shows, but without its people, links and history. With a share link, of any role, it copies the
/// link's session only, and `key` lets you into the copy as an editor, for as long as your link is
/// valid.
struct SessionFork {
    static constexpr std::string_view method = "session.fork";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// display name
    std::string name;

    bool operator==(const SessionFork&) const = default;
};

void read(CheckedJson& in, SessionFork& out);

/// Parameters of session.list: Lists the sessions of this server. With a share link, only the
/// session of the link is listed.
struct SessionList {
    static constexpr std::string_view method = "session.list";

    /// true: list the deleted sessions instead
    bool trash = false;

    bool operator==(const SessionList&) const = default;
};

void read(CheckedJson& in, SessionList& out);

/// Parameters of session.join: Enters a session. From now on its changes are sent to this
/// WebSocket.
struct SessionJoin {
    static constexpr std::string_view method = "session.join";

    /// an id from session.list or session.create; if left out, the share link's session, or else
    /// `main`
    std::optional<std::string> session;
    /// display name
    std::string name;
    /// #rrggbb; if left out, a colour that few others have
    std::optional<std::string> colour;
    /// token of an earlier stay, to take up its place again
    std::optional<std::string> resume_token;
    /// with `resumeToken`: the last `seq` seen; what was missed is returned instead of the snapshot
    std::optional<std::uint64_t> last_seq;

    bool operator==(const SessionJoin&) const = default;
};

void read(CheckedJson& in, SessionJoin& out);

/// Parameters of session.leave: Leaves the session. Its changes are no longer sent.
struct SessionLeave {
    static constexpr std::string_view method = "session.leave";
};

void read(CheckedJson& in, SessionLeave& out);

/// Parameters of session.state: Returns all records of a session.
struct SessionState {
    static constexpr std::string_view method = "session.state";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;

    bool operator==(const SessionState&) const = default;
};

void read(CheckedJson& in, SessionState& out);

/// Parameters of session.rename: Renames a session. Everyone in it is notified.
struct SessionRename {
    static constexpr std::string_view method = "session.rename";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// display name
    std::string name;

    bool operator==(const SessionRename&) const = default;
};

void read(CheckedJson& in, SessionRename& out);

/// Parameters of session.setUnits: Sets the units in which lengths and times are read. They only
/// name what the numbers of the data mean: no number changes. Everyone in the session is notified.
struct SessionSetUnits {
    static constexpr std::string_view method = "session.setUnits";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// unit of lengths; empty: as in dataset.describe
    std::string length;
    /// unit of times; empty: as in dataset.describe
    std::string time;

    bool operator==(const SessionSetUnits&) const = default;
};

void read(CheckedJson& in, SessionSetUnits& out);

/// Parameters of session.delete: Moves a session to the trash, from which session.restore can bring
/// it back for 30 days. The people in it are notified, and meanwhile its share links let no one in.
/// `main` cannot be deleted. Who copied a session by a share link may delete the copy as long as no
/// one has edited, named or shared it and no one else is in it; it is gone for good then.
struct SessionDelete {
    static constexpr std::string_view method = "session.delete";

    /// an id from session.list
    std::string session;
    /// true: permanently deletes a session that is in the trash
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

/// Parameters of session.export: Returns a session as one document: its records, and the names and
/// fingerprints of their datasets. A large session is refused here; GET
/// /api/v1/sessions/SESSION/session.json returns sessions of any size.
struct SessionExport {
    static constexpr std::string_view method = "session.export";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;

    bool operator==(const SessionExport&) const = default;
};

void read(CheckedJson& in, SessionExport& out);

/// Parameters of session.import: Makes a new session from a document of session.export. POST
/// /api/v1/sessions takes documents that are too large for a message.
struct SessionImport {
    static constexpr std::string_view method = "session.import";

    /// the `file` that session.export returned
    std::string file;
    /// name of the new session; if left out, the name in the document
    std::string name;

    bool operator==(const SessionImport&) const = default;
};

void read(CheckedJson& in, SessionImport& out);

/// Parameters of session.thumbnail: Stores a small picture of the session for lists; it replaces
/// the one before. GET /api/v1/sessions/SESSION/thumbnail returns it.
struct SessionThumbnail {
    static constexpr std::string_view method = "session.thumbnail";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;
    /// a PNG, JPEG or WebP picture of at most 24 KiB, in base64
    std::string image;

    bool operator==(const SessionThumbnail&) const = default;
};

void read(CheckedJson& in, SessionThumbnail& out);

} // namespace wakesurf::protocol
