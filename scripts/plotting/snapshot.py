"""Reads snapshots: slices t = const of the spacetime elements with fields at discontinuous points."""
import json
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

from .cracks import Cracks, crack_file, read_cracks
from .text import PlotError, note, printable

SEGMENT, TRIANGLE, QUAD, TETRAHEDRON, WEDGE = 3, 5, 9, 10, 13
# Edges, faces and simplices of the cell types, as corner numbers.
EDGES = {SEGMENT: [(0, 1)], TRIANGLE: [(0, 1), (1, 2), (2, 0)], QUAD: [(0, 1), (1, 2), (2, 3), (3, 0)]}
FACES = {TETRAHEDRON: [(0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)],
         WEDGE: [(0, 1, 2), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)]}
SIMPLICES = {SEGMENT: [(0, 1)], TRIANGLE: [(0, 1, 2)], QUAD: [(0, 1, 2), (0, 2, 3)], TETRAHEDRON: [(0, 1, 2, 3)],
             WEDGE: [(0, 2, 1, 4), (0, 2, 4, 5), (0, 5, 4, 3)]}
NUM_CORNERS = {SEGMENT: 2, TRIANGLE: 3, QUAD: 4, TETRAHEDRON: 4, WEDGE: 6}


@dataclass
class Snapshot:
    name: str
    time: float                 # [s]
    points: np.ndarray          # [num_points, 3] [m]
    cells: dict                 # cell type -> corners [n, num_corners]
    fields: dict                # name -> [num_points] or [num_points, components], SI
    cracks: Cracks = None       # fracture edges at the same time; None for runs without fracture

    @property
    def dimension(self):
        if SEGMENT in self.cells:
            return 1
        return 2 if TRIANGLE in self.cells or QUAD in self.cells else 3

    def simplices(self):
        """All cells cut into simplices [n, dimension + 1]."""
        parts = [corners[:, list(simplex)] for kind, corners in self.cells.items() for simplex in SIMPLICES[kind]]
        return np.concatenate(parts)

    def speed(self):
        return np.linalg.norm(self.fields["velocity"], axis=1)


def finite(name, field, values):
    """The values, with 0 for those that are not finite."""
    good = np.isfinite(values)
    if good.all():
        return values
    num_bad = np.size(good) - np.count_nonzero(good)
    note(f"{printable(name)}: {num_bad} values of {printable(field)} are not finite and drawn as 0")
    return np.where(good, values, 0)


def read_cells(root, num_points):
    """Cell type -> corners [n, num_corners]."""
    types, offsets, connectivity = root["Types"][:], root["Offsets"][:], root["Connectivity"][:]
    if len(connectivity) and not (connectivity.min() >= 0 and connectivity.max() < num_points):
        raise ValueError("a cell has a corner that is no point")
    cells = {}
    for kind in np.unique(types):
        first = offsets[:-1][types == kind]
        cells[int(kind)] = connectivity[first[:, None] + np.arange(NUM_CORNERS[int(kind)])]
    if not cells:
        raise ValueError("there are no cells")
    return cells


def read_snapshot(path):
    path = Path(path)
    try:
        with h5py.File(path, "r") as file:
            root = file["VTKHDF"]
            points = root["Points"][:]
            fields = {name: finite(path.name, name, array[:]) for name, array in root["PointData"].items()}
            snapshot = Snapshot(path.stem, float(root["FieldData/time"][0]), points, read_cells(root, len(points)), fields)
            if any(len(values) != len(points) for values in fields.values()):
                raise ValueError("a field has not one value for each point")
    except (OSError, KeyError, ValueError, IndexError, RuntimeError) as error:
        raise PlotError(f"{printable(path)}: cannot be read as a snapshot ({printable(error)}); the file is missing, damaged or "
                        "of another program") from error
    companion = crack_file(path)
    if companion.exists():
        snapshot.cracks = read_cracks(companion)
    return snapshot


def series(folder):
    """Files and times of the snapshots, in time order."""
    path = Path(folder) / "snapshot.vtkhdf.series"
    if not path.exists():
        return []
    try:
        return [(Path(folder) / entry["name"], float(entry["time"])) for entry in json.loads(path.read_text())["files"]]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise PlotError(f"{printable(path)}: cannot be read as a list of snapshots ({printable(error)})") from error


def element_edges(cells):
    """Point pairs [n, 2] on the border of an element's slice: inside it an edge belongs to two cells, on the border to one."""
    edges = np.concatenate([corners[:, list(edge)] for kind, corners in cells.items() for edge in EDGES[kind]])
    pairs, count = np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)
    return pairs[count == 1]


def smooth_small_jumps(points, values, threshold):
    """Values with the mean at points of equal position, where these differ by less than the threshold.

    Closes the hairline gaps of a relief between elements; the jump over an open crack stays.
    """
    size = np.ptp(points, axis=0).max()
    _, group = np.unique(np.round(points / size * 1e7), axis=0, return_inverse=True)
    group = group.ravel()
    mean = np.bincount(group, values) / np.bincount(group)
    largest, smallest = np.full(len(mean), -np.inf), np.full(len(mean), np.inf)
    np.maximum.at(largest, group, values)
    np.minimum.at(smallest, group, values)
    return np.where((largest - smallest)[group] < threshold, mean[group], values)
