"""Files of other programs are read, and ours by them: formats_test.py PROGRAM FOLDER.

meshio, gmsh and TetGen are used where they are installed; exit code 77: none of them is. With
WELLSPACED_REQUIRE_PEERS in the environment all of them must be.
"""
import os
import shutil
import subprocess
import sys
import unittest

try:
    import meshio
    import numpy as np
except ImportError:
    meshio = None

program, folder = sys.argv[1], sys.argv[2]
gmsh, tetgen = shutil.which("gmsh"), shutil.which("tetgen")
if meshio is None and gmsh is None and tetgen is None:
    print("skipped: neither meshio nor gmsh nor tetgen is installed")
    sys.exit(77)
if "WELLSPACED_REQUIRE_PEERS" in os.environ and None in (meshio, gmsh, tetgen):
    sys.exit("apt install python3-meshio gmsh tetgen")
os.makedirs(folder, exist_ok=True)
os.chdir(folder)

SQUARE = """\
Point(1) = {0, 0, 0, 0.2}; Point(2) = {1, 0, 0, 0.2}; Point(3) = {1, 1, 0, 0.2};
Point(4) = {0, 1, 0, 0.2};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Curve("wall", 7) = {1, 2, 3}; Physical Curve("inflow", 8) = {4};
Physical Surface("fluid", 9) = {1};
"""
CUBE = """\
SetFactory("OpenCASCADE"); Box(1) = {0, 0, 0, 1, 1, 1}; Mesh.MeshSizeMax = 0.4;
Physical Volume("solid", 5) = {1}; Physical Surface("skin", 6) = {1, 2, 3, 4, 5, 6};
"""


