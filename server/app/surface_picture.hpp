// `wakesurf surface DATA -o a.png`: the surface as the page draws it, with the same colours, scalar bar, axes
// and shading, by the same code. So a picture needs Chromium, without a window, and a server meanwhile; the
// client for Python starts both (python/wakesurf/draw.py).
#pragma once

#include "server/app/surface_request.hpp"

namespace wakesurf::server {

/// Returns only if Python cannot be started, with the exit status.
int draw_surface(const SurfaceOptions& options, const SurfaceRequest& request);

} // namespace wakesurf::server
