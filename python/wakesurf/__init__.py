"""A client of wakesurf for scripts and notebooks; it needs the standard library and numpy.

    from wakesurf import Client

    with Client("http://127.0.0.1:8080/#token=...") as server:     # the line the server prints; or $WAKESURF_URL
        print(server.datasets())
        session = server.session()                                 # the one called "main"
        rake = session.rake(line=[(-1.5, -1.2, 1), (-1.5, 1.2, 5)], seeds=64)
        surface = session.surface(rake, "streak", dataset="sqcyl", to=16)
        print(surface.wait()["quads"])
        mesh = surface.mesh()                                      # mesh.points, mesh.polygons, mesh["speed"]: numpy
        surface.export("wake.vtp")                                 # for ParaView, see also .glb, .ply, .obj

`serve` starts a server of its own where the program wakesurf is installed: `with wakesurf.serve("case.foam") as session`. `study` makes
many surfaces on many cores or machines.

Everything goes over HTTP (urllib). What the server tells by itself (`Session.watch`, `Surface.watch`, `Surface.live`), and how far a
surface is, needs a WebSocket, and for it the package `websocket-client` (Debian: python3-websocket). Pictures and films are drawn by the
server's page in Chromium. `to_vtk`, `to_pyvista`, `to_meshio` and `to_dataframe` need those packages.

`Session.api` and `Client.api` have every method of the server with its parameters. What they answer are dictionaries; their types are in
`wakesurf.records`. The protocol itself is described in protocol/README.md and, machine readable, by the server at /openrpc.json.

Failures are subclasses of `WakesurfError`; each has `code`, `kind`, `hint` and `data` as the server gave them.
Objects may be used by one thread at a time.
"""
from . import notifications, numbers, records
from .client import Client
from .connection import Connection
from .errors import (BrowserMissing, Cancelled, DatasetError, InvalidParameters, InvalidPoints, InvalidRequest, Leased,
                     MethodNotFound, MissingParameter, NoSuchArray, NotFound, NotPermitted, OutsideDomain, OutsideTimeRange, OverLimit, PictureFailed,
                     ServerFailed,
                     ServerFault, ServerMissing, Stale, Unauthenticated, UnknownParameter, Unreachable, WaitTimeout, WakesurfError, WorkersLost)
from .files import write_series
from .generated.version import VERSION as __version__
from .mesh import Mesh
from .progress import Progress
from .record import Rake
from .series import Series
from .serve import Server, serve
from .session import Session
from .slice import Slice
from .streamlines import Streamlines
from .study import Study, study
from .surface import Surface, Update
from .view import Camera, Look, SurfaceLook

__all__ = ["BrowserMissing", "Camera", "Cancelled", "Client", "Connection", "DatasetError", "InvalidParameters", "InvalidPoints", "InvalidRequest", "Leased", "Look",
           "Mesh", "MethodNotFound", "MissingParameter", "NoSuchArray", "NotFound", "NotPermitted", "OutsideDomain", "OutsideTimeRange", "OverLimit",
           "PictureFailed", "Progress", "Rake", "Series", "Server", "ServerFailed", "ServerFault", "ServerMissing", "Session", "Slice", "Stale", "Streamlines", "Study",
           "Surface", "SurfaceLook", "Unauthenticated", "UnknownParameter", "Unreachable", "Update", "WaitTimeout",
           "WakesurfError", "WorkersLost", "__version__", "notifications", "numbers", "records", "serve", "study", "write_series"]
