"""Snapshots of the plane wave examples, read with VTK's own HDF reader, show the exact solution of the case.

usage: slices_test.py TENTPOLE SOURCE_FOLDER
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

TENTPOLE, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(SOURCE / "tests/host/output"))

import vtkhdf  # noqa: E402  ends the test as skipped without VTK
import numpy as np  # noqa: E402


def waves_2d(x, t):
    """Displacement of examples/plane_waves_2d.toml."""
    p, s = 5 * np.array([math.cos(0.5), math.sin(0.5)]), 4.5 * np.array([-math.cos(1.1), math.sin(1.1)])
    a = np.sin(x @ p - 5 * math.sqrt(3) * t + 0.3) + 0.5 * np.sin(-x @ p - 5 * math.sqrt(3) * t + 0.1)
    return np.outer(a, p / 5) + 0.8 * np.outer(np.sin(x @ s - 4.5 * t + 0.7), [-math.sin(1.1), -math.cos(1.1)])


def waves_3d(x, t):
    """Displacement of examples/plane_waves_3d.toml: P along (2, 1, 2)/3, S along (-1, 2, 2)/3."""
    p, s = np.array([2.0, 1, 2]), np.array([-1.0, 2, 2])
    return (np.outer(np.sin(x @ p - 3 * math.sqrt(3) * t + 0.3), p / 3) +
            np.outer(np.sin(x @ s - 3 * t + 0.7), [1 / 3, -1 / 6, 1 / 3]))


def check(name, dimension, exact, tolerance, settings):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "out")
        command = [TENTPOLE, "run", SOURCE / "examples" / name, "--out", out, "--quiet"]
        for setting in settings:
            command += ["--set", setting]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        files = sorted(out.glob("snapshot_*.vtkhdf"))
        assert files, f"{name}: no snapshot"
        series = json.loads((out / "snapshot.vtkhdf.series").read_text())["files"]
        times = {entry["name"]: entry["time"] for entry in series}
        for file in files:
            grid = vtkhdf.read_grid(file)
            time = times[file.name]
            wanted = exact(vtkhdf.points(grid)[:, :dimension], time)
            found = vtkhdf.point_array(grid, "displacement")[:, :dimension]
            error = np.abs(found - wanted).max() / np.abs(wanted).max()
            print(f"{name}: {file.name}, t = {time:.4g} s, {grid.GetNumberOfCells()} cells, largest error {error:.1e}")
            assert error < tolerance, f"{name}: {file.name} is off by {error:.1e} (limit {tolerance:.0e})"


check("plane_waves_2d.toml", 2, waves_2d, 5e-3, ["output.snapshots=4", 'output.fields=["displacement"]'])
check("plane_waves_3d.toml", 3, waves_3d, 3e-2, ["discretization.degree=4", "output.snapshots=2", 'output.fields=["displacement"]'])
