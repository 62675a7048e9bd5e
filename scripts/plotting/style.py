"""One look for all pictures: fonts, colours, and SI prefixes for the axes."""
import warnings

import matplotlib
import numpy as np

from .text import PlotError, printable

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first)

warnings.filterwarnings("ignore", message="Glyph .* missing from current font")  # a title in any script

# Without the black end, so that mesh lines and text stay readable on the largest values.
COLOUR_MAP = matplotlib.colors.ListedColormap(plt.get_cmap("magma_r")(np.linspace(0, 0.86, 256)))
LINE_COLOURS = ["#1f4e79", "#c0392b", "#2e8b57", "#8e6bbf", "#d98c1f", "#5f6b73"]
MESH_COLOUR = "#2b2b2b"
# Colours of cracks: from light to dark teal while they are damaged, black from damage 0.999 on.
DAMAGE_MAP = matplotlib.colors.LinearSegmentedColormap.from_list("damage", ["#9fe0d8", "#2aa198", "#0b4f6c"])
DAMAGE_MAP.set_over("black")
DAMAGE_NORM = matplotlib.colors.Normalize(0, np.nextafter(0.999, 0))

plt.rcParams.update({
    "figure.dpi": 160, "savefig.dpi": 160, "font.size": 9, "font.family": "DejaVu Sans", "axes.titlesize": 10,
    "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.7, "xtick.major.width": 0.7,
    "ytick.major.width": 0.7, "legend.frameon": False, "lines.linewidth": 1.4,
    "axes.prop_cycle": matplotlib.cycler(color=LINE_COLOURS), "axes.formatter.useoffset": False})

PREFIXES = [(1e12, "T"), (1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"), (1e-12, "p")]


def largest_size(values):
    """Largest absolute value of those that are finite; 0 where there is none."""
    sizes = np.abs(np.asarray(values, dtype=float))
    return float(np.max(sizes[np.isfinite(sizes)], initial=0))


def si_scale(values, unit):
    """Factor and label, such as (1e-6, "MPa"), that bring the largest of the values between 1 and 1000."""
    largest = largest_size(values)
    if not largest > 0:
        return 1.0, unit
    for size, prefix in PREFIXES:
        if largest >= 0.999 * size:
            return 1 / size, prefix + unit
    return 1e12, "p" + unit


def colour_limit(values):
    """Upper end of a colour scale: singular points (crack tips) may exceed it, so that they do not darken the rest."""
    return float(np.quantile(values, 0.998))


def line_colours(surface_colours, opacity):
    """Mesh lines [n, 4] that are seen on surfaces of these colours [n, 4]: dark on light ones, light on dark ones."""
    dark = surface_colours[:, :3] @ [0.3, 0.59, 0.11] < 0.42
    lines = np.tile(matplotlib.colors.to_rgba(MESH_COLOUR, opacity), (len(dark), 1))
    lines[dark] = matplotlib.colors.to_rgba("#f4eef6", opacity)
    return lines


def crack_style(damage, width_inches=7):
    """Colours [n, 4] and widths [n] [pt] of cracks with this damage [n]; thinner in smaller pictures."""
    return DAMAGE_MAP(DAMAGE_NORM(damage)), (0.5 + 1.1 * damage) * np.clip(width_inches / 5, 0.5, 1)


def page_share(height_over_width):
    """The share of the width that a panel is high: a body that is very slim or flat gets a panel that is not."""
    return float(np.clip(height_over_width, 0.02, 4))


def stacked_axes(upper, lower, num_bars=1):
    """A figure with two panels of the same width (one for upper = 0) and places for colour bars, one above the other.

    Heights are shares of that width. Returns the figure, the upper panel or None, the lower one, the list of the bars.
    """
    upper, lower = page_share(upper) if upper else 0, page_share(lower)
    width, gap, margin = 6.2, 0.45 if upper else 0, 0.6
    content = max(width * (upper + lower) + gap, 1.6 * num_bars)
    total = content + 2 * margin
    figure = plt.figure(figsize=(width + 2.2, total))
    place = [0.8 / (width + 2.2), width / (width + 2.2)]
    bottom = figure.add_axes([place[0], margin / total, place[1], width * lower / total])
    top = None
    if upper:
        top = figure.add_axes([place[0], (margin + width * lower + gap) / total, place[1], width * upper / total])
    bars = []
    for index in range(num_bars):
        room = content / num_bars / total
        bars.append(figure.add_axes([place[0] + place[1] + 0.2 / (width + 2.2), margin / total + index * room,
                                     0.15 / (width + 2.2), room * (0.86 if num_bars > 1 else 0.9)]))
    return figure, top, bottom, bars


def time_text(seconds):
    """A time in microseconds, as the thesis gives them."""
    return f"t = {seconds * 1e6:.4g} µs"


def save(figure, path):
    """A picture under its final name is complete."""
    partial = path.with_name(f".{path.name}.partial")
    try:
        figure.savefig(partial, format="png", bbox_inches="tight", facecolor="white")
        partial.replace(path)
    except OSError as error:
        partial.unlink(missing_ok=True)
        raise PlotError(f"{printable(path)}: the picture cannot be written ({error.strerror}); check the free space and the "
                        "permissions of the folder") from error
    finally:
        plt.close(figure)
    print(printable(path), flush=True)
