"""Small result folders, written without the program: a body of a few elements with fields that are known in closed form."""
import json
from pathlib import Path

import h5py
import numpy as np

SEGMENT, TRIANGLE, TETRAHEDRON, LINE = 3, 5, 10, 3
LAMBDA, MU = 1.5, 1.0
HISTORY = ("time,kinetic,strain,external_work,numerical,fracture,friction,crack_length,damage_mean,damage_max,nucleations,"
           "extensions,branches,coalescences,fragments,cells,smallest_cell\n")


def elements(dimension, sides):
    """Corners of the simplices of a box [n, dimension + 1, 3]."""
    if dimension == 1:
        x = np.linspace(0, sides[0], 5)
        return np.array([[[a, 0, 0], [b, 0, 0]] for a, b in zip(x, x[1:])])
    boxes = np.array([[i, j, 0] for i in range(3) for j in range(2)], float) / [3, 2, 1]
    size = np.array([1 / 3, 1 / 2, 1])
    unit = ([[[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[0, 0, 0], [1, 1, 0], [0, 1, 0]]] if dimension == 2 else
            [[[0, 0, 0], np.eye(3)[a], np.eye(3)[a] + np.eye(3)[b], [1, 1, 1]]
             for a, b in ((0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1))])
    return np.array([box + np.array(simplex) * size for box in boxes for simplex in unit]) * (list(sides) + [1, 1])[:3]


def fields_at(points, dimension, scale):
    """All four fields of the displacement u = scale (gradient x), and a velocity that varies."""
    gradient = np.zeros((3, 3))
    gradient[:dimension, :dimension] = np.array([[1, 2, 0], [-1, 3, 1], [4, 0, 2]])[:dimension, :dimension]
    strain = scale * 0.5 * (gradient + gradient.T)
    stress = LAMBDA * np.trace(strain) * np.eye(3) + 2 * MU * strain
    energy = 0.5 * np.sum(stress * strain)
    row = [stress[0, 0], stress[1, 1], stress[2, 2], stress[0, 1], stress[1, 2], stress[0, 2]]
    velocity = np.zeros_like(points)
    velocity[:, 0] = scale * points[:, 0]
    return {"displacement": scale * points @ gradient.T, "velocity": velocity, "stress": np.tile(row, (len(points), 1)),
            "strain_energy_density": np.full(len(points), energy)}


def write_snapshot(path, time, dimension, fields, sides, scale):
    corners = elements(dimension, sides)
    points = corners.reshape(-1, 3)
    num_corners = dimension + 1
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root["Points"] = points
        root["Connectivity"] = np.arange(len(points))
        root["Offsets"] = np.arange(0, len(points) + 1, num_corners)
        root["Types"] = np.full(len(corners), {1: SEGMENT, 2: TRIANGLE, 3: TETRAHEDRON}[dimension], np.uint8)
        root["FieldData/time"] = [time]
        root.create_group("PointData")
        for name, values in fields_at(points, dimension, scale).items():
            if name in fields:
                root[f"PointData/{name}"] = values


def write_cracks(path, time, points):
    """A chain through these points, or no crack."""
    num_lines = max(len(points) - 1, 0)
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root["Points"] = np.array(points, float).reshape(-1, 3)
        root["Connectivity"] = np.array([[i, i + 1] for i in range(num_lines)], int).ravel()
        root["Types"] = np.full(num_lines, LINE, np.uint8)
        root["FieldData/time"] = [time]
        root["PointData/damage"] = np.ones(len(points))
        root["PointData/opening"] = np.zeros(len(points))
        root["CellData/edge"] = np.zeros(num_lines, int)


def write_tables(folder, rows, scale):
    """Energies and a probe that grow from zero."""
    times = np.linspace(0, 1e-6, rows)
    lines = [",".join(map(str, [t, scale * t, scale * t, 2 * scale * t] + [0] * 11 + [4, 0.25])) for t in times]
    (folder / "history.csv").write_text(HISTORY + "".join(line + "\n" for line in lines))
    (folder / "probe_mid.csv").write_text("time,ux,vx,sxx\n" + "".join(f"{t},{scale * t},{scale},0\n" for t in times))


def write_result(folder, dimension, fields=("displacement", "velocity", "stress", "strain_energy_density"), num_snapshots=2,
                 title="a body", sides=(1, 1), scale=1.0, rows=3, cracks=None):
    """A folder as a run leaves it; scale 0: a body at rest."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    entries = []
    for number in range(num_snapshots):
        time, name = 1e-6 * (number + 1) / num_snapshots, f"snapshot_{number:04d}.vtkhdf"
        write_snapshot(folder / name, time, dimension, fields, sides, scale * (number + 1))
        if cracks is not None:
            write_cracks(folder / name.replace("snapshot", "cracks"), time, cracks)
        entries.append({"name": name, "time": time})
    if entries:
        (folder / "snapshot.vtkhdf.series").write_text(json.dumps({"file-series-version": "1.0", "files": entries}))
    if rows is not None:
        write_tables(folder, rows, scale)
    (folder / "summary.json").write_text(json.dumps({"title": title, "dimension": dimension}))
    return folder
