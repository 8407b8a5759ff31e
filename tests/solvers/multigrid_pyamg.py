"""A hierarchy in PyAMG's MultilevelSolver."""
import numpy
from hierarchy import laplacian
from pyamg.multilevel import MultilevelSolver
from pyamg.relaxation.smoothing import change_smoothers


def solve(hierarchy):
    """Solves a Poisson equation; returns the residuals of conjugate gradients."""
    levels = [MultilevelSolver.Level() for _ in range(hierarchy.levels)]
    levels[0].A = laplacian(*hierarchy.mesh())
    for level in range(1, hierarchy.levels):
        fine, coarse = levels[level - 1], levels[level]
        fine.P = hierarchy.prolongation(level)
        fine.R = fine.P.T.tocsr()
        fine.splitting = hierarchy.splitting(level - 1)
        coarse.A = (fine.R @ fine.A @ fine.P).tocsr()
    solver = MultilevelSolver(levels, coarse_solver="splu")
    smoother = ("gauss_seidel", {"sweep": "symmetric"})
    change_smoothers(solver, presmoother=smoother, postsmoother=smoother)
    residuals = []
    solver.solve(numpy.ones(levels[0].A.shape[0]), tol=1e-8, accel="cg", residuals=residuals)
    return residuals
