"""D = 1: displacement, velocity, stress and strain energy density along the bar, discontinuous between the elements."""
import numpy as np

from .snapshot import SEGMENT
from .style import LINE_COLOURS, crack_style, plt, si_scale, time_text

PANELS = [("displacement", "u", "m"), ("velocity", "v", "m/s"), ("stress", "σ$_{xx}$", "Pa"),
          ("strain_energy_density", "strain energy density", "J/m³")]


def component(snapshot, name):
    values = snapshot.fields[name]
    return values if values.ndim == 1 else values[:, 0]


def limits(snapshots, _options):
    """Smallest and largest value of each field over all snapshots."""
    result = {}
    for snapshot in snapshots:
        for name, _, _ in PANELS:
            if name in snapshot.fields:
                values = component(snapshot, name)
                low, high = result.get(name, (np.inf, -np.inf))
                result[name] = (min(low, values.min()), max(high, values.max()))
    return result


def element_polylines(snapshot):
    """Points along x with a gap (index -1) after each element: where consecutive segments share no point."""
    segments = snapshot.cells[SEGMENT]
    path = []
    for k, (a, b) in enumerate(segments):
        if k == 0 or segments[k - 1][1] != a:
            path.extend([-1, a])
        path.append(b)
    return np.array(path[1:])


def draw(snapshot, scales, options):
    """The figure, or None where no field is there that can be drawn."""
    panels = [panel for panel in PANELS if panel[0] in scales]
    if not panels:
        return None
    factor, unit = si_scale(np.ptp(snapshot.points[:, 0]), "m")
    path = element_polylines(snapshot)
    x = np.where(path < 0, np.nan, snapshot.points[path, 0] * factor)
    figure, rows = plt.subplots(len(panels), 1, figsize=(7, 1.9 * len(panels)), sharex=True, constrained_layout=True,
                                squeeze=False)
    for index, (axes, (name, symbol, si_unit)) in enumerate(zip(rows[:, 0], panels)):
        scale, label = si_scale(scales[name], si_unit)
        axes.plot(x, np.where(path < 0, np.nan, component(snapshot, name)[path] * scale), color=LINE_COLOURS[index])
        low, high = np.array(scales[name]) * scale
        margin = 0.06 * (high - low) or 1
        axes.set_ylim(low - margin, high + margin)
        axes.set_ylabel(f"{symbol} [{label}]")
        axes.grid(color="#e4e7e9", lw=0.6)
        draw_crack_points(axes, snapshot, factor)
    ends = snapshot.points[element_ends(path), 0] * factor
    rows[-1, 0].plot(ends, np.full(len(ends), rows[-1, 0].get_ylim()[0]), "|", color="#5f6b73", ms=6, mew=0.5, clip_on=False)
    cracks = ", cracks dotted (black: failed)" if snapshot.cracks else ""
    rows[-1, 0].set_xlabel(f"x [{unit}], elements marked{cracks}")
    rows[0, 0].set_title(f"{options.title}{time_text(snapshot.time)}")
    return figure


def draw_crack_points(axes, snapshot, factor):
    if snapshot.cracks:
        colours, widths = crack_style(snapshot.cracks.damage)
        axes.vlines(snapshot.cracks.points[:, 0] * factor, *axes.get_ylim(), colors=colours, linewidths=widths, ls=":")


def element_ends(path):
    gaps = np.flatnonzero(path < 0)
    return path[np.concatenate([[0], gaps - 1, gaps + 1, [len(path) - 1]])]
