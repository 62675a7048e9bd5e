"""Figures 3.2 and 3.3: rows of a cell matrix on the threads of a host, measured here and modelled for the thesis's host."""
from report import charts
from report.exhibit import Exhibit, Part, number
from report.thesis_numbers import DEGREES, HOST_EFFICIENCY, HOST_THREADS, THREADED, unknowns

QUANTITY = {"speedup": "3.2", "efficiency": "3.3"}
TITLE = {"speedup": "Multi-threaded assembly on the host: speedup",
         "efficiency": "Multi-threaded assembly on the host: efficiency"}
THESIS = {"speedup": THREADED, "efficiency": HOST_EFFICIENCY}


def measured_sweeps(threads, kind, quantity):
    """{k: (thread counts, values)} of threads/KIND."""
    sweeps = {}
    for k in DEGREES:
        found = sorted(threads.find("threads", kind, d=4, k=k), key=lambda b: b.arguments["threads"])
        points = [(b.arguments["threads"], b[quantity]) for b in found if b[quantity] is not None]
        if points:
            sweeps[k] = tuple(map(list, zip(*points)))
    return sweeps


def sweep_rows(sweeps):
    return [[k, unknowns(k), p, number(value, 4)] for k, (counts, values) in sweeps.items() for p, value in zip(counts, values)]


def labelled(sweeps):
    return {f"k = {k}": curve for k, curve in sweeps.items()}


def _modelled(model, quantity):
    return {k: ([int(row["threads"]) for row in rows], [row[quantity] for row in rows]) for k, rows in model.items()}


def _caption(quantity):
    kind = "Speedup T(1)/T(p)" if quantity == "speedup" else "Efficiency T(1)/(p T(p))"
    return (f"{kind} of one pass over the rows of an n × n matrix on p threads. Measured on this machine; modelled for the "
            "two Xeon X5680 of the thesis, because this machine has other cores.")


def host_figure(results, quantity):
    exhibit = Exhibit(QUANTITY[quantity], "Figure", TITLE[quantity], _caption(quantity))
    ideal = "speedup" if quantity == "speedup" else None
    sweeps = measured_sweeps(results.file("bench_threads"), "rows", quantity)
    modelled = _modelled(results.model("xeon_x5680_dual"), quantity)
    columns = ["degree", "unknowns", "threads", quantity]
    exhibit.add(Part(exhibit.name + "_measured", "measured", results.source("bench_threads"), columns, sweep_rows(sweeps),
                     charts.curves(labelled(sweeps), "threads p", quantity, ideal)), "bench_threads has no result.")
    exhibit.add(Part(exhibit.name + "_modelled", "modelled", "tentpole model xeon_x5680_dual.toml", columns, sweep_rows(modelled),
                     charts.curves(labelled(modelled), "threads p", quantity)), "tentpole model has no result.")
    if 7 in modelled:
        value = dict(zip(*modelled[7]))[HOST_THREADS]
        exhibit.comparison.append((f"{quantity}, k = 7, {HOST_THREADS} threads", number(THESIS[quantity], 4), number(value, 4),
                                   "modelled"))
    if sweeps:
        k = max(sweeps)
        for p, value in zip(*sweeps[k]):
            if p > 1:
                exhibit.comparison.append((f"{quantity}, k = {k}, {p} threads of this machine", "–", number(value), "measured"))
    return exhibit


def thread_figures(results):
    return [host_figure(results, quantity) for quantity in QUANTITY]