def run(*words):
    result = subprocess.run(words, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise AssertionError(f"{' '.join(words)}: {result.returncode}\n{result.stdout[-500:]}"
                             f"{result.stderr[-2000:]}")
    return result.stdout


def convert(source, target, *options):
    run(program, "convert", source, target, *options)


def rows(path):
    """The fields of each line of a file of ours, without the header."""
    with open(path) as file:
        lines = [line.split() for line in file]
    return lines[1:]


def counts(path):
    """What `convert` says a file holds."""
    import json
    text = run(program, "convert", path, "/dev/null", "--format", "vtu", "--json", "-")
    return json.loads(text)


@unittest.skipUnless(meshio, "meshio is not installed")
class Meshio(unittest.TestCase):
    def setUp(self):
        run(program, "generate", "grid", "--nx", "5", "--ny", "4", "-o", "grid")
        self.points = np.array([[float(x) for x in row[1:3]] for row in rows("grid.node")])
        self.cells = np.array([[int(x) for x in row[1:4]] for row in rows("grid.ele")])
        self.cells -= int(rows("grid.node")[0][0])

    def test_it_reads_what_we_write(self):
        for name, options in (("m41.msh", []), ("m22.msh", ["--format", "gmsh22"]),
                              ("m41b.msh", ["--format", "gmsh-binary"]),
                              ("m22b.msh", ["--format", "gmsh22-binary"]), ("m.vtu", []),
                              ("ma.vtu", ["--format", "vtu-ascii"]),
                              ("mr.vtu", ["--format", "vtu-raw"]), ("m.vtk", []),
                              ("mb.vtk", ["--format", "vtk-binary"]), ("m.mesh", []),
                              ("m.su2", []), ("m.off", []), ("m.obj", []), ("m.stl", []),
                              ("mb.stl", ["--format", "stl-binary"])):
            with self.subTest(name):
                convert("grid.ele", name, *options)
                mesh = meshio.read(name)
                triangles = mesh.cells_dict["triangle"]
                self.assertEqual(len(triangles), len(self.cells))
                corners = mesh.points[triangles][:, :, :2]
                self.assertTrue((corners == self.points[self.cells]).all())

    def test_we_read_what_it_writes(self):
        mesh = meshio.Mesh(np.column_stack([self.points, np.zeros(len(self.points))]),
                           [("triangle", self.cells)])
        for name, options in (("p22.msh", {"file_format": "gmsh22", "binary": False}),
                              ("p22b.msh", {"file_format": "gmsh22", "binary": True}),
                              ("p41.msh", {"file_format": "gmsh", "binary": False}),
                              ("p41b.msh", {"file_format": "gmsh", "binary": True}),
                              ("p.vtu", {}), ("pa.vtu", {"binary": False}),
                              ("pu.vtu", {"compression": None}), ("p.vtk", {}),
                              ("pa.vtk", {"binary": False}), ("p42.vtk", {"file_format": "vtk42"}),
                              ("p.mesh", {}), ("p.off", {}), ("p.obj", {}),
                              ("p.stl", {}), ("pb.stl", {"binary": True})):
            with self.subTest(name):
                meshio.write(name, mesh, **options)
                convert(name, "back.node")
                points = np.array([[float(x) for x in row[1:3]] for row in rows("back.node")])
                cells = np.array([[int(x) for x in row[1:4]] for row in rows("back.ele")])
                cells -= int(rows("back.node")[0][0])
                self.assertEqual(len(cells), len(self.cells))
                difference = np.abs(points[cells] - self.points[self.cells]).max()
                self.assertLess(difference, 1e-6)


@unittest.skipUnless(gmsh, "gmsh is not installed")
class Gmsh(unittest.TestCase):
    def mesh(self, text, dimension, name, *options):
        with open("shape.geo", "w") as file:
            file.write(text)
        run(gmsh, "shape.geo", f"-{dimension}", "-o", name, "-v", "2", *options)
        return counts(name)

    def test_we_read_every_version_of_a_square(self):
        for version in ("msh22", "msh41", "su2", "mesh", "vtk"):
            for binary in ([], ["-bin"]) if version.startswith("msh") else ([],):
                with self.subTest(version, binary=binary):
                    name = "g." + ("msh" if version.startswith("msh") else version)
                    found = self.mesh(SQUARE, 2, name, "-format", version, *binary)
                    self.assertGreater(found["triangles"], 20)
                    self.assertGreaterEqual(found["segments"], 20)
                    run(program, "audit", name)

    def test_we_read_a_cube_with_its_markers(self):
        for binary in ([], ["-bin"]):
            found = self.mesh(CUBE, 3, "c.msh", "-format", "msh41", *binary)
            self.assertGreater(found["tets"], 50)
            convert("c.msh", "c.node")
            self.assertEqual({row[-1] for row in rows("c.face")}, {"6"})
            self.assertEqual({row[-1] for row in rows("c.ele")}, {"5"})

    def test_it_reads_what_we_write(self):
        before = self.mesh(SQUARE, 2, "g.msh", "-format", "msh41")
        for format_name in ("gmsh", "gmsh22", "gmsh-binary", "gmsh22-binary"):
            with self.subTest(format_name):
                convert("g.msh", "ours.msh", "--format", format_name)
                run(gmsh, "ours.msh", "-0", "-o", "theirs.msh", "-format", "msh22", "-v", "2")
                after = counts("theirs.msh")
                for key in ("points", "triangles", "segments"):
                    self.assertEqual(after[key], before[key])


@unittest.skipUnless(tetgen, "tetgen is not installed")
class TetGen(unittest.TestCase):
    def test_it_meshes_our_domains_and_we_read_its_meshes(self):
        with open("cube.off", "w") as file:
            file.write("OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                       "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")
        for name in ("box.poly", "box.smesh"):
            with self.subTest(name):
                convert("cube.off", name)
                run(tetgen, "-pqa0.05", name)
                found = counts("box.1.ele")
                self.assertGreater(found["tets"], 20)
                run(program, "audit", "box.1.ele")
                convert("box.1.ele", "again.node")
                self.assertGreaterEqual(len(rows("again.face")), 12)


unittest.main(argv=sys.argv[:1])
