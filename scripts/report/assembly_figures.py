"""Figure 3.1, vectorization of the assembly, and the ladder of all rungs."""
from report import charts
from report.exhibit import Exhibit, Part, number
from report.thesis_numbers import DEGREES, NET, SEQUENTIAL, THREADED, VECTORIZED, unknowns

THESIS_STEPS = [("sequential optimisation", "library_operators", "sequential", SEQUENTIAL),
                ("vectorization", "sequential", "vectorized", VECTORIZED),
                ("threads", "vectorized", "threaded_rows", THREADED),
                ("net", "library_operators", "threaded_rows", NET)]


def _best(assembly, rung, **arguments):
    """Shortest time of one cell [s] over the thread counts, or None."""
    times = [b["s_per_cell"] or b.seconds for b in assembly.find("assembly", rung, **arguments)]
    return min(times, default=None)


def _ratio(assembly, slow, fast, degree):
    times = [_best(assembly, rung, d=4, k=degree) for rung in (slow, fast)]
    return times[0] / times[1] if all(times) else None


def vectorization(assembly, source):
    exhibit = Exhibit("3.1", "Figure", "Vectorization of the assembly",
                      "Time of the sequential optimised assembly over that of the vectorized one, for degrees k of the "
                      "four-dimensional element (three space dimensions and time). The host of the thesis had vectors of "
                      "2 doubles.")
    ratios = {k: _ratio(assembly, "sequential", "vectorized", k) for k in DEGREES}
    ratios = {k: ratio for k, ratio in ratios.items() if ratio}
    largest = max(ratios, default=None)
    exhibit.comparison = [("speedup, k = 7", number(VECTORIZED), number(ratios.get(7)), "measured")]
    if largest and largest != 7:
        exhibit.comparison.append((f"speedup, k = {largest}", "–", number(ratios[largest]), "measured"))
    exhibit.add(Part(exhibit.name, "measured", source, ["degree", "unknowns", "speedup"],
                     [[k, unknowns(k), number(ratio)] for k, ratio in ratios.items()],
                     charts.curves({"vectorized": (list(ratios), list(ratios.values()))}, "degree k", "speedup")),
                "bench_assembly has no result for both rungs.")
    return exhibit


def ladder(assembly, source):
    """All rungs; not in the thesis as a table, its steps are in the text."""
    exhibit = Exhibit("3.3.1", "Ladder", "From library operators to no quadrature at all",
                      "Time of one integration cell on each rung, the best over the thread counts. The last rungs are this "
                      "project's own.")
    rungs = list(dict.fromkeys(b.path[1] for b in assembly.find("assembly", d=4)))
    degrees = [k for k in DEGREES if assembly.find("assembly", d=4, k=k)]
    series, rows = {}, []
    for rung in rungs:
        times = {k: _best(assembly, rung, d=4, k=k) for k in degrees}
        times = {k: time for k, time in times.items() if time}
        series[rung.replace("_", " ")] = (list(times), list(times.values()))
        rows += [[rung, k, unknowns(k), f"{time:.4g}"] for k, time in times.items()]
    shown = 7 if 7 in degrees else max(degrees, default=7)
    exhibit.comparison = [(f"{step}, k = {shown}", number(thesis) if shown == 7 else f"{number(thesis)} (k = 7)",
                           number(_ratio(assembly, slow, fast, shown)), "measured")
                          for step, slow, fast, thesis in THESIS_STEPS]
    exhibit.add(Part("ladder", "measured", source, ["rung", "degree", "unknowns", "seconds per cell"], rows,
                     charts.curves(series, "degree k", "time per cell [s]", logarithmic=True)), "bench_assembly has no result.")
    return exhibit


def assembly_figures(results):
    assembly, source = results.file("bench_assembly"), results.source("bench_assembly")
    return [vectorization(assembly, source), ladder(assembly, source)]
