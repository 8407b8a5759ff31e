"""wellspaced from Python: numpy arrays in and out, by ctypes alone.

Copy this file beside the shared library (libwellspaced_c.so), or name that in Library(path).

    import wellspaced
    lib = wellspaced.Library()
    mesh = lib.triangulate(points)             # (n, 2) or (n, 3) doubles
    mesh.points, mesh.cells                    # (n, d) doubles, (m, d + 1) indices from 0
    levels = lib.coarsen(mesh, beta=25)        # meshes, the finest first; .origin numbers into it
    lib.audit(levels[-1])["verdict"]           # "pass" or "fail", and what `wellspaced audit` says
    lib.write(levels[-1], "coarse.vtu")
"""
import ctypes
import json
import os
from ctypes import POINTER, byref, c_char, c_char_p, c_double, c_int, c_size_t, c_uint32, c_uint64, c_void_p

import numpy as np

HOLES = {"none": 0, "parity": 1, "seeds": 2, "outer": 3}


class Error(Exception):
    """What went wrong; .status is the number of wellspaced_status in wellspaced.h."""

    def __init__(self, status, message):
        super().__init__(message)
        self.status = status


class Mesh:
    """points (n, d), cells (m, d + 1), segments (k, 2), segment_markers (k,), origin (n,) or None."""

    def __init__(self, points, cells, segments=None, segment_markers=None, origin=None):
        self.points = np.ascontiguousarray(points, dtype=np.float64)
        self.cells = np.ascontiguousarray(cells, dtype=np.uint32)
        self.segments = _rows(segments, 2, np.uint32)
        markers = np.zeros(len(self.segments)) if segment_markers is None else segment_markers
        self.segment_markers = _markers(markers, len(self.segments))
        self.origin = origin


def _rows(values, columns, dtype):
    empty = np.zeros((0, columns))
    rows = np.ascontiguousarray(empty if values is None else values, dtype=dtype)
    if rows.ndim != 2 or rows.shape[1] != columns:
        raise ValueError(f"an array of shape (n, {columns}) is needed, not {rows.shape}")
    return rows


def _markers(values, count):
    markers = np.ascontiguousarray(values, dtype=np.int32)
    if markers.shape != (count,):
        raise ValueError(f"{count} segments have one marker each, not {markers.shape}")
    return markers


def _pointer(array, kind):
    return array.ctypes.data_as(POINTER(kind))


_SIGNATURES = {
    "version": (c_char_p, []),
    "create": (c_void_p, []),
    "destroy": (None, [c_void_p]),
    "message": (c_char_p, [c_void_p]),
    "orient2d": (c_int, [POINTER(c_double)] * 3),
    "incircle": (c_int, [POINTER(c_double)] * 4),
    "orient3d": (c_int, [POINTER(c_double)] * 4),
    "insphere": (c_int, [POINTER(c_double)] * 5),
    "triangulate2": (c_int, [c_void_p, POINTER(c_double), c_size_t, POINTER(c_uint32),
                             POINTER(c_int), c_size_t, POINTER(c_double), c_size_t, c_int]),
    "triangulate3": (c_int, [c_void_p, POINTER(c_double), c_size_t]),
    "set_mesh": (c_int, [c_void_p, POINTER(c_double), c_size_t, POINTER(c_uint32), c_size_t,
                         POINTER(c_uint32), POINTER(c_int), c_size_t]),
    "set_tet_mesh": (c_int, [c_void_p, POINTER(c_double), c_size_t, POINTER(c_uint32), c_size_t]),
    "coarsen": (c_int, [c_void_p, c_double, c_double, c_uint64]),
    "audit": (c_int, [c_void_p, POINTER(c_int)]),
    "level_count": (c_size_t, [c_void_p]),
    "select_level": (c_int, [c_void_p, c_size_t]),
    "read": (c_int, [c_void_p, c_char_p, c_char_p]),
    "write": (c_int, [c_void_p, c_char_p, c_char_p]),
    "dimension": (c_int, [c_void_p]),
    "get_points": (c_size_t, [c_void_p, POINTER(c_double), c_size_t]),
    "get_cells": (c_size_t, [c_void_p, POINTER(c_uint32), c_size_t]),
    "get_segments": (c_size_t, [c_void_p, POINTER(c_uint32), c_size_t]),
    "get_segment_markers": (c_size_t, [c_void_p, POINTER(c_int), c_size_t]),
    "get_origin": (c_size_t, [c_void_p, POINTER(c_uint32), c_size_t]),
    "get_report": (c_size_t, [c_void_p, POINTER(c_char), c_size_t]),
}


