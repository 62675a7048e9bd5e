#!/usr/bin/python3
"""Draws a result folder: fields and cracks at times, energies over time, probes. The pictures go into the folder.

Needs numpy, matplotlib and h5py. What the files hold is described in docs/results.md.
"""
import argparse
import json
import sys
from pathlib import Path

from plotting import line, plane, sequence, space, spacetime
from plotting.animation import write_film
from plotting.cracks import crack_file, read_cracks
from plotting.history import draw_history
from plotting.snapshot import read_snapshot, series
from plotting.style import save
from plotting.tables import draw_probe

DRAWINGS = {1: line, 2: plane, 3: space}
NEEDED_FIELDS = {1: [], 2: ["strain_energy_density"], 3: ["strain_energy_density"]}
CRACKED_DEFORMATION = 100  # so that openings of a part of a micrometre are seen on a body of a millimetre


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, metavar="DIR", help="result folder of tentpole run")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--time", type=float, metavar="T", help="the snapshot nearest to T seconds (default: the last one)")
    which.add_argument("--all", action="store_true", help="every snapshot, with common scales")
    parser.add_argument("--animate", "--animation", action="store_true", help="also an animation of all snapshots")
    parser.add_argument("--format", choices=["gif", "mp4"], default="gif", help="of the animation; mp4 needs ffmpeg")
    parser.add_argument("--sequence", type=int, default=6, metavar="N",
                        help="moments on the page sequence.png of a plane body (default 6; 0: no page)")
    parser.add_argument("--height", choices=["velocity", "speed", "vx", "vy", "none"], default="velocity",
                        help="height of the relief of a plane body: |v| (also called speed), a component, or no relief")
    parser.add_argument("--deformation", type=float, metavar="SCALE",
                        help=f"draw a plane body moved by SCALE u (default: {CRACKED_DEFORMATION} with cracks, otherwise 0)")
    parser.add_argument("--mesh", action=argparse.BooleanOptionalAction, default=True, help="lines of the mesh")
    options = parser.parse_args()
    if options.height == "speed":
        options.height = "velocity"
    return options


def read_title(folder):
    """The run's title, ready to be put before a time."""
    path = folder / "summary.json"
    title = json.loads(path.read_text())["title"] if path.exists() else ""
    return title + ", " if title else ""


def chosen(entries, options):
    if options.all:
        return entries
    if options.time is None:
        return entries[-1:]
    return [min(entries, key=lambda entry: abs(entry[1] - options.time))]


def choose_deformation(entries, snapshot, options):
    """The default of --deformation. Cracks do not heal, so the last snapshot has them if any one does."""
    last = crack_file(entries[-1][0])
    has_cracks = last.exists() and len(read_cracks(last)) > 0
    return CRACKED_DEFORMATION if has_cracks and "displacement" in snapshot.fields else 0


def check_fields(snapshot, options):
    needed = list(NEEDED_FIELDS[snapshot.dimension])
    if snapshot.dimension == 2:
        needed += (["displacement"] if options.deformation else []) + (["velocity"] if options.height != "none" else [])
    missing = [name for name in needed if name not in snapshot.fields]
    if missing:
        sys.exit(f"{snapshot.name}: the picture needs the fields {', '.join(missing)}; add them to [output] fields and run again")


def read_all(entries):
    """One snapshot after the other, so that only one is in memory."""
    return (read_snapshot(path) for path, _ in entries)


def draw_snapshots(entries, options):
    first = read_snapshot(entries[0][0])
    if options.deformation is None:
        options.deformation = choose_deformation(entries, first, options)
    check_fields(first, options)
    drawing = DRAWINGS[first.dimension]
    # Scales are common to all pictures of one kind; a single picture has its own.
    pictured = chosen(entries, options)
    scales = drawing.limits(read_all(entries if options.animate or options.all else pictured), options)
    for path, _ in pictured:
        save(drawing.draw(read_snapshot(path), scales, options), path.with_suffix(".png"))
    if options.animate:
        write_film(options.folder, options.format, (drawing.draw(s, scales, options) for s in read_all(entries)))
    if first.dimension == 2 and options.sequence > 0 and len(entries) > 1:
        moments = sequence.choose(entries, options.sequence)
        save(sequence.draw(moments, plane.limits(read_all(moments), options), options), options.folder / "sequence.png")
    if first.dimension == 1 and len(entries) > 1:
        figure = spacetime.draw(entries, options)
        if figure:
            save(figure, options.folder / "spacetime.png")
    return first.dimension


def main():
    options = parse_arguments()
    if not options.folder.is_dir():
        sys.exit(f"{options.folder}: no such folder; give the result folder of tentpole run")
    options.title = read_title(options.folder)
    entries = series(options.folder)
    dimension = draw_snapshots(entries, options) if entries else 0
    if (options.folder / "history.csv").exists():
        draw_history(options.folder, dimension, options.title)
    for path in sorted(options.folder.glob("probe_*.csv")):
        draw_probe(path, options.title)


if __name__ == "__main__":
    main()
