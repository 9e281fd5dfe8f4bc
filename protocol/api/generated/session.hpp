// Made by protocol/api/generate from session.schema.json: do not edit.
// Sessions: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/generated/shared.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Holds the parameters of session.create.
struct SessionCreate {
    static constexpr std::string_view method = "session.create";

    /// display name
    std::string name;
};

/// Holds the parameters of session.fork.
struct SessionFork : InSession {
    static constexpr std::string_view method = "session.fork";

    /// display name
    std::string name;
};

/// Holds the parameters of session.list.
struct SessionList {
    static constexpr std::string_view method = "session.list";

    /// true: list the deleted sessions instead
    bool trash = false;
};

/// Holds the parameters of session.join.
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
};

/// Holds the parameters of session.leave.
struct SessionLeave : NoParameters {
    static constexpr std::string_view method = "session.leave";
};

/// Holds the parameters of session.state.
struct SessionState : InSession {
    static constexpr std::string_view method = "session.state";
};

/// Holds the parameters of session.rename.
struct SessionRename : InSession {
    static constexpr std::string_view method = "session.rename";

    /// display name
    std::string name;
};

/// Holds the parameters of session.setUnits.
struct SessionSetUnits : InSession {
    static constexpr std::string_view method = "session.setUnits";

    /// unit of lengths; empty: as in dataset.describe
    std::string length;
    /// unit of times; empty: as in dataset.describe
    std::string time;
};

/// Holds the parameters of session.delete.
struct SessionDelete {
    static constexpr std::string_view method = "session.delete";

    /// an id from session.list
    std::string session;
    /// true: permanently deletes a session that is in the trash
    bool forever = false;
};

/// Holds the parameters of session.restore.
struct SessionRestore {
    static constexpr std::string_view method = "session.restore";

    /// an id from session.list
    std::string session;
};

/// Holds the parameters of session.export.
struct SessionExport : InSession {
    static constexpr std::string_view method = "session.export";
};

/// Holds the parameters of session.import.
struct SessionImport {
    static constexpr std::string_view method = "session.import";

    /// the `file` that session.export returned
    std::string file;
    /// name of the new session; if left out, the name in the document
    std::string name;
};

/// Holds the parameters of session.thumbnail.
struct SessionThumbnail : InSession {
    static constexpr std::string_view method = "session.thumbnail";

    /// a PNG, JPEG or WebP picture of at most 24 KiB, in base64
    std::string image;
};

void read(CheckedJson& in, SessionCreate& out);
void read(CheckedJson& in, SessionFork& out);
void read(CheckedJson& in, SessionList& out);
void read(CheckedJson& in, SessionJoin& out);
void read(CheckedJson& in, SessionRename& out);
void read(CheckedJson& in, SessionSetUnits& out);
void read(CheckedJson& in, SessionDelete& out);
void read(CheckedJson& in, SessionRestore& out);
void read(CheckedJson& in, SessionImport& out);
void read(CheckedJson& in, SessionThumbnail& out);

} // namespace wakesurf::protocol
