"""Reads the tables of a result and draws probe_NAME.csv."""
import numpy as np

from .style import plt, save, si_scale

PROBE_PANELS = [("u", "displacement", "m"), ("v", "velocity", "m/s"), ("s", "stress", "Pa")]


def read_table(path):
    """Columns by name; a file with a single row has arrays of length 1."""
    return np.atleast_1d(np.genfromtxt(path, delimiter=",", names=True))


def draw_probe(path, title):
    table = read_table(path)
    time = table["time"] * 1e6
    figure, rows = plt.subplots(3, 1, figsize=(7, 5.6), sharex=True, constrained_layout=True)
    for axes, (letter, quantity, si_unit) in zip(rows, PROBE_PANELS):
        names = [name for name in table.dtype.names if name[0] == letter]
        factor, unit = si_scale(np.array([table[name] for name in names]), si_unit)
        for name in names:
            symbol = "σ" if letter == "s" else letter
            axes.plot(time, table[name] * factor, label=f"{symbol}$_{{{name[1:]}}}$")
        axes.set_ylabel(f"{quantity} [{unit}]")
        axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))
        axes.grid(color="#e4e7e9", lw=0.6)
    rows[0].set_title(f"{title}probe {path.stem.removeprefix('probe_')}")
    rows[-1].set_xlabel("t [µs]")
    save(figure, path.with_suffix(".png"))
