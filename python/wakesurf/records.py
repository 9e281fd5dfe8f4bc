"""What the server answers, as types: `wakesurf.records.Dataset`."""
from .generated.records import *  # noqa: F401,F403
from .generated.records import __all__ as __all__
