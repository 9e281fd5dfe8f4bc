"""Tools for programs that are driven by a language model: a server of the Model Context Protocol over standard input and output.

    python -m wakesurf.mcp case.foam --folder results      # or: wakesurf mcp case.foam, or wakesurf-mcp case.foam

It works in a session of a wakesurf server, beside the people who look at it, with the rights of the link that it was given: that of $WAKESURF_URL
or --url, else a server of its own. Numbers come before pictures: every answer has the numbers as an object, and a sentence. See
docs/how-to/agents.md.

`wire` has the messages, `server` the protocol, `tool` what a tool is, `work` the session that the tools work in, `numbers` what is told of
meshes, `place` the folder that files are written to; the tools are in the modules whose names end in _tools.
"""
from .program import main

__all__ = ["main"]
