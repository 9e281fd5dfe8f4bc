// The answer to an edit, held until the edit is on the disk: what has been answered has been kept.
#pragma once

#include "server/rpc/method.hpp"

namespace wakesurf::server {

/// A reply that gives its result to `reply` once the journal has settled, with the member `durable`; where that is false, the
/// edit counts all the same, and `hint` says why it is not kept. Faults go through at once. REQUIRES: the journal outlives it.
Reply held_until_settled(Reply reply, Journal& journal);

} // namespace wakesurf::server
