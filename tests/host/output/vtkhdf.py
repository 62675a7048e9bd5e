"""Reads VTKHDF unstructured grids with VTK's own reader."""
import sys

try:
    from vtkmodules.vtkIOHDF import vtkHDFReader
    from vtkmodules.util.numpy_support import vtk_to_numpy
except ImportError as error:
    print(f"skipped: {error}; install python3-vtk9")
    sys.exit(77)


def read_grid(path):
    """The vtkUnstructuredGrid in a file; an error of the reader is an exception."""
    reader = vtkHDFReader()
    if not reader.CanReadFile(str(path)):
        raise RuntimeError(f"{path}: VTK cannot read this file")
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("reader error"))
    reader.SetFileName(str(path))
    reader.Update()
    if errors:
        raise RuntimeError(f"{path}: {errors[0]}")
    return reader.GetOutput()


def point_array(grid, name):
    return vtk_to_numpy(grid.GetPointData().GetArray(name))


def cell_array(grid, name):
    return vtk_to_numpy(grid.GetCellData().GetArray(name))


def points(grid):
    return vtk_to_numpy(grid.GetPoints().GetData())