class Library:
    """The functions of the shared library. Safe to use from several threads."""

    def __init__(self, path=None):
        beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), "libwellspaced_c.so")
        self._library = ctypes.CDLL(path or beside)
        for name, (result, arguments) in _SIGNATURES.items():
            function = getattr(self._library, "wellspaced_" + name)
            function.restype, function.argtypes = result, arguments
            setattr(self, "_" + name, function)

    def version(self):
        return self._version().decode()

    def orient2d(self, a, b, c):
        return self._sign(self._orient2d, 2, a, b, c)

    def incircle(self, a, b, c, d):
        return self._sign(self._incircle, 2, a, b, c, d)

    def orient3d(self, a, b, c, d):
        return self._sign(self._orient3d, 3, a, b, c, d)

    def insphere(self, a, b, c, d, e):
        return self._sign(self._insphere, 3, a, b, c, d, e)

    def triangulate(self, points, segments=None, segment_markers=None, hole_points=None,
                    holes="none"):
        """(Constrained) Delaunay triangulation in the plane, Delaunay in space."""
        points = np.ascontiguousarray(points, dtype=np.float64)
        if points.ndim != 2 or points.shape[1] not in (2, 3):
            raise ValueError(f"points must have the shape (n, 2) or (n, 3), not {points.shape}")
        with _Context(self) as context:
            if points.shape[1] == 3:
                context.call(self._triangulate3, _pointer(points, c_double), len(points))
                return context.mesh()
            mesh = Mesh(points, np.zeros((0, 3)), segments, segment_markers)
            seeds = _rows(hole_points, 2, np.float64)
            context.call(self._triangulate2, _pointer(points, c_double), len(points),
                         _pointer(mesh.segments, c_uint32), _pointer(mesh.segment_markers, c_int),
                         len(mesh.segments), _pointer(seeds, c_double), len(seeds), HOLES[holes])
            return context.mesh()

    def coarsen(self, mesh, beta=0.0, factor=0.0, seed=1):
        """The levels of a coarsening sequence, mesh itself first."""
        with _Context(self) as context:
            context.set_mesh(mesh)
            context.call(self._coarsen, beta, factor, seed)
            levels = []
            for level in range(self._level_count(context.handle)):
                context.call(self._select_level, level)
                levels.append(context.mesh())
            return levels

    def audit(self, mesh):
        """What `wellspaced audit --json` says of a mesh of triangles or tetrahedra, as a dict."""
        with _Context(self) as context:
            context.set_mesh(mesh)
            context.call(self._audit, byref(c_int()))
            report = ctypes.create_string_buffer(self._get_report(context.handle, None, 0))
            self._get_report(context.handle, report, len(report))
            return json.loads(report.value)

    def read(self, path, format=None):
        with _Context(self) as context:
            context.call(self._read, os.fsencode(path), format and format.encode())
            return context.mesh()

    def write(self, mesh, path, format=None):
        """Writes a mesh of triangles or tetrahedra."""
        with _Context(self) as context:
            context.set_mesh(mesh)
            context.call(self._write, os.fsencode(path), format and format.encode())

    def _sign(self, function, dimension, *points):
        arrays = [np.ascontiguousarray(p, dtype=np.float64).reshape(dimension) for p in points]
        return function(*(_pointer(a, c_double) for a in arrays))


class _Context:
    """One wellspaced_context, for the time of one operation."""

    def __init__(self, library):
        self._library = library

    def __enter__(self):
        self.handle = self._library._create()
        if not self.handle:
            raise MemoryError
        return self

    def __exit__(self, *_):
        self._library._destroy(self.handle)

    def call(self, function, *arguments):
        status = function(self.handle, *arguments)
        if status != 0:
            raise Error(status, self._library._message(self.handle).decode(errors="replace"))

    def set_mesh(self, mesh):
        if mesh.points.ndim == 2 and mesh.points.shape[1] == 3:
            points, cells = _rows(mesh.points, 3, np.float64), _rows(mesh.cells, 4, np.uint32)
            self.call(self._library._set_tet_mesh, _pointer(points, c_double), len(points),
                      _pointer(cells, c_uint32), len(cells))
            return
        points, cells = _rows(mesh.points, 2, np.float64), _rows(mesh.cells, 3, np.uint32)
        segments = _rows(mesh.segments, 2, np.uint32)
        markers = _markers(mesh.segment_markers, len(segments))
        self.call(self._library._set_mesh, _pointer(points, c_double), len(points),
                  _pointer(cells, c_uint32), len(cells), _pointer(segments, c_uint32),
                  _pointer(markers, c_int), len(segments))

    def mesh(self):
        dimension = self._library._dimension(self.handle)
        origin = self._get(self._library._get_origin, np.uint32, c_uint32)
        return Mesh(self._get(self._library._get_points, np.float64, c_double).reshape(-1, dimension),
                    self._get(self._library._get_cells, np.uint32, c_uint32).reshape(-1, dimension + 1),
                    self._get(self._library._get_segments, np.uint32, c_uint32).reshape(-1, 2),
                    self._get(self._library._get_segment_markers, np.int32, c_int),
                    origin if len(origin) else None)

    def _get(self, function, dtype, kind):
        size = function(self.handle, None, 0)
        values = np.empty(size, dtype=dtype)
        function(self.handle, _pointer(values, kind), size)
        return values
