"""A hierarchy in PETSc's PCMG."""
from hierarchy import laplacian


def load(PETSc, path):
    return PETSc.Mat().load(PETSc.Viewer().createBinary(path, "r"))


def solve(PETSc, hierarchy):
    """Solves a Poisson equation; returns the iterations that conjugate gradients took."""
    a = laplacian(*hierarchy.mesh())
    operator = PETSc.Mat().createAIJ(a.shape, csr=(a.indptr, a.indices, a.data))
    solver = PETSc.KSP().create()
    solver.setOperators(operator)
    solver.setType("cg")
    multigrid = solver.getPC()
    multigrid.setType("mg")
    multigrid.setMGLevels(hierarchy.levels)
    for level in range(1, hierarchy.levels):
        # PETSc counts from the coarsest level.
        from_coarsest = hierarchy.summary["levels"][level - 1]["level_from_coarsest"]
        path = hierarchy.file(level, ".prolongation.petsc")
        multigrid.setMGInterpolation(from_coarsest, load(PETSc, path))
    options = PETSc.Options()
    options["pc_mg_galerkin"] = "both"
    options["mg_levels_ksp_type"] = "richardson"
    options["mg_levels_ksp_max_it"] = 1
    options["mg_levels_pc_type"] = "sor"
    solver.setTolerances(rtol=1e-8)
    solver.setFromOptions()
    x, b = operator.createVecs()
    b.set(1)
    solver.solve(b, x)
    return solver.getIterationNumber()
