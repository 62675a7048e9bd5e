#!/usr/bin/python3
"""Draws a result folder: fields on time slices, energies over time, probes. PNG files go into the folder.

Needs numpy, matplotlib and h5py. What the files hold is described in docs/results.md.
"""
import argparse
import json
import sys
from pathlib import Path

import numpy as np

from plotting import line, plane, space
from plotting.snapshot import read_snapshot, series
from plotting.style import plt, save
from plotting.tables import draw_history, draw_probe

DRAWINGS = {1: line, 2: plane, 3: space}
NEEDED_FIELDS = {1: [], 2: ["velocity", "strain_energy_density"], 3: ["strain_energy_density"]}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, metavar="DIR", help="result folder of tentpole run")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--time", type=float, metavar="T", help="the snapshot nearest to T seconds (default: the last one)")
    which.add_argument("--all", action="store_true", help="every snapshot, with common scales")
    parser.add_argument("--animation", action="store_true", help="also animation.gif over all snapshots")
    parser.add_argument("--height", choices=["speed", "vx", "vy"], default="speed", help="height of the D = 2 relief")
    parser.add_argument("--deformation", type=float, default=0, metavar="SCALE", help="draw D = 2 points moved by SCALE u")
    return parser.parse_args()


def read_title(folder):
    """The run's title, ready to be put before a time."""
    path = folder / "summary.json"
    title = json.loads(path.read_text())["title"] if path.exists() else ""
    return title + ", " if title else ""


def chosen(entries, options):
    if options.all or not entries:
        return entries
    if options.time is None:
        return entries[-1:]
    return [min(entries, key=lambda entry: abs(entry[1] - options.time))]


def check_fields(snapshot, options):
    needed = list(NEEDED_FIELDS[snapshot.dimension]) + (["displacement"] if options.deformation else [])
    missing = [name for name in needed if name not in snapshot.fields]
    if missing:
        sys.exit(f"{snapshot.name}: the picture needs the fields {', '.join(missing)}; add them to [output] fields and run again")


def frame(figure):
    """The figure as an image; frames of an animation must have one size, so nothing is cropped."""
    from PIL import Image
    figure.set_dpi(110)
    figure.canvas.draw()
    image = Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3].copy())
    plt.close(figure)
    return image


def draw_snapshots(options):
    entries = series(options.folder)
    if not entries:
        return
    pictured = chosen(entries, options)
    # Scales are common to all pictures of one call; a single picture has its own.
    scaling = entries if options.animation or options.all else pictured
    snapshots = {path: read_snapshot(path) for path, _ in scaling}
    first = next(iter(snapshots.values()))
    check_fields(first, options)
    drawing = DRAWINGS[first.dimension]
    scales = drawing.limits(list(snapshots.values()), options.height)
    for path, _ in pictured:
        save(drawing.draw(snapshots[path], scales, options), path.with_suffix(".png"))
    if options.animation:
        frames = [frame(drawing.draw(snapshot, scales, options)) for snapshot in snapshots.values()]
        path = options.folder / "animation.gif"
        frames[0].save(path, save_all=True, append_images=frames[1:], duration=200, loop=0)
        print(path)


def main():
    options = parse_arguments()
    if not options.folder.is_dir():
        sys.exit(f"{options.folder}: no such folder; give the result folder of tentpole run")
    options.title = read_title(options.folder)
    draw_snapshots(options)
    entries = series(options.folder)
    dimension = read_snapshot(entries[0][0]).dimension if entries else 0
    if (options.folder / "history.csv").exists():
        draw_history(options.folder, dimension, options.title)
    for path in sorted(options.folder.glob("probe_*.csv")):
        draw_probe(path, options.title)


if __name__ == "__main__":
    main()
