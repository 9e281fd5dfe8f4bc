// The version of the API that server.info tells clients: raised whenever a client of before could
// misunderstand the server.
#pragma once

namespace wakesurf::protocol {

inline constexpr int api_level = 5;

} // namespace wakesurf::protocol
