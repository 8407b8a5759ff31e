"""The ctypes file: python_test.py WELLSPACED.PY LIBRARY FOLDER. Exit code 77: numpy is missing."""
import importlib.util
import os
import sys
import threading
import unittest

try:
    import numpy as np
except ImportError:
    print("skipped: numpy is missing")
    sys.exit(77)

spec = importlib.util.spec_from_file_location("wellspaced", sys.argv[1])
wellspaced = importlib.util.module_from_spec(spec)
spec.loader.exec_module(wellspaced)
lib = wellspaced.Library(sys.argv[2])
folder = sys.argv[3]


def grid(n):
    x, y = np.meshgrid(np.arange(n), np.arange(n))
    return np.column_stack([x.ravel(), y.ravel()]).astype(float)


def areas(mesh):
    a, b, c = (mesh.points[mesh.cells[:, k]] for k in range(3))
    return ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2


class Test(unittest.TestCase):
    def test_predicates_are_exact(self):
        self.assertEqual(lib.orient2d([0, 0], [1, 0], [0.5, 5e-324]), 1)
        self.assertEqual(lib.incircle([0, 0], [1, 0], [1, 1], [0, 1]), 0)
        self.assertEqual(lib.orient3d([0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, -1]), 1)

    def test_triangulation_covers_the_hull(self):
        mesh = lib.triangulate(grid(9))
        self.assertEqual(mesh.cells.shape, (128, 3))
        self.assertEqual(areas(mesh).sum(), 64)
        self.assertTrue((areas(mesh) > 0).all())

    def test_constraints_and_holes(self):
        outer, inner = grid(2) * 3, grid(2) + 1
        ring = np.array([[0, 1], [1, 3], [3, 2], [2, 0]])
        mesh = lib.triangulate(np.vstack([outer, inner]), np.vstack([ring, ring + 4]),
                               segment_markers=[1] * 4 + [7] * 4, holes="parity")
        self.assertEqual(areas(mesh).sum(), 8)
        self.assertEqual(sorted(mesh.segment_markers), [1] * 4 + [7] * 4)

    def test_space(self):
        points = np.random.default_rng(1).random((100, 3))
        mesh = lib.triangulate(points)
        self.assertEqual(mesh.cells.shape[1], 4)
        self.assertTrue((mesh.points == points).all())

    def test_levels_are_subsets_of_the_input(self):
        fine = lib.triangulate(grid(30))
        levels = lib.coarsen(fine)
        self.assertGreater(len(levels), 1)
        for level in levels:
            self.assertTrue((fine.points[level.origin] == level.points).all())
            self.assertAlmostEqual(areas(level).sum(), 29 * 29)

    def test_files(self):
        mesh = lib.triangulate(grid(5))
        path = os.path.join(folder, "python.vtu")
        lib.write(mesh, path)
        back = lib.read(path)
        self.assertTrue((back.points == mesh.points).all())
        self.assertTrue((back.cells == mesh.cells).all())

    def test_audits_tell_the_verdict_and_the_offenders(self):
        good = lib.triangulate(grid(5))
        self.assertEqual(lib.audit(good)["verdict"], "pass")
        corners = [[0, 0], [1, 0], [0, 1], [.1, .1], [1, .1], [.1, 1]]
        report = lib.audit(wellspaced.Mesh(corners, [[0, 1, 2], [3, 4, 5]]))
        self.assertEqual(report["verdict"], "fail")
        failed = {check["name"] for check in report["checks"] if not check["pass"]}
        self.assertEqual(failed, {"no_overlap"})

    def test_meshes_in_space_are_audited_and_written(self):
        mesh = lib.triangulate(np.random.default_rng(2).random((50, 3)))
        self.assertEqual(lib.audit(mesh)["verdict"], "pass")
        path = os.path.join(folder, "python_space.vtu")
        lib.write(mesh, path)
        self.assertEqual(len(lib.read(path).cells), len(mesh.cells))
        with self.assertRaisesRegex(wellspaced.Error, "tetrahedron 0 has a corner"):
            lib.audit(wellspaced.Mesh(mesh.points[:4], [[0, 1, 2, 4]]))

    def test_errors_are_exceptions_with_a_message(self):
        with self.assertRaisesRegex(wellspaced.Error, "point 0 is not finite"):
            lib.triangulate([[np.nan, 0]])
        with self.assertRaises(wellspaced.Error) as caught:
            lib.read("/does/not/exist.msh")
        self.assertEqual(caught.exception.status, 3)
        with self.assertRaises(ValueError):
            lib.triangulate([1.0, 2.0])

    def test_arrays_that_do_not_fit_together_are_refused(self):
        square = [[0, 0], [1, 0], [1, 1], [0, 1]]
        with self.assertRaisesRegex(ValueError, "one marker each"):
            lib.triangulate(square, segments=[[0, 1], [1, 2]], segment_markers=[7])
        mesh = lib.triangulate(square)
        mesh.segments = [[0, 1], [1, 2]]  # beside the markers that it had
        with self.assertRaisesRegex(ValueError, "one marker each"):
            lib.audit(mesh)

    def test_segments_set_later_are_taken_as_they_are(self):
        mesh = lib.triangulate([[0, 0], [1, 0], [1, 1], [0, 1]])
        mesh.segments = np.array([[0, 1], [1, 2]], dtype=np.int64)
        mesh.segment_markers = [3, 4]
        path = os.path.join(folder, "python_segments.msh")
        lib.write(mesh, path)
        back = lib.read(path)
        marked = {tuple(sorted(s)): m for s, m in zip(back.segments.tolist(), back.segment_markers)}
        self.assertEqual((marked[0, 1], marked[1, 2]), (3, 4))

    def test_messages_are_one_line_whatever_the_path(self):
        with self.assertRaises(wellspaced.Error) as caught:
            lib.read(os.fsdecode(b"/no\nfile\xff.msh"))
        self.assertNotIn("\n", str(caught.exception))

    def test_threads_do_not_disturb_each_other(self):
        results = [None] * 4
        def work(i):
            results[i] = lib.triangulate(np.random.default_rng(i).random((2000, 2)))
        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for i, mesh in enumerate(results):
            again = lib.triangulate(np.random.default_rng(i).random((2000, 2)))
            self.assertTrue((mesh.cells == again.cells).all())


unittest.main(argv=sys.argv[:1])
