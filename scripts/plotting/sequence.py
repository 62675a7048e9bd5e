"""Several moments of a plane body on one page, with common scales."""
import numpy as np

from .plane import add_colour_bars, draw_flat
from .snapshot import read_snapshot
from .style import page_share, plt, time_text


def choose(entries, number):
    """`number` entries at equal distances, the last one among them; all where there are no more."""
    if number >= len(entries):
        return entries
    return [entries[int(np.ceil((len(entries) - 1) * (index + 1) / number))] for index in range(number)]


def panel_name(index):
    """a, b, .., z, aa, ab, .."""
    letters = "abcdefghijklmnopqrstuvwxyz"
    return (panel_name(index // 26 - 1) if index >= 26 else "") + letters[index % 26]


def page_columns(number, share):
    """Columns of a grid of `number` panels of this height over width, so that the page is about 1.15 times as wide as high."""
    def misfit(columns):
        rows = -(-number // columns)
        shape = columns / (rows * (share + 0.16))
        return abs(np.log(shape / 1.15)) + 0.3 * (columns * rows - number)
    return min(range(1, number + 1), key=misfit)


def draw(entries, scales, options):
    """The page for files and times `entries`."""
    share = page_share(scales.height_over_width())
    columns = page_columns(len(entries), share)
    rows = -(-len(entries) // columns)
    width = 7.2 / columns
    bars = 1.8 if scales.has_cracks else 0.9
    figure, panels = plt.subplots(rows, columns, figsize=(7.2 + 0.5 + bars, rows * (width * share + 0.3) + 0.75),
                                  squeeze=False, sharex=True, sharey=True, constrained_layout=True)
    for index, axes in enumerate(panels.flat):
        if index >= len(entries):
            axes.set_axis_off()
            continue
        snapshot = read_snapshot(entries[index][0])
        draw_flat(axes, snapshot, scales, options, width)
        axes.set_title(f"({panel_name(index)})  {time_text(snapshot.time)}", fontsize=9)
        axes.label_outer()
    note = f", displacement ×{options.deformation:g}" if options.deformation else ""
    figure.suptitle(f"{options.title.rstrip(', ')}{note}".lstrip(", "), fontsize=10)
    add_colour_bars(figure, scales, panels)
    return figure
