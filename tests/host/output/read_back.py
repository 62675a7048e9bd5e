"""read_back.py WRITER SOURCE: what VTK reads from a result is what was written.

Snapshots of a quadratic field hold that field and fill the domain; the files of a made-up crack hold its damage and opening.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

from vtkhdf import cell_array, point_array, points, read_grid

LAMBDA, MU, DENSITY = 1.0e11, 1.07e11, 3690.0


def exact_fields(dimension, position, time):
    """quadratic_field() of sample_fields.hpp: displacement, velocity, gradient at positions [n, 3] and a time."""
    x, y, z = (position / 1e-3).T
    t = time / 1e-7
    zero = np.zeros_like(x)
    one = zero + 1
    displacement = 1e-9 * np.stack([1 + x * y + t * t, x * x - 2 * y * t, z * x + y * y], axis=1)
    velocity = 1e-2 * np.stack([2 * t * one, -2 * y, zero], axis=1)
    gradient = 1e-6 * np.stack([np.stack([y, x, zero], 1), np.stack([2 * x, -2 * t * one, zero], 1),
                                np.stack([z, 2 * y, x], 1)], axis=1)
    displacement[:, dimension:] = velocity[:, dimension:] = 0
    gradient[:, dimension:, :] = gradient[:, :, dimension:] = 0
    return displacement, velocity, gradient


def exact_stress(gradient):
    strain = 0.5 * (gradient + gradient.transpose(0, 2, 1))
    trace = np.trace(strain, axis1=1, axis2=2)
    stress = 2 * MU * strain + LAMBDA * trace[:, None, None] * np.eye(3)
    energy = 0.5 * np.einsum("nij,nij->n", stress, strain)
    return stress, energy


def check_close(name, value, expected, scale):
    error = np.max(np.abs(value - expected)) / scale
    # Rounding of derivatives grows with the flatness of the sliver tents that random pitching makes.
    assert error < 1e-9, f"{name}: relative error {error}"


def check_snapshot(path, dimension, time):
    grid = read_grid(path)
    field_time = grid.GetFieldData().GetArray("time").GetValue(0)
    assert field_time == time, f"field data time {field_time} is not {time}"
    displacement, velocity, gradient = exact_fields(dimension, points(grid), time)
    stress, energy = exact_stress(gradient)
    check_close("displacement", point_array(grid, "displacement"), displacement, 1e-9)
    check_close("velocity", point_array(grid, "velocity"), velocity, 1e-2)
    components = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)]
    for index, (i, j) in enumerate(components):
        check_close(f"stress {i}{j}", point_array(grid, "stress")[:, index], stress[:, i, j], 1e5)
    check_close("strain_energy_density", point_array(grid, "strain_energy_density"), energy, 0.1)
    assert grid.GetPointData().GetArray("damage") is None and np.all(cell_array(grid, "damage") == 0)
    element = cell_array(grid, "element")
    assert np.all(np.diff(element) >= 0) and element[0] == 0
    assert set(cell_array(grid, "region")) == {1, 2}
    check_measure(grid, dimension)


def check_measure(grid, dimension):
    """VTK finds every cell positive and their sum equal to the domain."""
    sizes = vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    size = cell_array(sizes.GetOutput(), {1: "Length", 2: "Area", 3: "Volume"}[dimension])
    assert np.all(size > 0), "cells of negative size"
    # Faces between the parts of a wedge are warped, so VTK's volumes of these parts are not exact.
    tolerance = 1e-3 if dimension == 3 else 1e-11
    assert abs(size.sum() / 1e-3**dimension - 1) < tolerance, size.sum() / 1e-3**dimension


def check_tables(folder, dimension):
    probe = np.genfromtxt(folder / "probe_middle.csv", delimiter=",", names=True)
    assert probe["time"][0] == 0 and probe["time"][-1] == 1e-7
    middle = np.array([[5e-4] * dimension + [0.0] * (3 - dimension)])
    for row in probe:
        displacement, velocity, gradient = exact_fields(dimension, middle, row["time"])
        stress, _ = exact_stress(gradient)
        for i, axis in enumerate("xyz"[:dimension]):
            check_close("probe u" + axis, row["u" + axis], displacement[0, i], 1e-9)
            check_close("probe v" + axis, row["v" + axis], velocity[0, i], 1e-2)
        check_close("probe sxx", row["sxx"], stress[0, 0, 0], 1e5)
        if dimension > 1:
            check_close("probe sxy", row["sxy"], stress[0, 0, 1], 1e5)
    history = np.genfromtxt(folder / "history.csv", delimiter=",", names=True)
    assert history.dtype.names[:7] == ("time", "kinetic", "strain", "external_work", "numerical", "fracture", "friction")
    assert len(history) == 51
    if dimension == 1:  # v = 1e-2 * 2 t on a bar of 1 mm
        kinetic = 0.5 * DENSITY * (2e-2 * history["time"] / 1e-7) ** 2 * 1e-3
        check_close("kinetic energy", history["kinetic"], kinetic, kinetic[-1])


def check_crack_file(path, dimension, degree, time):
    """The crack of sample_crack.hpp at one time; returns its total length (D = 1: number of vertices)."""
    grid = read_grid(path)
    assert grid.GetFieldData().GetArray("time").GetValue(0) == time
    if grid.GetNumberOfCells() == 0:
        assert time < 6.1e-8, "no crack after it began"
        return 0
    assert time > 6e-8, "a crack before it began"
    position, damage, opening = points(grid), point_array(grid, "damage"), point_array(grid, "opening")
    edge, mode = cell_array(grid, "edge"), cell_array(grid, "mode")
    assert np.all(mode == 0)
    kinds = {grid.GetCellType(cell) for cell in range(grid.GetNumberOfCells())}
    assert kinds == {1 if dimension == 1 else 3}, kinds
    per_edge = 1 if dimension == 1 else degree + 2  # lines between degree + 1 Gauss points and two ends
    assert np.array_equal(edge, np.repeat(np.arange(len(edge) // per_edge), per_edge))
    distance = np.hypot(position[:, 1] - 1e-4, 4e-5) - 4e-5 if dimension == 2 else 0
    age = time - 6e-8 - distance / 1.2e4
    expected = 1 - np.exp(-np.maximum(age, 0) / 3e-9)
    inner = np.ones(len(position), bool)
    if dimension == 2:  # the ends of a chain repeat the value of the Gauss point beside them
        chains = np.arange(len(position)).reshape(-1, degree + 3)
        inner[chains[:, [0, -1]]] = False
        for values in (damage, opening):
            assert np.array_equal(values[chains[:, 0]], values[chains[:, 1]])
            assert np.array_equal(values[chains[:, -1]], values[chains[:, -2]])
    assert np.max(np.abs(damage - expected)[inner]) < 1e-9
    assert np.all((opening > 0) == (damage > 0)) and opening.max() < 2e-6
    if dimension == 1:
        return len(position)
    ends = [grid.GetCell(cell).GetBounds() for cell in range(grid.GetNumberOfCells())]
    return sum(np.hypot(b[1] - b[0], b[3] - b[2]) for b in ends)


def check_cracks(folder, dimension, degree):
    series = json.loads((folder / "cracks.vtkhdf.series").read_text())["files"]
    snapshots = json.loads((folder / "snapshot.vtkhdf.series").read_text())["files"]
    assert [entry["time"] for entry in series] == [entry["time"] for entry in snapshots]
    sizes = [check_crack_file(folder / entry["name"], dimension, degree, entry["time"]) for entry in series]
    assert sizes[0] == 0 and np.all(np.diff(sizes) >= 0)
    # The path between the regions runs along mesh edges over the width of 0.2 mm.
    assert sizes[-1] == 1 if dimension == 1 else 2e-4 <= sizes[-1] < 4e-4, sizes
    damage = cell_array(read_grid(folder / snapshots[-1]["name"]), "damage")
    assert damage.min() == 0 and 0.999 < damage.max() < 1
    history = np.genfromtxt(folder / "history.csv", delimiter=",", names=True)
    assert history["damage_max"][0] == 0 and history["damage_max"][-1] > 0.999 and history["fragments"][-1] == 2
    assert history["fracture"][-1] > 0


def main():
    writer = sys.argv[1]
    for dimension, degree in ((1, 2), (2, 3), (3, 2), (3, 3)):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            subprocess.run([writer, name, str(dimension), str(degree), "quadratic", "5"], check=True)
            series = json.loads((folder / "snapshot.vtkhdf.series").read_text())
            assert series["file-series-version"] == "1.0" and len(series["files"]) == 6
            for index, entry in enumerate(series["files"]):
                assert abs(entry["time"] - index * 2e-8) < 1e-20
                check_snapshot(folder / entry["name"], dimension, entry["time"])
            check_tables(folder, dimension)
            assert not list(folder.glob(".*")), "partial files are left"
    for dimension, degree in ((1, 2), (2, 2)):
        with tempfile.TemporaryDirectory() as name:
            subprocess.run([writer, name, str(dimension), str(degree), "crack", "5"], check=True)
            check_cracks(Path(name), dimension, degree)


if __name__ == "__main__":
    main()
