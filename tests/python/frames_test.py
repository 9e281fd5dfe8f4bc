"""python/wakesurf/frames.py: the golden frames that the page's decoder reads too, and damage, by libwakesurf_frames.so."""
import json
import os
import random
import struct
import unittest
import zlib

import numpy as np

from real_server import BINARY, ROOT
from wakesurf.frames import FrameError, MeshDecoder

FIXTURES = os.path.join(ROOT, "protocol/wire/fixtures")
LIBRARY = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(BINARY))), "lib/libwakesurf_frames.so")


def golden_frames(name):
    with open(os.path.join(FIXTURES, name + ".bin"), "rb") as file:
        data = file.read()
    frames, at = [], 0
    while at < len(data):
        (size,) = struct.unpack_from("<I", data, at)
        frames.append(data[at + 4:at + 4 + size])
        at += 4 + size
    return frames


def sealed(frame):
    """With the frame's own checksum made right again."""
    return frame[:44] + struct.pack("<I", zlib.crc32(frame[48:], zlib.crc32(frame[:44]))) + frame[48:]


class FramesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(os.path.join(FIXTURES, "golden.json"), encoding="utf-8") as file:
            cls.golden = json.load(file)

    def decoder(self):
        return MeshDecoder(LIBRARY)

    def states(self, name):
        decoder = self.decoder()
        folded = [decoder.fold(frame) for frame in golden_frames(name)]
        return [state for state in folded if state is not None]

    def test_a_vertex_without_a_value_has_nan(self):
        name = next(name for name in self.golden if golden_frames(name)[0][22] >= 3 and len(self.states(name)[0].nodes))
        key, *deltas = golden_frames(name)
        marked = sealed(key[:23] + bytes([0b001]) + key[24:])
        state, whole = self.decoder().fold(marked), self.states(name)[0]
        lo, hi = whole.attributes[0].min(), whole.attributes[0].max()  # those of the range, as in every new KEY
        codes = np.rint((whole.attributes[0] - lo) / (hi - lo) * 0xFFFF)
        expected = np.where(codes >= 0xF800, np.nan, lo + (hi - lo) * codes / 0xEFFF)
        np.testing.assert_allclose(state.attributes[0], expected, rtol=1e-12)
        self.assertGreater(np.isnan(expected).sum(), 0)
        np.testing.assert_array_equal(state.attributes[1], whole.attributes[1])
        if deltas:
            decoder = self.decoder()
            decoder.fold(marked)
            with self.assertRaises(FrameError):
                decoder.fold(deltas[0])
        with self.assertRaises(FrameError):
            self.decoder().fold(sealed(key[:23] + bytes([1 << key[22]]) + key[24:]))

    def test_golden_frames_decode_to_what_the_other_decoders_make_of_them(self):
        for name, expected in self.golden.items():
            with self.subTest(name):
                states = self.states(name)
                self.assertEqual([state.seq for state in states], expected["seqs"])
                self.assertEqual([state.state_sum for state in states], expected["stateSums"])
                last = states[-1]
                self.assertEqual((len(last.nodes), len(last.cells)), (expected["vertices"], expected["cells"]))
                if len(last.nodes):
                    for which, index in (("firstVertex", 0), ("lastVertex", -1)):
                        vertex = expected[which]
                        self.assertEqual(last.nodes[index].tolist(), vertex["node"])
                        np.testing.assert_array_equal(
                            last.points(expected["lattice"])[index].astype(np.float32),
                            np.array(vertex["position"], np.float32))
                        values = [attribute[index] for attribute in last.attributes]
                        np.testing.assert_array_equal(np.array(values, np.float32), np.array(vertex["attributes"], np.float32))
                    self.assertEqual(last.cells[0].astype(np.uint32).tolist(), expected["firstCell"])

    def test_a_polygon_goes_round_its_cell_over_the_mids(self):
        state = self.states("hanging")[-1]
        connectivity, offsets = state.polygons()
        with_mid = int(np.flatnonzero((state.cells[:, 4:] >= 0).any(axis=1))[0])
        cell = state.cells[with_mid]
        outline = [vertex for i in range(4) for vertex in (cell[i], cell[4 + i]) if vertex >= 0]
        self.assertEqual(connectivity[offsets[with_mid]:offsets[with_mid + 1]].tolist(), outline)
        self.assertEqual(offsets[-1], len(connectivity))

    def test_any_changed_byte_and_any_cut_is_refused(self):
        (good,) = golden_frames("hanging")
        chance = random.Random(1)
        for _ in range(300):
            at = chance.randrange(len(good))
            bad = good[:at] + bytes([good[at] ^ chance.randrange(1, 256)]) + good[at + 1:]
            for frame in (bad, good[:at]):
                with self.assertRaises(FrameError):
                    self.decoder().fold(frame)

    def test_damage_behind_a_right_checksum_is_refused_or_leads_to_the_same_state(self):
        chance, refused = random.Random(2), 0
        for i in range(300):
            name = ("hanging", "refined", "chaos")[i % 3]
            bad = bytearray(golden_frames(name)[0])
            bad[chance.randrange(48, len(bad))] ^= chance.randrange(1, 256)
            try:
                state = self.decoder().fold(sealed(bytes(bad)))
                self.assertEqual(state.state_sum, self.golden[name]["stateSums"][0])
            except FrameError:
                refused += 1
        self.assertGreater(refused, 250)

    def test_a_lost_frame_is_noticed_and_a_keyframe_heals(self):
        growing = golden_frames("growing")
        decoder = self.decoder()
        decoder.fold(growing[0])
        with self.assertRaises(FrameError):
            decoder.fold(growing[2])
        with self.assertRaises(FrameError):
            decoder.fold(growing[1])
        self.assertIsNotNone(decoder.fold(growing[0]))
        self.assertIsNotNone(decoder.fold(growing[1]))

    def test_frames_of_another_version_say_what_to_do(self):
        frame = bytearray(golden_frames("sheet")[0])
        frame[2] = 3
        with self.assertRaisesRegex(FrameError, "version 3, not 5.*client of the server's version"):
            self.decoder().fold(bytes(frame))

    def test_the_library_writes_only_what_there_is_room_for(self):
        decoder = self.decoder()
        library, handle = decoder._library, decoder._decoder
        room = np.full(8, -7, np.int32)
        for call in (library.wakesurf_frames_nodes, library.wakesurf_frames_cells):
            self.assertFalse(call(handle, room.ctypes.data, 0), "no state is there yet")
        state = decoder.fold(golden_frames("sheet")[0])
        for call in (library.wakesurf_frames_nodes, library.wakesurf_frames_cells):
            self.assertFalse(call(handle, room.ctypes.data, room.size))
        self.assertFalse(library.wakesurf_frames_attribute(handle, 0, room.ctypes.data, 4))
        self.assertFalse(library.wakesurf_frames_attribute(handle, len(state.attributes), room.ctypes.data, 4))
        self.assertEqual(set(room.tolist()), {-7})

    def test_without_its_library_it_says_which_one_is_missing(self):
        with self.assertRaisesRegex(OSError, "libwakesurf_frames.so.*WAKESURF_FRAMES_LIBRARY"):
            MeshDecoder("/nowhere/libwakesurf_frames.so")


if __name__ == "__main__":
    unittest.main()
