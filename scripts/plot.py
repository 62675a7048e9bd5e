#!/usr/bin/python3
"""Draws a result folder: fields and cracks at times, energies over time, probes. The pictures go into the folder.

Needs numpy, matplotlib and h5py. What the files hold is described in docs/results.md.
"""
import argparse
import json
import math
import os
import sys
import time
from pathlib import Path

try:
    from plotting import line, plane, sequence, space, spacetime
    from plotting.animation import MOST_FRAMES, write_film
    from plotting.cracks import crack_file, read_cracks
    from plotting.history import draw_history
    from plotting.quantity import choose_quantity
    from plotting.snapshot import read_snapshot, series
    from plotting.style import save
    from plotting.tables import draw_probe
    from plotting.text import PlotError, note, pictured, printable
except ImportError as error:
    sys.exit(f"plot: {error}; install python3-numpy, python3-matplotlib and python3-h5py, and use /usr/bin/python3")

DRAWINGS = {1: line, 2: plane, 3: space}
CRACKED_DEFORMATION = 100  # so that openings of a part of a micrometre are seen on a body of a millimetre
MOST_MOMENTS = 60          # on a page
MANY_PICTURES = 50         # from here on their time is said


def finite_number(text):
    number = float(text)
    if not math.isfinite(number):
        raise argparse.ArgumentTypeError("must be finite")
    return number


def moments(text):
    number = int(text)
    if not 0 <= number <= MOST_MOMENTS:
        raise argparse.ArgumentTypeError(f"must lie in [0, {MOST_MOMENTS}], so that the panels can be seen")
    return number


def parse_arguments(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, metavar="DIR", help="result folder of tentpole run")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--time", type=finite_number, metavar="T",
                       help="the snapshot nearest to T seconds (default: the last one)")
    which.add_argument("--all", action="store_true", help="every snapshot, with common scales")
    parser.add_argument("--animate", "--animation", action="store_true", help="also an animation of all snapshots")
    parser.add_argument("--format", choices=["gif", "mp4"], default="gif", help="of the animation; mp4 needs ffmpeg")
    parser.add_argument("--sequence", type=moments, default=6, metavar="N",
                        help="moments on the page sequence.png of a plane body (default 6; 0: no page)")
    parser.add_argument("--height", choices=["velocity", "speed", "vx", "vy", "none"],
                        help="height of the relief of a plane body: |v| (also called speed), a component, or no relief "
                             "(default: velocity, where there is one)")
    parser.add_argument("--deformation", type=finite_number, metavar="SCALE",
                        help=f"draw a plane body moved by SCALE u (default: {CRACKED_DEFORMATION} with cracks, otherwise 0)")
    parser.add_argument("--mesh", action=argparse.BooleanOptionalAction, default=True, help="lines of the mesh")
    options = parser.parse_args(arguments)
    if options.height == "speed":
        options.height = "velocity"
    return options


def read_summary(folder):
    """What the run wrote at its end; empty where it did not."""
    path = folder / "summary.json"
    if not path.exists():
        return {}
    try:
        summary = json.loads(path.read_text(encoding="utf-8", errors="replace"))
    except (OSError, ValueError) as error:
        note(f"{printable(path)}: cannot be read ({printable(error)}); the pictures have no title")
        return {}
    return summary if isinstance(summary, dict) else {}


def chosen(entries, options):
    if options.all:
        return entries
    if options.time is None:
        return entries[-1:]
    return [min(entries, key=lambda entry: abs(entry[1] - options.time))]


def choose_deformation(entries, snapshot):
    """The default of --deformation. Cracks do not heal, so the last snapshot has them if any one does."""
    last = crack_file(entries[-1][0])
    has_cracks = last.exists() and len(read_cracks(last)) > 0
    return CRACKED_DEFORMATION if has_cracks and "displacement" in snapshot.fields else 0


def complete_options(entries, snapshot, options):
    """What the fields of the run decide; options that are given and cannot be met are refused."""
    needed = {"displacement": options.deformation, "velocity": options.height not in (None, "none")}
    missing = [name for name, wanted in needed.items() if wanted and name not in snapshot.fields]
    if missing and snapshot.dimension == 2:
        raise PlotError(f"{snapshot.name}: the picture needs the fields {', '.join(missing)}; add them to [output] fields "
                        "and run again")
    if options.deformation is None:
        options.deformation = choose_deformation(entries, snapshot)
    if options.height is None:
        options.height = "velocity" if "velocity" in snapshot.fields else "none"
    options.quantity = choose_quantity(snapshot)


