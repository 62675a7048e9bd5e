"""Reads cracks_NNNN.vtkhdf: the fracture edges at the file's time with damage and opening along them."""
from dataclasses import dataclass

import h5py
import numpy as np

from .text import PlotError, printable

LINE = 3
FAILED = 0.999  # damage from which a surface counts as failed


@dataclass
class Cracks:
    points: np.ndarray          # [num_points, 3] [m]; chains share no points
    damage: np.ndarray          # [num_points]
    opening: np.ndarray         # [num_points] [m]
    lines: np.ndarray           # [num_lines, 2] point numbers; none for D = 1, where every point is a crack
    edge: np.ndarray            # [num_cells] number of the fracture edge of each line or vertex

    def __len__(self):
        return len(self.edge)

    def chains(self):
        """Point numbers along each fracture edge, [num_edges] arrays in order from one end to the other."""
        first = np.flatnonzero(np.r_[True, np.diff(self.edge) != 0]) if len(self.lines) else np.array([], int)
        return [np.r_[part[:, 0], part[-1, 1]] for part in np.split(self.lines, first[1:]) if len(part)]


def read_cracks(path):
    try:
        with h5py.File(path, "r") as file:
            root = file["VTKHDF"]
            is_line = root["Types"][:] == LINE
            lines = root["Connectivity"][:].reshape(-1, 2) if is_line.any() else np.empty((0, 2), int)
            damage = np.nan_to_num(root["PointData/damage"][:])
            cracks = Cracks(root["Points"][:], damage, root["PointData/opening"][:], lines, root["CellData/edge"][:])
            if not (lines.min(initial=0) >= 0 and lines.max(initial=-1) < len(cracks.points) == len(damage)):
                raise ValueError("its arrays do not fit together")
            return cracks
    except (OSError, KeyError, ValueError, RuntimeError) as error:
        raise PlotError(f"{printable(path)}: cannot be read as cracks ({printable(error)}); remove the file to draw without "
                        "them") from error


def crack_file(snapshot_path):
    """The crack file of the same time; it exists for runs with fracture."""
    return snapshot_path.with_name(snapshot_path.name.replace("snapshot_", "cracks_", 1))


def faces(points, edges, cracks):
    """Element borders that lie on a fracture edge: point pairs [n, 2] and the damage at their middles [n].

    An open crack has two of them at each place, one on either side. `points` [num_points, 2] and `edges` [n, 2] describe the
    snapshot; chains without a face are the third result.
    """
    middle = 0.5 * (points[edges[:, 0]] + points[edges[:, 1]])
    order = np.argsort(middle[:, 0])
    sorted_x = middle[order, 0]
    found, damage, without = [], [], []
    for chain in cracks.chains():
        a, b = cracks.points[chain[0], :2], cracks.points[chain[-1], :2]
        length = np.linalg.norm(b - a)
        if not length > 0:
            continue
        low, high = min(a[0], b[0]) - 1e-4 * length, max(a[0], b[0]) + 1e-4 * length
        near = order[np.searchsorted(sorted_x, low):np.searchsorted(sorted_x, high)]
        along = (middle[near] - a) @ (b - a) / length**2
        near, along = near[(along > 0) & (along < 1)], along[(along > 0) & (along < 1)]
        normal = np.array([a[1] - b[1], b[0] - a[0]]) / length
        distance = np.max(np.abs((points[edges[near]] - a) @ normal), axis=1) if len(near) else np.array([])
        on_line = distance < 1e-4 * length
        if not on_line.any():
            without.append(chain)
            continue
        places = np.linalg.norm(cracks.points[chain, :2] - a, axis=1) / length
        found.append(edges[near[on_line]])
        damage.append(np.interp(along[on_line], places, cracks.damage[chain]))
    if not found:
        return np.empty((0, 2), int), np.array([]), without
    return np.concatenate(found), np.concatenate(damage), without
