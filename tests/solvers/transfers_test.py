"""transfers_test.py PACKAGE PROGRAM: what a package makes of the files that PROGRAM writes.

Exits with 77 where the package is missing."""
import subprocess
import sys
import tempfile

SKIPPED = 77


def compare(hierarchy, level, rows, columns, data):
    """Checks a matrix in CSR against the one in the npz file: equal entries, to the bit."""
    expected = hierarchy.prolongation(level)
    assert (rows == expected.indptr).all(), level
    assert (columns == expected.indices).all(), level
    assert (data == expected.data).all(), level


def test_scipy(hierarchy):
    import numpy
    import scipy.io
    for level in range(1, hierarchy.levels):
        p = hierarchy.prolongation(level)
        assert p.shape[0] == hierarchy.summary["levels"][level - 1]["nodes"]
        assert p.shape[1] == hierarchy.summary["levels"][level]["nodes"]
        text = scipy.io.mmread(hierarchy.file(level, ".prolongation.mtx")).tocsr()
        text.sort_indices()
        compare(hierarchy, level, text.indptr, text.indices, text.data)
        assert abs(p.sum(axis=1) - 1).max() <= 2.0**-52 and p.data.min() > 0
        kept = numpy.flatnonzero(hierarchy.splitting(level - 1))
        assert (p[kept] != __import__("scipy.sparse").sparse.identity(len(kept))).nnz == 0


def test_petsc4py(hierarchy):
    import multigrid_petsc
    from petsc4py import PETSc
    for level in range(1, hierarchy.levels):
        matrix = multigrid_petsc.load(PETSc, hierarchy.file(level, ".prolongation.petsc"))
        compare(hierarchy, level, *matrix.getValuesCSR())
    iterations = multigrid_petsc.solve(PETSc, hierarchy)
    print("PETSc: conjugate gradients with PCMG:", iterations, "iterations")
    assert iterations <= 12


def test_pyamg(hierarchy):
    import multigrid_pyamg
    residuals = multigrid_pyamg.solve(hierarchy)
    print("PyAMG: conjugate gradients:", len(residuals) - 1, "iterations")
    assert len(residuals) <= 13 and residuals[-1] < 1e-7 * residuals[0]


def main(package, program):
    for name in ("scipy", package):
        try:
            __import__(name)
        except ImportError:
            print(f"{name} is not installed: skipped")
            return SKIPPED
    from hierarchy import Hierarchy
    with tempfile.TemporaryDirectory() as folder:
        run = lambda *words: subprocess.run([program, *words, "--quiet"], check=True, cwd=folder)
        run("generate", "airfoil", "--nodes", "20000", "-o", "wing")
        run("coarsen", "wing", "--transfers", "npz,mtx,petsc", "-o", "levels")
        globals()["test_" + package](Hierarchy(folder + "/levels"))
    return 0


sys.exit(main(*sys.argv[1:]))