def read_all(entries, fields):
    """One snapshot after the other, so that only one is in memory; all have the same fields."""
    for path, _ in entries:
        snapshot = read_snapshot(path)
        if set(snapshot.fields) != set(fields):
            raise PlotError(f"{printable(path)}: has other fields than the first snapshot; draw a folder of one run")
        yield snapshot


def draw_pictures(pictured_entries, fields, draw):
    """One picture per entry; of many, the time that they will take is said after the first."""
    start = time.monotonic()
    for number, ((path, _), snapshot) in enumerate(zip(pictured_entries, read_all(pictured_entries, fields)), start=1):
        figure = draw(snapshot)
        if figure is None:
            note(f"{snapshot.name}: holds no field that is drawn; add displacement, velocity, stress or "
                 "strain_energy_density to [output] fields")
            return
        save(figure, path.with_suffix(".png"))
        left = len(pictured_entries) - number
        if number == 1 and left >= MANY_PICTURES:
            minutes = left * (time.monotonic() - start) / 60
            note(f"{left} more pictures, about {minutes:.0f} min; leave out --all for the last one only")


def draw_snapshots(entries, options):
    first = read_snapshot(entries[0][0])
    complete_options(entries, first, options)
    drawing, fields = DRAWINGS[first.dimension], list(first.fields)
    # Scales are common to all pictures of one kind; a single picture has its own.
    wanted = chosen(entries, options)
    scales = drawing.limits(read_all(entries if options.animate or options.all else wanted, fields), options)
    draw_pictures(wanted, fields, lambda snapshot: drawing.draw(snapshot, scales, options))
    if options.animate and (first.dimension > 1 or scales):
        frames = sequence.choose(entries, MOST_FRAMES)
        if len(frames) < len(entries):
            note(f"the film has {len(frames)} of {len(entries)} snapshots")
        write_film(options.folder, options.format, (drawing.draw(s, scales, options) for s in read_all(frames, fields)))
    if first.dimension == 2 and options.sequence > 0 and len(entries) > 1:
        page = sequence.choose(entries, options.sequence)
        save(sequence.draw(page, plane.limits(read_all(page, fields), options), options), options.folder / "sequence.png")
    if first.dimension == 1 and len(entries) > 1:
        figure = spacetime.draw(entries, options)
        if figure:
            save(figure, options.folder / "spacetime.png")
    return first.dimension


def check_folder(folder):
    try:
        is_folder = folder.is_dir()
    except OSError as error:
        raise PlotError(f"{printable(folder)}: this folder cannot be entered ({error.strerror}); ask its owner for a "
                        "copy") from error
    if not is_folder:
        raise PlotError(f"{printable(folder)}: no such folder; give the result folder of tentpole run")
    if not os.access(folder, os.R_OK | os.W_OK | os.X_OK):
        raise PlotError(f"{printable(folder)}: this folder cannot be written to, and the pictures go into it; copy it to a "
                        "place of your own")


def draw_folder(options):
    folder = options.folder
    check_folder(folder)
    summary = read_summary(folder)
    title = summary.get("title")
    options.title = pictured(title) + ", " if isinstance(title, str) and title else ""
    entries, probes = series(folder), sorted(folder.glob("probe_*.csv"))
    has_history = (folder / "history.csv").exists()
    if not (entries or probes or has_history):
        raise PlotError(f"{printable(folder)}: there is nothing to draw: no snapshots, no history.csv and no probes; if the run "
                        "was stopped, go on with it first")
    dimension = draw_snapshots(entries, options) if entries else summary.get("dimension")
    if has_history:
        draw_history(folder, dimension, options.title)
    for path in probes:
        draw_probe(path, options.title)


def main():
    options = parse_arguments()
    try:
        draw_folder(options)
    except PlotError as error:
        sys.exit(str(error))
    except MemoryError:
        sys.exit(f"{printable(options.folder)}: the snapshots do not fit into memory; draw on a machine with more of it")
    except BrokenPipeError:
        sys.exit(1)
    except OSError as error:
        sys.exit(f"{printable(error.filename or options.folder)}: {error.strerror}; check the permissions of the folder")
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main()
