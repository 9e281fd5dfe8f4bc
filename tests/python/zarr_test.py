"""Arrays of Zarr, served in place: surfaces have the bytes of the same data imported into a store."""
import base64
import gzip
import json
import os
import signal
import socket
import subprocess
import tempfile
import time
import unittest

import numcodecs
import numpy
import zarr

from real_server import BINARY, RealServer

import wakesurf  # real_server says where

RAKE = ["--rake", "0.4,0.5,0.1 0.6,0.5,0.8", "--to", "1", "--separation", "0.02"]
KINDS = {"stream": [], "path": [], "streak": [], "time": ["--sweep", "0,0.1,0"]}


def said(*words, status=0, **environment):
    done = subprocess.run([BINARY, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120, check=False,
                          env={**os.environ, **environment})
    if done.returncode != status:
        raise AssertionError(f"{words}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def put(folder, name, text):
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb" if isinstance(text, bytes) else "w") as file:
        file.write(text)


def values_of(store):
    """Times, coordinates along each axis, and velocities of a uniform store of whole time-steps."""
    with open(os.path.join(store, "store.json"), encoding="utf-8") as file:
        about = json.load(file)
    nx, ny, nz = about["grid"]["dimensions"]
    origin, spacing = about["grid"]["origin"], about["grid"]["spacing"]
    places = {axis: origin[i] + spacing[i] * numpy.arange(count) for i, (axis, count) in enumerate(zip("xyz", (nx, ny, nz)))}
    times = numpy.array(about["times"])
    return times, places, numpy.stack([numpy.fromfile(os.path.join(store, f"velocity_{step:06}.f32"), "<f4").reshape(nz, ny, nx, 3)
                                       for step in range(len(times))])


class Zarr3:
    """A group of version 3, written by hand: Debian's zarr writes version 2."""

    def __init__(self, folder):
        self.folder = folder
        put(folder, "zarr.json", json.dumps({"zarr_format": 3, "node_type": "group"}))

    def add(self, name, values, chunks, codecs, pack, separator="/", dimensions=None, fill=0.0, attributes=None):
        big = codecs[0]["configuration"]["endian"] == "big"
        put(self.folder, f"{name}/zarr.json", json.dumps({
            "zarr_format": 3, "node_type": "array", "shape": values.shape, "data_type": str(values.dtype), "fill_value": fill,
            "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": chunks}},
            "chunk_key_encoding": {"name": "default", "configuration": {"separator": separator}},
            "codecs": codecs, "attributes": attributes or {}, "dimension_names": dimensions}))
        for at in numpy.ndindex(*(-(-length // chunk) for length, chunk in zip(values.shape, chunks))):
            part = numpy.zeros(chunks, values.dtype)
            there = values[tuple(slice(i * chunk, (i + 1) * chunk) for i, chunk in zip(at, chunks))]
            part[tuple(slice(0, length) for length in there.shape)] = there
            numbers = part.astype(part.dtype.newbyteorder(">" if big else "<")).tobytes()
            put(self.folder, f"{name}/c{separator}{separator.join(map(str, at))}", pack(numbers))


# Chunks are files, and to remove thousands takes longer than all surfaces. Where cutting is not the question they are COARSE, of which
# the last along x is not full.
COARSE, FINE = (1, 37, 20, 26), (1, 16, 20, 24)
BYTES = {"name": "bytes", "configuration": {"endian": "little"}}


class ZarrTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        cls.store = os.path.join(cls.folder, "store")
        said("generate", "flow:tornado", cls.store, "--grid", "50,40,37", "--times", "0:1:5")
        cls.times, cls.places, cls.velocity = values_of(cls.store)
        cls.wanted = {}

    def path(self, name):
        return os.path.join(self.folder, name)

    def surface(self, dataset, kind, *more):
        file = self.path("out.ply")
        said("surface", dataset, "--kind", kind, *RAKE, *KINDS[kind], *more, "-o", file)
        with open(file, "rb") as ply:
            return ply.read().split(b"end_header")[1]

    def assert_same_surfaces(self, dataset, kinds=tuple(KINDS), *more):
        for kind in kinds:
            wanted = self.wanted.setdefault((kind, *more), self.surface(self.store, kind, *more))
            self.assertGreater(len(wanted), 1000)
            self.assertEqual(self.surface(dataset, kind, *more), wanted, f"{dataset} {kind} {more}")

    def group(self, name, chunks=COARSE, dtype="<f4", values=None, attributes=None, **options):
        """u, v and w, and their coordinates, as xarray writes them; unless said otherwise in one file a chunk, uncompressed."""
        folder = self.path(name)
        group = zarr.open_group(folder, mode="w")
        values = self.velocity if values is None else values
        for i, part in enumerate("uvw"):
            array = group.create_dataset(part, data=values[..., i].astype(dtype), chunks=chunks, dtype=dtype,
                                         **{"compressor": None, **options})
            array.attrs.update({"_ARRAY_DIMENSIONS": ["time", "z", "y", "x"], "units": "m s-1", **(attributes or {})})
        self.coordinates(group)
        return folder

    def coordinates(self, group):
        for axis, places in {**self.places, "time": self.times}.items():
            array = group.create_dataset(axis, data=places, compressor=None)
            array.attrs["_ARRAY_DIMENSIONS"] = [axis]
            array.attrs["units"] = "seconds since 2000-01-01" if axis == "time" else "m"

    def test_surfaces_have_the_bytes_of_those_of_the_store(self):
        plain = self.group("plain.zarr", FINE)
        self.assert_same_surfaces(plain)
        for accuracy in ("fast", "exact"):
            self.assert_same_surfaces(plain, ("path", "streak"), "--accuracy", accuracy)

    def test_it_does_not_matter_how_chunks_are_cut_and_packed(self):
        blosc = numcodecs.Blosc
        for name, options in {
                "whole.zarr": {"chunks": (5, 37, 40, 50)},
                "large.zarr": {"chunks": (2, 64, 64, 64)},
                "odd.zarr": {"chunks": (5, 37, 1, 50), "dimension_separator": "/"},
                "zlib.zarr": {"compressor": numcodecs.Zlib()},
                "gzip.zarr": {"compressor": numcodecs.GZip()},
                "zstd.zarr": {"compressor": numcodecs.Zstd()},
                "lz4.zarr": {"compressor": blosc("lz4", shuffle=blosc.SHUFFLE)},
                "blosczstd.zarr": {"compressor": blosc("zstd", shuffle=blosc.BITSHUFFLE), "dimension_separator": "/"},
                "big.zarr": {"dtype": ">f4", "compressor": blosc("blosclz")},
                "double.zarr": {"dtype": "<f8"},
                "bigdouble.zarr": {"dtype": ">f8"}}.items():
            self.assert_same_surfaces(self.group(name, **options), ("streak",))

    def test_numbers_of_16_bits_are_the_values_that_they_stand_for(self):
        self.assertEqual(self.surface(self.group("half.zarr", dtype="<f2"), "streak"),
                         self.surface(self.group("rounded.zarr", values=self.velocity.astype("<f2")), "streak"))
        most = float(numpy.abs(self.velocity).max())
        scale, offset = most / 30000, -most / 20
        for name, dtype in (("packed.zarr", "<i2"), ("bigpacked.zarr", ">i2")):
            numbers = numpy.round((self.velocity.astype("<f8") - offset) / scale)
            gap = numpy.zeros(numbers.shape, bool)
            gap[:, 10:20, 12:22, 20:26] = name == "bigpacked.zarr"
            stored = self.group(name, dtype=dtype, values=numpy.where(gap, -32768, numbers), fill_value=-32768 if gap.any() else 0,
                                attributes={"scale_factor": scale, "add_offset": offset})
            values = numpy.where(gap, numpy.nan, scale * numbers + offset).astype("<f4")
            plain = self.group("unpacked.zarr", values=values, fill_value=float("nan") if gap.any() else 0.0)
            for kind in ("path", "streak"):
                mesh = self.surface(stored, kind)
                self.assertGreater(len(mesh), 1000)
                self.assertEqual(mesh, self.surface(plain, kind), f"{name} {kind}")

    def test_the_metadata_may_be_consolidated(self):
        folder = self.group("consolidated.zarr")
        zarr.consolidate_metadata(folder)
        for part in "uvw":
            os.remove(os.path.join(folder, part, ".zarray"))
        self.assert_same_surfaces(folder, ("path",))

    def test_the_components_may_be_an_axis_at_the_end_or_behind_the_time(self):
        for name, order, chunks in (("last.zarr", (0, 1, 2, 3, 4), (1, 20, 20, 20, 3)), ("split.zarr", (0, 1, 2, 3, 4), (1, 37, 20, 20, 2)),
                                    ("first.zarr", (0, 4, 1, 2, 3), (1, 1, 20, 20, 20)), ("xyz.zarr", (3, 2, 1, 0, 4), (20, 20, 20, 1, 3))):
            group = zarr.open_group(self.path(name), mode="w")
            array = group.create_dataset("velocity", data=self.velocity.transpose(order), chunks=chunks, compressor=None)
            if name != "split.zarr":
                array.attrs["_ARRAY_DIMENSIONS"] = [("time", "z", "y", "x", "component")[axis] for axis in order]
            self.coordinates(group)
            self.assert_same_surfaces(self.path(name), ("path",))

    def test_version_3_is_read_without_shards(self):
        packers = {
            "plain": ([BYTES], bytes),
            "big": ([{"name": "bytes", "configuration": {"endian": "big"}}], bytes),
            "gzip": ([BYTES, {"name": "gzip", "configuration": {"level": 5}}], gzip.compress),
            "zstd": ([BYTES, {"name": "zstd", "configuration": {"level": 0, "checksum": False}}], numcodecs.Zstd().encode),
            "blosc": ([BYTES, {"name": "blosc", "configuration": {"cname": "zstd", "clevel": 5, "shuffle": "shuffle", "typesize": 4,
                                                                  "blocksize": 0}}], lambda b: numcodecs.Blosc("zstd").encode(b)),
            "summed": ([BYTES, {"name": "crc32c"}], lambda b: b + int(crc32c(b)).to_bytes(4, "little"))}
        for name, (codecs, pack) in packers.items():
            group = Zarr3(self.path(f"{name}3.zarr"))
            chunks = {"plain": FINE, "summed": (1, 37, 40, 50)}.get(name, COARSE)
            for i, part in enumerate("uvw"):
                group.add(part, self.velocity[..., i], chunks, codecs, pack, "." if name == "gzip" else "/", ["time", "z", "y", "x"])
            for axis, places in {**self.places, "time": self.times}.items():
                group.add(axis, places, places.shape, [BYTES], bytes, dimensions=[axis])
            self.assert_same_surfaces(group.folder, ("streak",))

    def test_rectilinear_data_with_gaps_have_the_surfaces_of_their_import(self):
        places = {axis: along ** 1.2 for axis, along in self.places.items()}
        velocity = self.velocity.copy()
        velocity[:, 10:20, 12:22, 20:26] = numpy.nan
        folder = self.path("files")
        os.makedirs(folder)
        with open(os.path.join(folder, "wake.pvd"), "w", encoding="utf-8") as series:
            series.write('<VTKFile type="Collection" version="0.1"><Collection>')
            for step, values in enumerate(velocity):
                write_vtr(os.path.join(folder, f"wake_{step}.vtr"), places, values)
                series.write(f'<DataSet timestep="{self.times[step]!r}" file="wake_{step}.vtr"/>')
            series.write("</Collection></VTKFile>")
        for layout in ("whole", "bricks"):
            said("import", os.path.join(folder, "wake.pvd"), self.path(layout), "--layout", layout)
        group = zarr.open_group(self.path("stretched.zarr"), mode="w")
        for i, part in enumerate("uvw"):
            array = group.create_dataset(part, data=velocity[..., i], chunks=(1, 20, 20, 26), fill_value=float("nan"))
            array.attrs["_ARRAY_DIMENSIONS"] = ["time", "z", "y", "x"]
        for axis, along in {**places, "time": self.times}.items():
            group.create_dataset(axis, data=along).attrs["_ARRAY_DIMENSIONS"] = [axis]
        self.assertIn("rectilinear", said("info", self.path("stretched.zarr")))
        with Nginx(self.folder) as address:
            for kind in KINDS:
                wanted = self.surface(self.path("whole"), kind)
                self.assertGreater(len(wanted), 1000)
                self.assertEqual(self.surface(self.path("stretched.zarr"), kind), wanted, kind)
                self.assertEqual(self.surface(f"{address}/stretched.zarr", kind), wanted, f"{kind}, by brick")

    def test_from_a_web_server_they_come_by_brick_and_are_the_same(self):
        self.group("far.zarr", FINE, compressor=numcodecs.Blosc())
        zarr.consolidate_metadata(self.path("far.zarr"))
        with Nginx(self.folder) as address:
            self.assertIn("brick by brick: the Zarr is on the web", said("info", f"{address}/far.zarr"))
            self.assert_same_surfaces(f"{address}/far.zarr")
            self.group("alone.zarr")
            self.assert_same_surfaces(f"{address}/alone.zarr", ("path",))
            self.assertIn("without consolidated metadata", said("info", f"{address}/alone.zarr"))
            self.assertIn("none.zarr holds no Zarr", said("info", f"{address}/none.zarr", status=1))

    def served(self, dataset, *options):
        """What a server says of it, and the bytes of a streak surface there; and what is in memory of its time-steps then."""
        server = RealServer(dataset, *options)
        self.addCleanup(server.stop)
        client = wakesurf.Client(server.url)
        name = client.dataset
        client.api.dataset.open(dataset=name)  # the server answers before its data are open
        session = client.create_session("zarr")
        rake = session.rake(line=[(0.4, 0.5, 0.1), (0.6, 0.5, 0.8)], seeds=16)
        surface = session.surface(rake, "streak", dataset=name, to=float(self.times[-1]), separation=0.02)
        surface.wait()
        return client.describe(name), surface.download("ply").split(b"end_header")[1], client.cache(name)

    def test_a_server_says_what_it_is_and_has_the_surfaces_of_the_store(self):
        said_of, mesh, cache = self.served(self.group("served.zarr", compressor=numcodecs.Blosc()))
        self.assertEqual((said_of["name"], said_of["reader"], said_of["velocity"]), ("served.zarr", "Zarr, version 2", "u, v, w"))
        self.assertEqual(said_of["fields"][0]["range"], [None, None])
        self.assertEqual({resident for resident, _ in cache["held"]} - {0}, {cache["bytesPerStep"]})
        self.assertGreater(len(mesh), 1000)
        self.assertEqual(mesh, self.served(self.store)[1])

    def test_time_steps_that_do_not_fit_come_by_brick_and_surfaces_are_the_same(self):
        whole = self.path("large")
        said("generate", "flow:tornado", whole, "--grid", "129,129,97", "--times", "0:1:5", "--layout", "whole")
        times, places, values = values_of(whole)
        group = zarr.open_group(self.path("paged.zarr"), mode="w")
        group.create_dataset("velocity", data=values, chunks=(1, 48, 48, 48, 3), compressor=numcodecs.Blosc())
        group["velocity"].attrs["_ARRAY_DIMENSIONS"] = ["time", "z", "y", "x", "component"]
        for axis, along in {**places, "time": times}.items():
            group.create_dataset(axis, data=along).attrs["_ARRAY_DIMENSIONS"] = [axis]
        _, mesh, cache = self.served(self.path("paged.zarr"), "--memory", "112MiB")
        self.assertTrue(any(0 < resident < cache["bytesPerStep"] for resident, _ in cache["held"]), cache["held"])
        self.assertGreater(len(mesh), 1000)
        self.assertEqual(mesh, self.served(whole)[1])

    def test_a_damaged_chunk_ends_the_surface_which_says_so(self):
        packed = self.group("damaged.zarr", compressor=numcodecs.Blosc())
        for part in os.listdir(os.path.join(packed, "v")):
            if part.startswith("3."):
                put(packed, f"v/{part}", b"\2\1\1\4 no blosc at all")
        told = said("surface", packed, "--kind", "streak", *RAKE, "-o", self.path("out.ply"))
        self.assertRegex(told, r"chunk v/3\.\d\.\d\.\d: c-blosc cannot unpack it")

    def test_scalars_come_along_and_what_does_not_is_named_with_the_reason(self):
        folder = self.group("fields.zarr")
        group = zarr.open_group(folder)
        group.create_dataset("p", data=self.velocity[..., 0] ** 2, chunks=(1, 20, 40, 50))
        group.create_dataset("coarse", data=self.velocity[:, ::2, ::2, ::2, 0])
        group.create_dataset("fortran", data=self.velocity[..., 0], order="F")
        told = said("info", folder)
        self.assertIn("reader    Zarr, version 2", told)
        self.assertIn("stored    chunks of a Zarr", told)
        self.assertIn("field     p, 1 component, point data, range not known", told)
        self.assertRegex(told, r"left out: coarse \(on other nodes\), fortran \(its numbers lie in Fortran's order")
        self.assertIn("p, velocity", told.replace("u, v, w", "velocity").split("carried", 1)[1])
        said("surface", folder, "--kind", "path", *RAKE, "--fields", "p", "-o", self.path("p.vtp"))

    def test_memory_that_holds_no_chunk_is_refused_with_how_much_does(self):
        folder = self.group("huge.zarr", chunks=(4, 128, 128, 128), compressor=numcodecs.Zlib())
        told = said("surface", folder, "--kind", "path", *RAKE, "--memory", "64MiB", "-o", self.path("out.ply"), status=1)
        self.assertRegex(told, r"the dataset needs at least \d+ MiB of memory")
        least = told.split("--memory ")[-1].split("MiB")[0]
        said("surface", folder, "--kind", "path", *RAKE, "--memory", f"{least}MiB", "-o", self.path("out.ply"))

    def test_nothing_is_written_into_a_zarr(self):
        folder = self.group("read.zarr")
        before = sorted(os.listdir(folder))
        self.assertIn("nothing is written to the web or into a Zarr",
                      said("family", folder, "--name", "psi", "--plane", "0.5,0.5,0.5 0,0,1", status=1))
        self.assertEqual(sorted(os.listdir(folder)), before)

    def test_units_that_do_not_fit_each_other_are_refused(self):
        folder = self.group("hours.zarr")
        zarr.open_group(folder)["time"].attrs["units"] = "hours since 2000-01-01"
        self.assertIn("times are in hours, but the velocity is in m s-1", said("info", folder, status=1))


class Nginx:
    """A folder on a web server; `with` gives its address."""

    def __init__(self, folder):
        self.own = tempfile.TemporaryDirectory()
        with socket.create_server(("127.0.0.1", 0)) as free:
            self.port = free.getsockname()[1]
        put(self.own.name, "nginx.conf", f"""daemon off; master_process off; pid nginx.pid; error_log stderr;
            {"user root;" if os.getuid() == 0 else ""} events {{}}
            http {{ access_log off; {" ".join(f"{what}_temp_path t;" for what in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi"))}
            server {{ listen 127.0.0.1:{self.port}; location / {{ root {folder}; }} }} }}""")

    def __enter__(self):
        self.process = subprocess.Popen(["/usr/sbin/nginx", "-p", self.own.name, "-c", "nginx.conf"], stderr=subprocess.DEVNULL)
        while self.process.poll() is None:
            try:
                socket.create_connection(("127.0.0.1", self.port)).close()
                return f"http://127.0.0.1:{self.port}"
            except ConnectionRefusedError:
                time.sleep(0.01)
        raise RuntimeError("nginx has ended")

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGTERM)
        self.process.wait()
        self.own.cleanup()


def write_vtr(path, places, velocity):
    """A rectilinear grid of VTK, in binary."""
    def array(name, values, components):
        data = numpy.ascontiguousarray(values).tobytes()
        kind = {4: "Float32", 8: "Float64"}[values.dtype.itemsize]
        text = base64.b64encode(numpy.uint64(len(data)).tobytes() + data).decode()
        return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="binary">{text}</DataArray>'
    extent = " ".join(f"0 {len(places[axis]) - 1}" for axis in "xyz")
    put(os.path.dirname(path), os.path.basename(path), f"""<?xml version="1.0"?>
<VTKFile type="RectilinearGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64"><RectilinearGrid WholeExtent="{extent}">
<Piece Extent="{extent}"><PointData>{array("velocity", velocity, 3)}</PointData>
<Coordinates>{"".join(array(axis, places[axis], 1) for axis in "xyz")}</Coordinates></Piece></RectilinearGrid></VTKFile>""")


def crc32c(data):
    table = numpy.arange(256, dtype=numpy.uint32)
    for _ in range(8):
        table = numpy.where(table & 1, (table >> 1) ^ 0x82F63B78, table >> 1)
    table = table.tolist()
    out = 0xFFFFFFFF
    for byte in data:
        out = (out >> 8) ^ table[(out ^ byte) & 255]
    return out ^ 0xFFFFFFFF


if __name__ == "__main__":
    unittest.main()
