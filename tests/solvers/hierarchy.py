"""A directory of `wellspaced coarsen` in SciPy's hands: levels, matrices, an operator."""
import json
import os

import numpy
import scipy.sparse


class Hierarchy:
    def __init__(self, directory):
        self.directory = directory
        with open(os.path.join(directory, "hierarchy.json")) as file:
            self.summary = json.load(file)
        self.levels = len(self.summary["levels"])

    def file(self, level, extension):
        return os.path.join(self.directory, f"level_{level}{extension}")

    def prolongation(self, level):
        """The matrix from `level` to `level` - 1."""
        return scipy.sparse.load_npz(self.file(level, ".prolongation.npz"))

    def splitting(self, level):
        """1 for the nodes that the next level keeps (C points), 0 for all others (F points)."""
        marks = numpy.zeros(self.summary["levels"][level]["nodes"], dtype=numpy.int32)
        marks[self.summary["levels"][level]["coarse"]] = 1
        return marks

    def mesh(self):
        """Points, triangles and the boundary's node numbers of level 0."""
        points = numpy.loadtxt(self.file(0, ".node"), skiprows=1)[:, 1:3]
        base = self.summary["index_base"]
        triangles = numpy.loadtxt(self.file(0, ".ele"), skiprows=1, dtype=int)[:, 1:4] - base
        edges = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        edges, times = numpy.unique(edges, axis=0, return_counts=True)
        return points, triangles, numpy.unique(edges[times == 1])


def laplacian(points, triangles, boundary):
    """Linear elements; the rows and columns of the boundary are those of the identity."""
    sides = points[triangles[:, [2, 0, 1]]] - points[triangles[:, [1, 2, 0]]]
    double_area = sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0]
    local = numpy.einsum("tik,tjk->tij", sides, sides) / (2 * double_area)[:, None, None]
    rows = numpy.repeat(triangles, 3, axis=1).ravel()
    columns = numpy.tile(triangles, (1, 3)).ravel()
    n = len(points)
    a = scipy.sparse.csr_matrix((local.ravel(), (rows, columns)), shape=(n, n))
    free = numpy.ones(n)
    free[boundary] = 0
    keep = scipy.sparse.diags(free)
    return (keep @ a @ keep + scipy.sparse.diags(1 - free)).tocsr()
