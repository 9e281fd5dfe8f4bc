// Lists what changed in a session since any of its sequence numbers, for clients that come back. Of each
// record only the newest change is kept: it is the whole record, so that a drag of a thousand edits is one
// entry.
#pragma once

#include "server/sessions/records/observer.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// Loop thread only. Bounded: beyond limits::changes records, the oldest changes are forgotten.
class ChangeLog {
  public:
    /// Reaches back to `seq` and no further.
    void start(std::uint64_t seq);

    /// REQUIRES: seq grows from call to call.
    void add(std::uint64_t seq, std::span<const Patch> patches);

    /// Returns the changes after `seq`, oldest first: applied to the records as they were then, they give
    /// the present ones. Nothing if it does not reach back that far.
    std::optional<std::vector<Patch>> since(std::uint64_t seq) const;

  private:
    using Place = std::pair<std::uint64_t, std::size_t>; ///< seq, and the patch's index within

    std::map<Place, Patch> changes_;
    std::map<std::pair<std::string, std::string>, Place> newest_; ///< by type and id
    std::uint64_t oldest_ = 0;                                    ///< reaches back to here
    std::uint64_t seq_ = 0;
};

} // namespace wakesurf::server
