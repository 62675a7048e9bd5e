"""Pictures of history.csv and probe_NAME.csv."""
import numpy as np

from .style import plt, save, si_scale

# Column, label, line style; kinetic and strain energy of a travelling wave coincide, so one is dashed over the other.
FLOWS = [("external_work", "external work", ":"), ("kinetic", "kinetic", "-"), ("strain", "strain", (0, (4, 3))),
         ("numerical", "numerical", "-"), ("fracture", "fracture", "-"), ("friction", "friction", "-")]
PROBE_PANELS = [("u", "displacement", "m"), ("v", "velocity", "m/s"), ("s", "stress", "Pa")]


def read_table(path):
    """Columns by name; a file with a single row has arrays of length 1."""
    return np.atleast_1d(np.genfromtxt(path, delimiter=",", names=True))


def energy_unit(dimension):
    return {1: "J/m²", 2: "J/m", 3: "J"}.get(dimension, "J")


def balance_error(table):
    """Energy that is missing at each row: initial + work - stored - lost."""
    stored = table["kinetic"] + table["strain"]
    lost = table["numerical"] + table["fracture"] + table["friction"]
    return stored[0] + table["external_work"] - stored - lost


def draw_history(folder, dimension, title):
    table = read_table(folder / "history.csv")
    time = table["time"] * 1e6
    largest = max(np.max(np.abs(table[name])) for name, *_ in FLOWS)
    factor, unit = si_scale(largest, energy_unit(dimension))
    figure, (top, bottom) = plt.subplots(2, 1, figsize=(7, 4.8), sharex=True, constrained_layout=True,
                                         gridspec_kw={"height_ratios": [3, 1]})
    for name, label, line_style in FLOWS:
        if np.any(table[name] != 0):
            top.plot(time, table[name] * factor, label=label, ls=line_style)
    top.set_ylabel(f"energy [{unit}]")
    top.legend(loc="upper left", ncol=2)
    top.set_title(title.rstrip(", ") or "energy")
    error = balance_error(table) / largest if largest > 0 else 0 * time
    scale, percent = (100, "%") if np.max(np.abs(error)) > 1e-5 else (1, "1")
    bottom.plot(time, error * scale, color="#5f6b73")
    bottom.axhline(0, color="#b8bec2", lw=0.6)
    bottom.set_ylabel(f"balance [{percent}]")
    bottom.set_xlabel("t [µs]")
    bottom.set_xlim(time[0], time[-1] if time[-1] > time[0] else None)
    for axes in (top, bottom):
        axes.grid(color="#e4e7e9", lw=0.6)
    save(figure, folder / "history.png")


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
