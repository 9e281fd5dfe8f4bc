"""A source for ParaView: a surface of a wakesurf session, live. Tools, Manage Plugins, Load New: this file.

ParaView's line widget moves the rake in the session, for everyone there; the surface follows, also when others move the rake. ParaView's time is
the time that is asked for. docs/how-to/paraview.md is the guide. Tested with ParaView 5.11.
"""
import inspect
import os
import sys

if not hasattr(inspect, "getargspec"):  # Python 3.11 has it no longer, and ParaView 5.11 asks for it
    inspect.getargspec = inspect.getfullargspec

from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smhint, smproperty, smproxy  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkPolyData  # noqa: E402

# The client: beside this folder in the repository, and in share/wakesurf/python where the program is installed.
_above = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
for _folder in (_above, os.path.join(_above, "python")):
    if os.path.exists(os.path.join(_folder, "wakesurf", "link.py")) and _folder not in sys.path:
        sys.path.append(_folder)

from wakesurf.errors import WakesurfError  # noqa: E402
from wakesurf.link import Link  # noqa: E402

KINDS = ("", "stream", "path", "streak", "time")


def _property(tag, name, default, words, inside="", **more):
    attributes = "".join(f' {key}="{value}"' for key, value in more.items())
    return (f'<{tag}VectorProperty name="{name}" command="Set{name}" number_of_elements="{len(default.split()) or 1}" '
            f'default_values="{default}"{attributes}>{inside}<Documentation>{words}</Documentation></{tag}VectorProperty>')


# In the order of the panel; decorators of methods would sort them by their names.
PANEL = (
    _property("String", "Address", "", "The link that the server printed, or that Share made, with its #token=...; empty: $WAKESURF_URL."),
    _property("String", "Session", "", "Empty: the one in the address."),
    _property("String", "Surface", "", "The id of a surface that is there, as s1; empty: a new one, on a rake of its own."),
    _property("String", "Dataset", "", "Of a new surface; empty: the only one that the server has."),
    _property("Int", "Kind", "0", "Of the surface.", '<EnumerationDomain name="enum">' + "".join(
        f'<Entry text="{kind.capitalize() or "As it is"}" value="{i}"/>' for i, kind in enumerate(KINDS)) + "</EnumerationDomain>"),
    _property("Double", "RakePoint1", "0 0 0", "While both points are the same, the rake stays where the session has it."),
    _property("Double", "RakePoint2", "0 0 0", "The other end of the rake."),
    '<PropertyGroup label="Rake" panel_widget="InteractiveLine"><Property function="Point1WorldPosition" name="RakePoint1"/>'
    '<Property function="Point2WorldPosition" name="RakePoint2"/></PropertyGroup>',
    _property("Double", "FromTo", "0 0", "First release, and end; both the same: as the session has them."),
    _property("Double", "Separation", "0", "Longest edge allowed; 0: as the session has it."),
    _property("String", "Fields", "", "Further arrays, between commas: fields of the dataset, vorticity, q_criterion, deformation."),
    '<DoubleVectorProperty name="TimestepValues" information_only="1" si_class="vtkSITimeStepsProperty"/>',
)


@smproxy.source(name="WakesurfSurface", label="Wakesurf Surface")
@smhint.xml('<LiveSource interval="500"/>')
@smproperty.xml("".join(PANEL))
class WakesurfSurface(VTKPythonAlgorithmBase):
    """Connects when it is first updated. Another address, session, surface or dataset connects anew."""

    def __init__(self):
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self._where = {"url": "", "session": "", "surface": "", "dataset": ""}
        self._kind, self._line, self._fields, self._separation = "", ((0.0,) * 3, (0.0,) * 3), [], 0.0
        self._span = (0.0, 0.0)
        self._link = None

    def _set(self, name, value):
        if getattr(self, name) != value:
            setattr(self, name, value)
            self.Modified()

    def _go(self, name, value):
        value = (value or "").strip()
        if self._where[name] != value:
            self._where[name], self._link = value, None
            self.Modified()

    # ParaView sets these from its panel, by the names that are in PANEL.

    def SetAddress(self, address):
        self._go("url", address)

    def SetSession(self, session):
        self._go("session", session)

    def SetSurface(self, surface):
        self._go("surface", surface)

    def SetDataset(self, dataset):
        self._go("dataset", dataset)

    def SetKind(self, kind):
        self._set("_kind", KINDS[kind])

    def SetRakePoint1(self, x, y, z):
        self._set("_line", ((x, y, z), self._line[1]))

    def SetRakePoint2(self, x, y, z):
        self._set("_line", (self._line[0], (x, y, z)))

    def SetFromTo(self, first, last):
        self._set("_span", (first, last))

    def SetSeparation(self, separation):
        self._set("_separation", separation)

    def SetFields(self, fields):
        self._set("_fields", [name.strip() for name in (fields or "").split(",") if name.strip()])

    # What ParaView asks.

    def GetNeedsUpdate(self):
        """Asked now and then while ParaView is idle: has anyone changed something?"""
        if self._link is not None and self._safely(lambda link: link.changed()):
            self.Modified()
            return True
        return False

    def RequestInformation(self, request, inputs, outputs):
        steps = self._safely(self._ask)
        if steps is None:
            return 0
        executive, information = self.GetExecutive(), outputs.GetInformationObject(0)
        information.Remove(executive.TIME_STEPS())
        information.Remove(executive.TIME_RANGE())
        for time in steps:
            information.Append(executive.TIME_STEPS(), time)
        for time in steps[:1] + steps[-1:]:
            information.Append(executive.TIME_RANGE(), time)
        return 1

    def RequestData(self, request, inputs, outputs):
        key, information = self.GetExecutive().UPDATE_TIME_STEP(), outputs.GetInformationObject(0)
        time = information.Get(key) if information.Has(key) else None
        mesh = self._safely(lambda link: link.mesh(time))
        if mesh is None:
            return 0
        output = vtkPolyData.GetData(outputs)
        output.ShallowCopy(mesh.to_vtk())
        if "time" in mesh.about:
            output.GetInformation().Set(output.DATA_TIME_STEP(), mesh.about["time"])
        return 1

    def _ask(self, link):
        """Tells the session what the panel asks for; returns the times that there are then."""
        wanted = {"kind": self._kind, "separation": self._separation, "fields": self._fields}
        changes = {name: value for name, value in wanted.items() if value}
        if self._span[0] != self._span[1]:
            changes.update(from_=self._span[0], to=self._span[1])
        if self._line[0] != self._line[1]:
            link.move(self._line)
        link.change(changes)
        return link.steps()

    def _safely(self, ask):
        """What the link answers. None after an error, which is then among ParaView's messages."""
        try:
            if self._link is None:
                self._link = Link(kind=self._kind or "streak", **self._where)
            return ask(self._link)
        except WakesurfError as problem:
            print(f"wakesurf: {problem}" + (f"; {problem.hint}" if problem.hint else ""), file=sys.stderr)
            return None
