"""D = 3: a quantity in colour on the surface of the body and on a plane cut through its middle."""
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

from .relief import View, paint, shade
from .snapshot import FACES
from .style import COLOUR_MAP, colour_limit, line_colours, si_scale, stacked_axes, time_text


def limits(snapshots, options):
    """Upper end of the colours, SI."""
    return max(colour_limit(options.quantity.values(snapshot)) for snapshot in snapshots)


def surface_faces(snapshot):
    """Faces that belong to one cell only, matched by their centre because points are not shared: corners by count."""
    size = np.ptp(snapshot.points, axis=0).max()
    groups = []
    for num_corners in (3, 4):
        parts = [corners[:, list(face)] for kind, corners in snapshot.cells.items() for face in FACES[kind]
                 if len(face) == num_corners]
        if parts:
            groups.append(np.concatenate(parts))
    centres = np.concatenate([snapshot.points[group].mean(axis=1) for group in groups])
    _, inverse, count = np.unique(np.round(centres / size * 1e8), axis=0, return_inverse=True, return_counts=True)
    single = count[inverse.ravel()] == 1
    split = np.split(single, np.cumsum([len(group) for group in groups])[:-1])
    return [group[keep] for group, keep in zip(groups, split)]


def cut_polygons(snapshot, axis, level, shown):
    """Triangles and quads where the plane x_axis = level cuts the simplices: positions of corners, and means of the values
    `shown` at the points."""
    polygons, values = [], []
    simplices = snapshot.simplices()
    side = snapshot.points[simplices, axis] >= level
    for simplex, above in zip(simplices[side.any(axis=1) & ~side.all(axis=1)], side[side.any(axis=1) & ~side.all(axis=1)]):
        low, high = simplex[~above], simplex[above]
        pairs = [(a, b) for a in low for b in high]
        if len(pairs) == 4:
            pairs = [pairs[0], pairs[1], pairs[3], pairs[2]]
        a, b = np.array(pairs).T
        s = (level - snapshot.points[a, axis]) / (snapshot.points[b, axis] - snapshot.points[a, axis])
        polygons.append(snapshot.points[a] * (1 - s[:, None]) + snapshot.points[b] * s[:, None])
        values.append(np.mean(shown[a] * (1 - s) + shown[b] * s))
    return polygons, np.array(values)


def draw_surface(axes, snapshot, shown, norm):
    groups, lines = [], []
    for faces in surface_faces(snapshot):
        polygons = snapshot.points[faces]
        groups.append((polygons, shade(COLOUR_MAP(norm(shown[faces].mean(axis=1))), polygons)))
        for corner in range(faces.shape[1]):
            lines.append(np.column_stack([faces[:, corner], np.roll(faces, -1, axis=1)[:, corner]]))
    lines = np.concatenate(lines)
    colours = line_colours(COLOUR_MAP(norm(shown[lines].mean(axis=1))), 0.35)
    paint(axes, View(elevation=28), groups, [(snapshot.points[lines], colours, 0.25)])


def draw_cut(axes, snapshot, shown, norm):
    low, high = snapshot.points.min(axis=0), snapshot.points.max(axis=0)
    length, unit = si_scale(high - low, "m")
    level = 0.5 * (low[2] + high[2])
    polygons, means = cut_polygons(snapshot, 2, level, shown)
    colours = COLOUR_MAP(norm(means))
    axes.add_collection(PolyCollection([polygon[:, :2] * length for polygon in polygons], facecolors=colours,
                                       edgecolors=colours, linewidths=0.2))
    axes.set_xlim(low[0] * length, high[0] * length)
    axes.set_ylim(low[1] * length, high[1] * length)
    axes.set_aspect("equal")
    axes.set_xlabel(f"x [{unit}]")
    axes.set_ylabel(f"y [{unit}]")
    axes.set_title(f"cut z = {level * length:.4g} {unit}", fontsize=9)


def draw(snapshot, largest, options):
    factor, unit = si_scale(largest, options.quantity.unit)
    norm = Normalize(0, largest * factor if largest > 0 else 1)
    shown = options.quantity.values(snapshot) * factor
    size = np.ptp(snapshot.points, axis=0)
    surface_share = ((0.47 + 0.88 * size[1] / size[0]) * 0.47 + 0.88 * size[2] / size[0]) / (0.88 + 0.47 * size[1] / size[0])
    figure, top, bottom, (bar,) = stacked_axes(surface_share, size[1] / size[0])
    draw_surface(top, snapshot, shown, norm)
    top.set_title(f"{options.title}{time_text(snapshot.time)}")
    draw_cut(bottom, snapshot, shown, norm)
    figure.colorbar(ScalarMappable(norm, COLOUR_MAP), cax=bar, extend="max", label=f"{options.quantity.label} [{unit}]")
    return figure
