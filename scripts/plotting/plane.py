"""D = 2: a quantity in colour over the velocity as height, and seen from above, with the mesh and the cracks."""
from dataclasses import dataclass

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize

from .cracks import faces
from .relief import View, paint, shade
from .quantity import Quantity
from .snapshot import element_edges, smooth_small_jumps
from .style import (COLOUR_MAP, DAMAGE_MAP, DAMAGE_NORM, colour_limit, crack_style, line_colours, si_scale, stacked_axes,
                    time_text)


def height_values(snapshot, name):
    return snapshot.speed() if name == "velocity" else snapshot.fields["velocity"][:, "xy".index(name[1])]


@dataclass
class Scales:
    """What the pictures of one call have in common."""
    quantity: Quantity
    largest: float              # upper end of the colours, SI
    height: tuple               # smallest and largest height, 0 included [m/s]
    size: np.ndarray            # sides of the undeformed body [m]
    low: np.ndarray             # box of the drawn points [m]
    high: np.ndarray
    has_cracks: bool

    def unit(self):
        return si_scale(self.largest, self.quantity.unit)

    def norm(self):
        return Normalize(0, self.largest * self.unit()[0] if self.largest > 0 else 1)

    def shown(self, snapshot):
        """The values in this unit."""
        return self.quantity.values(snapshot) * self.unit()[0]

    def length_unit(self):
        return si_scale(self.size, "m")

    def height_over_width(self):
        return (self.high[1] - self.low[1]) / (self.high[0] - self.low[0])

    def lift(self):
        """Height in the picture [m] per m/s."""
        largest = max(-self.height[0], self.height[1])
        return 0.22 * self.size.max() / largest if largest > 0 else 0


def limits(snapshots, options):
    largest, lowest, highest, has_cracks = 0, 0, 0, False
    low, high = np.full(2, np.inf), np.full(2, -np.inf)
    for snapshot in snapshots:
        largest = max(largest, colour_limit(options.quantity.values(snapshot)))
        if options.height != "none":
            height = height_values(snapshot, options.height)
            lowest, highest = min(lowest, height.min()), max(highest, height.max())
        points = deformed(snapshot, options.deformation)
        low, high = np.minimum(low, points.min(axis=0)), np.maximum(high, points.max(axis=0))
        size = np.ptp(snapshot.points[:, :2], axis=0)
        has_cracks = has_cracks or bool(snapshot.cracks)
    return Scales(options.quantity, largest, (lowest, highest), size, low, high, has_cracks)


def deformed(snapshot, scale):
    points = snapshot.points.copy()
    if scale:
        points += scale * snapshot.fields["displacement"]
    return points[:, :2]


def mesh_style(num_lines, extent_inches):
    """Opacity and width [pt] of mesh lines: thinner ones for finer meshes."""
    density = np.sqrt(num_lines) / extent_inches
    return float(np.clip(9 / max(density, 1e-9), 0.1, 0.75)), float(np.clip(4 / max(density, 1e-9), 0.15, 0.5))


def mesh_lines(colours, edges, width_inches):
    """Colours and width of the mesh lines on surfaces with these colours of points."""
    opacity, width = mesh_style(len(edges), width_inches)
    return line_colours(0.5 * (colours[edges[:, 0]] + colours[edges[:, 1]]), opacity), width


def crack_lines(snapshot, points, edges, deformation):
    """Segments [n, 2, 2] [m] along the cracks where they are drawn, and the damage of each [n].

    A deformed crack is drawn along both faces; a fracture edge younger than the slice has none and goes with the nearest point.
    """
    cracks = snapshot.cracks
    if not deformation:
        return cracks.points[cracks.lines][..., :2], cracks.damage[cracks.lines].mean(axis=1)
    pairs, damage, without = faces(snapshot.points[:, :2], edges, cracks)
    segments = [points[pairs]]
    damages = [damage]
    for chain in without:
        place = cracks.points[chain, :2]
        nearest = np.argmin(np.sum((snapshot.points[:, :2] - place.mean(axis=0))**2, axis=1))
        moved = place + points[nearest] - snapshot.points[nearest, :2]
        segments.append(np.stack([moved[:-1], moved[1:]], axis=1))
        damages.append(0.5 * (cracks.damage[chain[:-1]] + cracks.damage[chain[1:]]))
    return np.concatenate(segments), np.concatenate(damages)


def draw_relief(axes, snapshot, scales, options):
    points = deformed(snapshot, options.deformation)
    norm, lift, largest = scales.norm(), scales.lift(), max(-scales.height[0], scales.height[1])
    values = scales.shown(snapshot)
    height = smooth_small_jumps(snapshot.points, height_values(snapshot, options.height), 0.2 * largest)
    space = np.column_stack([points, lift * height])
    triangles, edges = snapshot.simplices(), element_edges(snapshot.cells)
    polygons, lines = space[triangles], []
    if options.mesh:
        colours, width = mesh_lines(COLOUR_MAP(norm(values)), edges, 7)
        lines.append((space[edges], colours, width))
    if snapshot.cracks:
        pairs, damage, _ = faces(snapshot.points[:, :2], edges, snapshot.cracks)
        lines.append((space[pairs], *crack_style(damage)))
    view = View()
    paint(axes, view, [(polygons, shade(COLOUR_MAP(norm(values[triangles].mean(axis=1))), polygons))], lines)
    frame_relief(axes, view, scales)
    return view


