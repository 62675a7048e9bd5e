"""Figures 3.7 and 3.8: the threaded solution of a patch. The thesis's text ends before its results."""
from report import charts
from report.exhibit import Exhibit, Part, number

ENDS = "The source of the thesis ends before its results for the threaded solution, so there is nothing to compare with. "
VARIANTS = ["lapack", "batched"]


def _curves(lu, quantity):
    """{"lapack, N = 1980": (threads, values)} of the largest patch of each variant."""
    series = {}
    for variant in VARIANTS:
        found = [b for b in lu.find("lu", variant) if b[quantity] is not None]
        if not found:
            continue
        largest = max(b["N"] or 0 for b in found)
        chosen = sorted((b for b in found if (b["N"] or 0) == largest), key=lambda b: b.arguments["threads"])
        series[f"{variant}, N = {largest:.0f}"] = ([b.arguments["threads"] for b in chosen], [b[quantity] for b in chosen])
    return series


def _variants(lu):
    """Rates of all variants on one thread, for the table below the curves."""
    return [(f"{b.path[1].replace('_', ' ')}, N = {b['N'] or 0:.0f}, one thread [GF/s]", "–", number(b["GF/s"]), "measured")
            for b in lu.find("lu", threads=1) if b["N"] == max(c["N"] or 0 for c in lu.find("lu", threads=1))]


def solution_figure(results, figure, quantity):
    lu, source = results.file("bench_lu"), results.source("bench_lu")
    exhibit = Exhibit(figure, "Figure", f"Multi-threaded LU solution: {quantity}",
                      ENDS + "Measured here: factor and solve of patches by LAPACK (the threads work on one patch) and by this "
                      "project's batches (each thread its own patches).")
    series = _curves(lu, quantity)
    rows = [[label, p, number(value, 4)] for label, (counts, values) in series.items() for p, value in zip(counts, values)]
    exhibit.add(Part(exhibit.name, "measured", source, ["variant", "threads", quantity], rows,
                     charts.curves(series, "threads p", quantity, "speedup" if quantity == "speedup" else None)),
                "bench_lu has no result.")
    exhibit.comparison = [(f"{quantity}, {label}, {counts[-1]} threads", "–", number(values[-1]), "measured")
                          for label, (counts, values) in series.items()]
    if quantity == "speedup":
        exhibit.comparison += _variants(lu)
    return exhibit


def solution_figures(results):
    return [solution_figure(results, "3.7", "speedup"), solution_figure(results, "3.8", "efficiency")]
