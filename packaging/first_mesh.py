"""What a script does first, against a running server: first_mesh.py URL. Prints the quads and points of a streak surface of the bundled
simulation, by whatever `wakesurf` this Python has installed."""
import sys

import numpy as np
import wakesurf

with wakesurf.Client(sys.argv[1]) as server:
    session = server.session()
    rake = session.rake(line=[(-1.5, -1.2, 1), (-1.5, 1.2, 5)], seeds=32)
    surface = session.surface(rake, "streak", dataset="sqcyl", to=16)
    quads = surface.wait(timeout=60)["quads"]
    points = surface.mesh().points
    if quads == 0 or points.shape[1] != 3 or not np.isfinite(points).all():
        sys.exit("the surface is empty or no surface")
    print("quads", quads, "points", len(points), "by", wakesurf.__file__)
