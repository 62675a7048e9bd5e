"""D = 2: strain energy density in colour over the velocity as height, with the mesh, and the same seen from above."""
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize

from .relief import View, paint, shade
from .snapshot import element_edges, smooth_small_jumps
from .style import COLOUR_MAP, colour_limit, line_colours, si_scale, stacked_axes, time_text


def height_values(snapshot, name):
    return snapshot.speed() if name == "speed" else snapshot.fields["velocity"][:, "xy".index(name[1])]


def limits(snapshots, height):
    """End of the colour scale and largest |height|, so that all frames share their scales."""
    energy = max(colour_limit(s.fields["strain_energy_density"]) for s in snapshots)
    speed = max(np.max(np.abs(height_values(s, height))) for s in snapshots)
    return energy, speed


def deformed(snapshot, scale):
    points = snapshot.points.copy()
    if scale:
        points += scale * snapshot.fields["displacement"]
    return points[:, :2]


def line_style(num_lines, extent_inches):
    """Thinner lines for finer meshes: opacity and width [pt]."""
    density = np.sqrt(num_lines) / extent_inches
    return float(np.clip(9 / max(density, 1e-9), 0.25, 0.75)), float(np.clip(4 / max(density, 1e-9), 0.18, 0.5))


def draw_relief(axes, snapshot, points, energy, norm, height, largest_height, edges):
    size = np.ptp(points, axis=0)
    lift = 0.22 * size.max() / largest_height if largest_height > 0 else 0
    space = np.column_stack([points, lift * smooth_small_jumps(snapshot.points, height, 0.2 * largest_height)])
    triangles = snapshot.simplices()
    polygons = space[triangles]
    opacity, width = line_style(len(edges), 7)
    view = View()
    paint(axes, view, [(polygons, shade(COLOUR_MAP(norm(energy[triangles].mean(axis=1))), polygons))], space[edges],
          line_colours(COLOUR_MAP(norm(energy[edges].mean(axis=1))), opacity), width)
    low, high = points.min(axis=0), points.max(axis=0)
    corners = np.array([[low[0], low[1], 0], [high[0], low[1], 0], [high[0], high[1], 0], [low[0], high[1], 0]])
    outline, _ = view.project(corners[[0, 1, 2, 3, 0]])
    axes.plot(*outline.T, color="#9aa3a8", lw=0.6, zorder=0)
    return view, corners, lift


def annotate_relief(axes, view, corners, lift, largest_height, label, length_unit):
    """A bar for the height beside the nearest corner, and the lengths of the domain along its edges."""
    factor, unit = length_unit
    size = np.ptp(corners, axis=0)
    for a, b, length, offset in ((0, 1, size[0], (0, -10)), (1, 2, size[1], (12, -6))):
        middle, _ = view.project((corners[a] + corners[b]) / 2)
        axes.annotate(f"{length * factor:.4g} {unit}", middle, xytext=offset, textcoords="offset points", ha="center",
                      va="top", color="#444444")
    if not lift:
        return
    foot = corners[0] - np.array([0.04 * size.max(), 0, 0])
    bar, _ = view.project(np.array([foot, foot + [0, 0, lift * largest_height]]))
    axes.annotate("", bar[1], bar[0], arrowprops={"arrowstyle": "|-|,widthA=0.2,widthB=0.2", "lw": 0.8, "color": "#444444"})
    axes.annotate(label, bar.mean(axis=0), xytext=(-6, 0), textcoords="offset points", ha="right", va="center",
                  color="#444444")


def draw_flat(axes, snapshot, points, energy, norm, edges, length_unit):
    factor, unit = length_unit
    scaled = points * factor
    axes.tripcolor(scaled[:, 0], scaled[:, 1], snapshot.simplices(), energy, shading="gouraud", cmap=COLOUR_MAP, norm=norm,
                   rasterized=True)
    opacity, width = line_style(len(edges), 7)
    colours = line_colours(COLOUR_MAP(norm(energy[edges].mean(axis=1))), opacity)
    axes.add_collection(LineCollection(scaled[edges], colors=colours, linewidths=width))
    axes.set_aspect("equal")
    axes.set_xlim(scaled[:, 0].min(), scaled[:, 0].max())
    axes.set_ylim(scaled[:, 1].min(), scaled[:, 1].max())
    axes.set_xlabel(f"x [{unit}]")
    axes.set_ylabel(f"y [{unit}]")


def draw(snapshot, scales, options):
    """The figure of one snapshot; `scales` from limits()."""
    largest_energy, largest_height = scales
    factor, unit = si_scale(largest_energy, "J/m³")
    norm = Normalize(0, largest_energy * factor if largest_energy > 0 else 1)
    energy = snapshot.fields["strain_energy_density"] * factor
    points = deformed(snapshot, options.deformation)
    length_unit = si_scale(np.ptp(snapshot.points, axis=0), "m")
    edges = element_edges(snapshot.cells)
    share = np.ptp(points[:, 1]) / np.ptp(points[:, 0])
    # Height over width of the projected box, for the directions of View().
    relief_share = ((0.47 + 0.88 * share) * 0.56 + 0.2) / (0.88 + 0.47 * share)
    figure, top, bottom, bar = stacked_axes(relief_share, share)
    height = height_values(snapshot, options.height)
    view, corners, lift = draw_relief(top, snapshot, points, energy, norm, height, largest_height, edges)
    name = "|v|" if options.height == "speed" else f"v$_{options.height[1]}$"
    annotate_relief(top, view, corners, lift, largest_height, f"{name}\n{largest_height:.3g} m/s", length_unit)
    draw_flat(bottom, snapshot, points, energy, norm, edges, length_unit)
    note = f", displacement ×{options.deformation:g}" if options.deformation else ""
    top.set_title(f"{options.title}{time_text(snapshot.time)}{note}")
    figure.colorbar(ScalarMappable(norm, COLOUR_MAP), cax=bar, extend="max", label=f"strain energy density [{unit}]")
    return figure
