"""D = 1: displacement and stress of the bar over place and time, one band per snapshot."""
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

from .line import component
from .snapshot import SEGMENT, read_snapshot
from .sequence import choose
from .style import crack_style, largest_size, plt, si_scale

PANELS = [("displacement", "u", "m"), ("stress", "σ$_{xx}$", "Pa")]
MOST_BANDS = 500  # more are no wider than a pixel
SIGNED = plt.get_cmap("RdBu_r")  # red: tension, motion to the right


def band_limits(times):
    """Lower and upper time of the band of each snapshot: half way to its neighbours."""
    middle = 0.5 * (times[1:] + times[:-1])
    return np.r_[times[0], middle], np.r_[middle, times[-1]]


def draw_field(axes, snapshots, bands, name, symbol, si_unit, length):
    scale, label = si_scale([np.max(np.abs(component(s, name))) for s in snapshots], si_unit)
    values, outlines = [], []
    for snapshot, low, high in zip(snapshots, *bands):
        segments = snapshot.cells[SEGMENT]
        values.append(component(snapshot, name)[segments].mean(axis=1) * scale)
        left, right = snapshot.points[segments, 0].T * length
        below, above = np.full(len(left), low), np.full(len(left), high)
        outlines.append(np.stack([np.stack([left, right, right, left], 1), np.stack([below, below, above, above], 1)], -1))
    values = np.concatenate(values)
    largest = largest_size(values) or 1
    norm = Normalize(-largest, largest)
    colours = SIGNED(norm(values))
    axes.add_collection(PolyCollection(np.concatenate(outlines), facecolors=colours, edgecolors=colours, linewidths=0.15,
                                       rasterized=True))
    axes.figure.colorbar(ScalarMappable(norm, SIGNED), ax=axes, label=f"{symbol} [{label}]", location="bottom", aspect=30,
                         pad=0.02)


def draw_crack_points(axes, snapshots, bands, length):
    for snapshot, low, high in zip(snapshots, *bands):
        if snapshot.cracks:
            x = snapshot.cracks.points[:, 0] * length
            colours, widths = crack_style(snapshot.cracks.damage)
            axes.vlines(x, low, high, colors=colours, linewidths=widths)


def draw(entries, options):
    snapshots = [read_snapshot(path) for path, _ in choose(entries, MOST_BANDS)]
    panels = [panel for panel in PANELS if panel[0] in snapshots[0].fields]
    if not panels:
        return None
    times = np.array([snapshot.time for snapshot in snapshots]) * 1e6
    bands = band_limits(times)
    low, high = snapshots[0].points[:, 0].min(), snapshots[0].points[:, 0].max()
    length, unit = si_scale(high - low, "m")
    figure, axes = plt.subplots(1, len(panels), figsize=(4 * len(panels), 4.6), sharey=True, squeeze=False,
                                constrained_layout=True)
    for panel, (name, symbol, si_unit) in zip(axes[0], panels):
        draw_field(panel, snapshots, bands, name, symbol, si_unit, length)
        draw_crack_points(panel, snapshots, bands, length)
        panel.set_xlim(low * length, high * length)
        panel.set_ylim(times[0], times[-1])
        panel.set_xlabel(f"x [{unit}]")
    axes[0, 0].set_ylabel("t [µs]")
    cracks = ", cracks by damage (black: failed)" if any(snapshot.cracks for snapshot in snapshots) else ""
    figure.suptitle(f"{options.title.rstrip(', ')}{cracks}".lstrip(", "), fontsize=10)
    return figure
