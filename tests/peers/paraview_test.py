"""ParaView reads our files and we read its: pvpython paraview_test.py PROGRAM FOLDER."""
import json
import os
import subprocess
import sys
import unittest

from paraview import simple
from paraview.servermanager import Fetch

program, folder = sys.argv[1], sys.argv[2]
os.makedirs(folder, exist_ok=True)
os.chdir(folder)

# What ParaView writes, and how it is told to.
WRITERS = [("ascii.vtu", {"DataMode": "Ascii"}),
           ("base64.vtu", {"DataMode": "Binary"}),
           ("zlib.vtu", {"DataMode": "Binary", "CompressorType": "ZLib"}),
           ("raw.vtu", {"DataMode": "Appended", "EncodeAppendedData": 0}),
           ("raw64.vtu", {"DataMode": "Appended", "EncodeAppendedData": 1}),
           ("rawzlib.vtu", {"DataMode": "Appended", "CompressorType": "ZLib"}),
           ("ascii.vtk", {"FileType": "Ascii"}),
           ("binary.vtk", {"FileType": "Binary"})]
OURS = [("a.vtu", "vtu"), ("b.vtu", "vtu-ascii"), ("c.vtu", "vtu-raw"), ("d.vtk", "vtk"),
        ("e.vtk", "vtk-binary")]


def run(*words):
    result = subprocess.run([program, *words], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise AssertionError(f"{' '.join(words)}: {result.returncode}\n{result.stderr[-2000:]}")
    return result.stdout


def counts(path):
    """What `convert` says a file holds."""
    return json.loads(run("convert", path, "/dev/null", "--format", "vtu", "--json", "-"))


def opened(path):
    reader = simple.OpenDataFile(os.path.abspath(path))
    reader.UpdatePipeline()
    return reader


def cells_of(grid, kind):
    return sum(grid.GetCellType(i) == kind for i in range(grid.GetNumberOfCells()))


class ParaView(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        run("generate", "annulus", "--nodes", "400", "-o", "plane")
        run("generate", "box3", "--nodes", "200", "-o", "cloud.xyz")
        run("triangulate", "cloud.xyz", "-o", "space")

    def test_it_reads_what_we_write(self):
        for source, kind, key in (("plane.ele", 5, "triangles"), ("space.ele", 10, "tets")):
            expected = counts(source)
            for name, format_name in OURS:
                with self.subTest(source, format=format_name):
                    run("convert", source, name, "--format", format_name)
                    grid = Fetch(opened(name))
                    self.assertEqual(grid.GetNumberOfPoints(), expected["points"])
                    self.assertEqual(cells_of(grid, kind), expected[key])
                    self.assertEqual(cells_of(grid, 3), expected["segments"])

    def test_it_reads_our_surfaces(self):
        expected = counts("plane.ele")
        for name, cells in (("s.stl", expected["triangles"]),
                            ("s.obj", expected["triangles"] + expected["segments"])):
            run("convert", "plane.ele", name)
            self.assertEqual(Fetch(opened(name)).GetNumberOfCells(), cells)

    def test_we_read_what_it_writes(self):
        for source, key in (("plane.ele", "triangles"), ("space.ele", "tets")):
            run("convert", source, "ours.vtu")
            expected, reader = counts("ours.vtu"), opened("ours.vtu")
            for name, options in WRITERS:
                with self.subTest(source, file=name):
                    simple.SaveData(os.path.abspath(name), proxy=reader, **options)
                    found = counts(name)
                    for what in ("points", key, "segments"):
                        self.assertEqual(found[what], expected[what])
                    run("audit", name)


unittest.main(argv=sys.argv[:1])