def frame_relief(axes, view, scales):
    """The outline of the body at height 0, and limits that hold all pictures of one call."""
    corners = base_corners(scales)
    outline, _ = view.project(corners[[0, 1, 2, 3, 0]])
    axes.plot(*outline.T, color="#9aa3a8", lw=0.6, zorder=0)
    levels = [np.array([0, 0, scales.lift() * height]) for height in scales.height]
    box, _ = view.project(np.concatenate([corners + level for level in levels]))
    margin = 0.01 * np.ptp(box[:, 0])
    axes.set_xlim(box[:, 0].min() - margin, box[:, 0].max() + margin)
    axes.set_ylim(box[:, 1].min() - margin, box[:, 1].max() + margin)


def base_corners(scales):
    low, high = scales.low, scales.high
    return np.array([[low[0], low[1], 0], [high[0], low[1], 0], [high[0], high[1], 0], [low[0], high[1], 0]])


def annotate_relief(axes, view, scales, name):
    """A bar for the height beside the nearest corner, and the sides of the undeformed body along its edges."""
    factor, unit = scales.length_unit()
    corners = base_corners(scales)
    for a, b, length, offset in ((0, 1, scales.size[0], (0, -10)), (1, 2, scales.size[1], (12, -6))):
        # Below the deepest place of the relief.
        middle, _ = view.project((corners[a] + corners[b]) / 2 + [0, 0, scales.lift() * scales.height[0]])
        axes.annotate(f"{length * factor:.4g} {unit}", middle, xytext=offset, textcoords="offset points", ha="center",
                      va="top", color="#444444", annotation_clip=False)
    largest = max(-scales.height[0], scales.height[1])
    if not largest > 0:
        return
    foot = corners[0] - np.array([0.04 * scales.size.max(), 0, 0])
    bar, _ = view.project(np.array([foot, foot + [0, 0, scales.lift() * largest]]))
    axes.annotate("", bar[1], bar[0], annotation_clip=False,
                  arrowprops={"arrowstyle": "|-|,widthA=0.2,widthB=0.2", "lw": 0.8, "color": "#444444"})
    axes.annotate(f"{name}\n{largest:.3g} m/s", bar.mean(axis=0), xytext=(-6, 0), textcoords="offset points", ha="right",
                  va="center", color="#444444", annotation_clip=False)


def draw_flat(axes, snapshot, scales, options, width_inches):
    """The body from above."""
    factor, unit = scales.length_unit()
    norm = scales.norm()
    points = deformed(snapshot, options.deformation)
    scaled, edges = points * factor, element_edges(snapshot.cells)
    values = scales.shown(snapshot)
    axes.tripcolor(scaled[:, 0], scaled[:, 1], snapshot.simplices(), values, shading="gouraud", cmap=COLOUR_MAP, norm=norm,
                   rasterized=True)
    if options.mesh:
        colours, width = mesh_lines(COLOUR_MAP(norm(values)), edges, width_inches)
        axes.add_collection(LineCollection(scaled[edges], colors=colours, linewidths=width))
    if snapshot.cracks:
        segments, damage = crack_lines(snapshot, points, edges, options.deformation)
        order = np.argsort(damage, kind="stable")  # failed ones on top
        colours, widths = crack_style(damage[order], width_inches)
        axes.add_collection(LineCollection(segments[order] * factor, colors=colours, linewidths=widths, capstyle="round"))
    axes.set_aspect("equal")
    axes.set_xlim(scales.low[0] * factor, scales.high[0] * factor)
    axes.set_ylim(scales.low[1] * factor, scales.high[1] * factor)
    axes.set_xlabel(f"x [{unit}]")
    axes.set_ylabel(f"y [{unit}]")


def add_colour_bars(figure, scales, panels=None, places=None):
    """Colour bars of the quantity and, with cracks, of the damage: beside `panels` or in the axes `places`."""
    bars = [(ScalarMappable(scales.norm(), COLOUR_MAP), "max", f"{scales.quantity.label} [{scales.unit()[1]}]")]
    if scales.has_cracks:
        bars.append((ScalarMappable(DAMAGE_NORM, DAMAGE_MAP), "max", "damage (black: failed)"))
    for index, (colours, extend, label) in enumerate(bars):
        room = {"cax": places[index]} if places else {"ax": panels, "aspect": 35, "pad": 0.015}
        bar = figure.colorbar(colours, extend=extend, label=label, **room)
        if index == 1:
            bar.set_ticks([0, 0.25, 0.5, 0.75])


def draw(snapshot, scales, options):
    """The figure of one snapshot; `scales` from limits()."""
    share = scales.height_over_width()
    depth = (scales.height[1] - scales.height[0]) * scales.lift() / (scales.high[0] - scales.low[0])
    # Height over width of the projected box, for the directions of View().
    relief_share = 0 if options.height == "none" else ((0.47 + 0.88 * share) * 0.56 + 0.83 * depth) / (0.88 + 0.47 * share)
    figure, top, bottom, bars = stacked_axes(relief_share, share, 2 if scales.has_cracks else 1)
    if top:
        view = draw_relief(top, snapshot, scales, options)
        name = "|v|" if options.height == "velocity" else f"v$_{options.height[1]}$"
        annotate_relief(top, view, scales, name)
    draw_flat(bottom, snapshot, scales, options, 7)
    note = f", displacement ×{options.deformation:g}" if options.deformation else ""
    (top or bottom).set_title(f"{options.title}{time_text(snapshot.time)}{note}")
    add_colour_bars(figure, scales, places=bars)
    return figure
