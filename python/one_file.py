"""wakesurf, the client for Python, as one file to copy: its modules as texts, and what imports them from here.

The page's build puts the texts of python/wakesurf in, and the server has the result at /wakesurf.py.
"""
import importlib.abc
import importlib.util
import sys

_SOURCES = {}  # by name of the module below this one, with its path; a package's own is NAME/__init__


class _Modules(importlib.abc.MetaPathFinder, importlib.abc.InspectLoader):
    def _key(self, fullname):
        head, _, rest = fullname.partition(".")
        path = rest.replace(".", "/")
        return next((key for key in (path, path + "/__init__") if head == __name__ and key in _SOURCES), None)

    def find_spec(self, fullname, path=None, target=None):
        return importlib.util.spec_from_loader(fullname, self, origin="wakesurf.py") if self._key(fullname) else None

    def is_package(self, fullname):
        return self._key(fullname).endswith("/__init__")

    def get_source(self, fullname):
        return _SOURCES[self._key(fullname)]


sys.meta_path.append(_Modules())
__path__ = []
__package__ = __name__
if __spec__ is not None:
    __spec__.submodule_search_locations = __path__
exec(compile(_SOURCES["__init__"], "wakesurf/__init__.py", "exec"), globals())
