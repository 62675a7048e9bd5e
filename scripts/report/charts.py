"""Drawings of the report: curves over thread counts or degrees, and stacked bars."""
from plotting import style

plt = style.plt
COLOURS = ["#1f4e79", "#c0392b", "#2e8b57", "#8e6bbf", "#d98c1f", "#5f6b73", "#0f8b8d"]
SIZE, RESOLUTION = (4.8, 3.0), 150  # inches, dots per inch


def curves(series, x_label, y_label, ideal=None, logarithmic=False, marks=()):
    """A function that draws {label: (xs, ys)}; `ideal` = "speedup" adds the line y = x; `marks` are (x, text)."""
    def draw(axes):
        for index, (label, (xs, ys)) in enumerate(series.items()):
            axes.plot(xs, ys, marker="o" if len(xs) < 40 else None, markersize=3.5, label=label,
                      color=COLOURS[index % len(COLOURS)], linestyle="-" if index < len(COLOURS) else "--")
        if ideal == "speedup":
            end = max(max(xs) for xs, _ in series.values())
            highest = max(max(ys) for _, ys in series.values())
            axes.plot([1, end], [1, end], color="#999999", linewidth=0.8, linestyle=":", label="ideal")
            axes.set_ylim(0, 1.15 * max(highest, 1))
        elif not logarithmic:
            axes.set_ylim(bottom=0)
        for x, text in marks:
            _mark(axes, x, text, max(ys[xs.index(x)] for xs, ys in series.values() if x in xs))
        if logarithmic:
            axes.set_yscale("log")
        if all(float(x).is_integer() for xs, _ in series.values() for x in xs):
            axes.xaxis.get_major_locator().set_params(integer=True)
        axes.set_xlabel(x_label)
        axes.set_ylabel(y_label)
        axes.grid(axis="y", linewidth=0.4, color="#dddddd")
        if len(series) > 1 or ideal:
            _legend_above(axes)
    return draw


def _mark(axes, x, text, value):
    """A vertical line with its text in the half of the axes where the curve is not."""
    highest = axes.get_ylim()[1]
    is_low = value < highest / 2
    axes.axvline(x, color="#999999", linewidth=0.8, linestyle="--")
    axes.text(x, highest if is_low else 0, f" {text} ", rotation=90, va="top" if is_low else "bottom", ha="right", fontsize=8,
              color="#555555")


def _legend_above(axes):
    """A legend in rows above the axes, where it hides no curve; the figure grows with it."""
    labels = axes.get_legend_handles_labels()[1]
    columns = max(1, min(len(labels), int(50 / (6 + max(map(len, labels))))))
    height = SIZE[1] + 0.18 * (-(-len(labels) // columns) - 1)
    axes.figure.set_size_inches(SIZE[0], height)
    axes.figure.subplots_adjust(bottom=0.5 / height, top=(SIZE[1] - 0.3) / height)
    axes.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=columns, fontsize=8, borderaxespad=0.2, columnspacing=1.2,
                handlelength=1.4)


def shares(bars, stages):
    """A function that draws {label: values [%] of the stages} as horizontal stacked bars."""
    def draw(axes):
        for row, values in enumerate(bars.values()):
            left = 0
            for index, value in enumerate(values):
                axes.barh(row, value, left=left, height=0.6, color=COLOURS[index],
                          label=stages[index] if row == 0 else None)
                if value > 8:
                    axes.text(left + value / 2, row, f"{value:.1f} %", color="white", ha="center", va="center", fontsize=9)
                left += value
        axes.set_yticks(range(len(bars)), list(bars))
        axes.invert_yaxis()
        axes.set_xlim(0, 100)
        axes.set_xlabel("share of the time [%]")
        axes.figure.set_size_inches(SIZE[0], 1.2 + 0.5 * len(bars))
        axes.figure.subplots_adjust(left=0.26, bottom=0.5 / (1.2 + 0.5 * len(bars)), top=1 - 0.45 / (1.2 + 0.5 * len(bars)))
        axes.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=len(stages), fontsize=8, borderaxespad=0.2)
    return draw


def write(part, folder):
    """Draws a part into NAME.png."""
    figure, axes = plt.subplots(figsize=SIZE)
    figure.subplots_adjust(left=0.14, right=0.95, bottom=0.16, top=0.9)
    part.draw(axes)
    axes.set_title(part.nature, loc="left", fontsize=8, color="#555555")
    figure.savefig(folder / f"{part.name}.png", dpi=RESOLUTION, facecolor="white")
    plt.close(figure)
