"""Reads the tables of a result and draws probe_NAME.csv."""
import numpy as np

from .style import plt, save, si_scale
from .text import PlotError, note, pictured, printable

PROBE_PANELS = [("u", "displacement", "m"), ("v", "velocity", "m/s"), ("s", "stress", "Pa")]


def read_table(path):
    """Columns by name, of the rows with a finite time; a last line that is cut off is left out."""
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise PlotError(f"{printable(path)}: cannot be read ({error.strerror})") from error
    lines = text.splitlines()
    if lines and not text.endswith("\n"):
        note(f"{printable(path.name)}: the last line is cut off and left out")
        lines.pop()
    names = lines[0].split(",") if lines else []
    rows = [line.split(",") for line in lines[1:]]
    for number, row in enumerate(rows, start=2):
        if len(row) != len(names):
            raise PlotError(f"{printable(path)}, line {number}: {len(row)} columns instead of {len(names)}; the file is damaged")
    if "time" not in names:
        raise PlotError(f"{printable(path)}: there is no column time, so it is no table of a run")
    try:
        values = np.array(rows, dtype=float).reshape(len(rows), len(names))
    except ValueError as error:
        raise PlotError(f"{printable(path)}: an entry is no number ({printable(error)}); the file is damaged") from error
    values[~np.isfinite(values)] = np.nan
    values = values[np.isfinite(values[:, names.index("time")])]
    return {name: values[:, column] for column, name in enumerate(names)}


def draw_probe(path, title):
    table = read_table(path)
    time = table["time"] * 1e6
    if len(time) == 0:
        return note(f"{printable(path.name)}: there is no row yet")
    figure, rows = plt.subplots(3, 1, figsize=(7, 5.6), sharex=True, constrained_layout=True)
    for axes, (letter, quantity, si_unit) in zip(rows, PROBE_PANELS):
        names = [name for name in table if name.startswith(letter)]
        factor, unit = si_scale(np.array([table[name] for name in names]), si_unit)
        for name in names:
            symbol = "σ" if letter == "s" else letter
            axes.plot(time, table[name] * factor, label=f"{symbol}$_{{{name[1:]}}}$")
        axes.set_ylabel(f"{quantity} [{unit}]")
        if names:
            axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))
        axes.grid(color="#e4e7e9", lw=0.6)
    rows[0].set_title(f"{title}probe {pictured(path.stem.removeprefix('probe_'))}")
    rows[-1].set_xlabel("t [µs]")
    save(figure, path.with_suffix(".png"))
