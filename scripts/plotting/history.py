"""The picture of history.csv: where the energy is, what is missing, and how far the cracks are."""
import numpy as np
from matplotlib.ticker import MaxNLocator

from .style import largest_size, plt, save, si_scale
from .tables import read_table
from .text import PlotError, note, printable

# Column, label, colour; stacked from below.
STACK = [("strain", "strain", "#8fb3d1"), ("kinetic", "kinetic", "#f0c987"), ("fracture", "fracture", "#c0392b"),
         ("friction", "friction", "#8e6bbf"), ("numerical", "numerical", "#7b858b")]
COLUMNS = ["external_work", "crack_length", "damage_mean", "damage_max", "cells", "smallest_cell"]
COUNTS = ["nucleations", "extensions", "branches", "coalescences", "fragments"]


def energy_unit(dimension):
    return {1: "J/m²", 2: "J/m", 3: "J"}.get(dimension, "J")


def supplied(table):
    """Energy that there was at t = 0 and that the load has added [rows]."""
    return table["kinetic"][0] + table["strain"][0] + table["external_work"]


def accounted(table):
    """Energy that is stored and that is lost [rows]."""
    return sum(table[name] for name, _, _ in STACK)


def has_fracture(table):
    return any(np.any(table[name] != 0) for name in ("fracture", "crack_length", "damage_max", "nucleations"))


def share_text(share):
    return f"{100 * share:.1f} %" if share >= 5e-4 else "< 0.1 %" if share > 0 else "0 %"


def draw_energies(axes, table, time, factor, unit):
    shown = [entry for entry in STACK if np.any(table[entry[0]] != 0)]
    total = supplied(table)
    reference = largest_size(total) or 1
    labels = [f"{label} ({share_text(table[name][-1] / reference)} at the end)" for name, label, _ in shown]
    if shown:  # nothing moves in a body at rest
        axes.stackplot(time, *[table[name] * factor for name, _, _ in shown], labels=labels,
                       colors=[colour for _, _, colour in shown], edgecolor="white", linewidth=0.4)
    axes.plot(time, total * factor, color="black", lw=1.2, ls=(0, (4, 2)), label="initial + external work")
    axes.set_ylabel(f"energy [{unit}]")
    axes.legend(*[part[::-1] for part in axes.get_legend_handles_labels()], loc="upper left", fontsize=8)


def draw_balance(axes, table, time):
    largest = max(largest_size(table[name]) for name in ("kinetic", "strain", "external_work"))
    error = (supplied(table) - accounted(table)) / largest if largest > 0 else 0 * time
    scale, percent = (100, "%") if largest_size(error) > 1e-5 else (1, "1")
    axes.plot(time, error * scale, color="#5f6b73")
    axes.axhline(0, color="#b8bec2", lw=0.6)
    axes.set_ylabel(f"balance [{percent}]")


def draw_cracks(axes, table, time, dimension):
    """Failed length on the left, damage on the right."""
    factor, unit = si_scale(table["crack_length"], "m") if dimension != 1 else (1, "1")
    length, = axes.plot(time, table["crack_length"] * factor, color="black", label="failed surface")
    axes.set_ylabel(f"failed surface [{unit}]")
    axes.set_ylim(bottom=0)
    right = axes.twinx()
    right.spines["right"].set_visible(True)
    mean, = right.plot(time, table["damage_mean"], color="#2aa198", label="damage, mean")
    largest, = right.plot(time, table["damage_max"], color="#0b4f6c", ls=(0, (4, 2)), label="damage, largest")
    right.set_ylabel("damage [1]")
    right.set_ylim(0, 1.05)
    axes.legend(handles=[length, mean, largest], loc="upper left", fontsize=8)


def draw_counts(axes, table, time):
    for name in COUNTS:
        if np.any(table[name] != 0):
            axes.step(time, table[name], where="post", label=name)
    largest = max(largest_size(table[name]) for name in COUNTS)
    if largest > 50:
        axes.set_yscale("symlog", linthresh=10)
        axes.yaxis.set_major_formatter("{x:g}")
    else:
        axes.yaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_ylim(0, 1.15 * largest if largest > 0 else 1)
    axes.set_ylabel("number")
    axes.legend(loc="upper left", fontsize=8, ncol=2)


def draw_cells(axes, table, time):
    """Number of cells on the left, shortest edge on the right."""
    cells, = axes.plot(time, table["cells"], color="#5f6b73", label="cells")
    axes.set_ylim(bottom=0)
    axes.set_ylabel("cells of the front")
    factor, unit = si_scale(table["smallest_cell"], "m")
    right = axes.twinx()
    right.spines["right"].set_visible(True)
    edge, = right.plot(time, table["smallest_cell"] * factor, color="#d98c1f", ls=(0, (4, 2)), label="shortest edge")
    right.set_ylim(bottom=0)
    right.set_ylabel(f"shortest edge [{unit}]")
    axes.legend(handles=[cells, edge], loc="lower left", fontsize=8)


def optional_panels(table, dimension):
    """Functions (axes, table, time) for what this run has besides energies."""
    panels = []
    if has_fracture(table):
        panels += [lambda *where: draw_cracks(*where, dimension), draw_counts]
    if np.nanmax(table["cells"], initial=0) > np.nanmin(table["cells"], initial=np.inf):
        panels.append(draw_cells)
    return panels


def draw_history(folder, dimension, title):
    path = folder / "history.csv"
    table = read_table(path)
    missing = [name for name in [name for name, _, _ in STACK] + COLUMNS + COUNTS if name not in table]
    if missing:
        raise PlotError(f"{printable(path)}: there is no column {missing[0]}, so it is no history of a run")
    time = table["time"] * 1e6
    if len(time) == 0:
        return note("history.csv: there is no row yet")
    factor, unit = si_scale(max(largest_size(supplied(table)), largest_size(accounted(table))), energy_unit(dimension))
    others = optional_panels(table, dimension)
    heights = [3, 1] + [1.8] * len(others)
    figure, panels = plt.subplots(len(heights), 1, figsize=(7, 1.2 * sum(heights)), sharex=True, constrained_layout=True,
                                  gridspec_kw={"height_ratios": heights})
    draw_energies(panels[0], table, time, factor, unit)
    draw_balance(panels[1], table, time)
    for axes, draw in zip(panels[2:], others):
        draw(axes, table, time)
    panels[0].set_title(title.rstrip(", ") or "energy")
    panels[-1].set_xlabel("t [µs]")
    panels[-1].set_xlim(time[0], time[-1] if time[-1] > time[0] else None)
    for axes in panels:
        axes.grid(color="#e4e7e9", lw=0.6)
        axes.set_axisbelow(True)
    save(figure, folder / "history.png")
