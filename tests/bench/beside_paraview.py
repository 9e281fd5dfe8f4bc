"""What ParaView shows of the bundled simulation from a rake, for docs/measured.md: pvpython beside_paraview.py stream|streak.

Prints points, polylines, processor time since the pipeline began, and the largest memory of the whole process. `wakesurf surface` under
GNU time says the same of a surface from that rake.
"""
import os
import resource
import sys

from paraview import simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../data/sqcyl/sqcyl.pvd")
RAKE = {"Point1": [-1.5, -1.2, 1], "Point2": [-1.5, 1.2, 5], "Resolution": 63}


def spent():
    use = resource.getrusage(resource.RUSAGE_SELF)
    return use.ru_utime + use.ru_stime


def streamlines(data, times):
    lines = simple.StreamTracer(Input=data, SeedType="Line", Vectors=["POINTS", "U"], IntegrationDirection="FORWARD",
                                MaximumStreamlineLength=40)
    for name, value in RAKE.items():
        setattr(lines.SeedType, name, value)
    lines.UpdatePipeline(times[-1])
    return lines


def streaklines(data, times):
    lines = simple.StreakLine(Input=data, SeedSource=simple.Line(**RAKE), SelectInputVectors=["POINTS", "U"])
    for time in times:
        lines.UpdatePipeline(time)
    return lines


def main():
    begun = spent()
    data = simple.PVDReader(FileName=DATA)
    made = {"stream": streamlines, "streak": streaklines}[sys.argv[1]](data, list(data.TimestepValues))
    info = made.GetDataInformation()
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{sys.argv[1]}lines of ParaView {simple.GetParaViewVersion()}: {info.GetNumberOfPoints()} points, {info.GetNumberOfCells()} lines, "
          f"{spent() - begun:.2f} s of processor, {memory:.0f} MB")


main()
