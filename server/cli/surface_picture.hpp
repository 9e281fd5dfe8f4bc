// `wakesurf surface DATA -o a.png`: the surface as the page draws it. The page, and not a renderer of our own here: it has the colours, the
// scalar bar, the axes and the shade that people know, by the same code. So a picture takes Chromium, which draws without a window, and a
// server for as long as that takes; both are started by the client for Python (protocol/python/wakesurf/draw.py).
#pragma once

#include "server/cli/surface_request.hpp"

namespace wakesurf::server {

/// Does not return where it could start. Exit status.
int draw_surface(const SurfaceOptions& options, const SurfaceRequest& request);

} // namespace wakesurf::server
