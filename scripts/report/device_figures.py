"""Figures 3.4 to 3.6: the many-core card of the thesis, modelled, and transfers to the device at hand, measured; and whole
patches on a GPU where there is one."""
from report import charts
from report.exhibit import Exhibit, Part, number
from report.thesis_numbers import (BEST_BALANCED_THREADS, CARD_EFFICIENCY, CARD_SPEEDUP, CARD_THREADS, DEGREES, is_balanced,
                                   unknowns)
from report.thread_figures import labelled, measured_sweeps, sweep_rows

CARD = "tentpole model xeon_phi_knc.toml"
MODES = ["host", "transfer", "persistent", "overlapped"]
COLUMNS = ["threads", "speedup", "efficiency", "imbalance"]


def _part(name, rows, draw):
    return Part(name, "modelled", CARD + ", n = 990", COLUMNS,
                [[int(r["threads"]), *(number(r[c], 4) for c in COLUMNS[1:])] for r in rows], draw)


def _points(rows, quantity):
    return [int(r["threads"]) for r in rows], [r[quantity] for r in rows]


def _transfers(results):
    """Time of 100 updates [s] and moved bytes for each mode and degree."""
    traffic = results.file("bench_traffic")
    found = {mode: [b for b in traffic.find("traffic", mode, d=4) if b.arguments["k"] in DEGREES] for mode in MODES}
    series = {mode: ([b.arguments["k"] for b in bs], [b.seconds for b in bs]) for mode, bs in found.items() if bs}
    rows = [[mode, b.arguments["k"], unknowns(b.arguments["k"]), f"{b.seconds:.4g}", number(b["transfer_%"]), b["bytes_up"],
             b["bytes_down"], b["launches"]] for mode, bs in found.items() for b in bs]
    return series, rows


def card_figure(results):
    exhibit = Exhibit("3.4", "Figure", "Assembly on the many-core card, n = 990",
                      "Speedup and efficiency of a pass over the rows of the cell matrix, k = 7, on 1 to 120 threads of a "
                      "Xeon Phi. Modelled: 15 threads are where the matrix begins to fit the caches, 60 where the cores end.")
    rows = results.model("xeon_phi_knc").get(7, [])
    speedup, efficiency = _points(rows, "speedup"), _points(rows, "efficiency")
    marks = [(15, "matrix fits the caches"), (CARD_THREADS, "all cores")]
    for quantity, points in (("speedup", speedup), ("efficiency", efficiency)):
        drawing = charts.curves({quantity: points}, "threads p", quantity, marks=marks)
        exhibit.add(_part(f"figure_3_4_{quantity}", rows, drawing), "tentpole model has no result.")
    if rows:
        at = {int(r["threads"]): r for r in rows}
        best = max(rows, key=lambda r: r["speedup"])
        rises = [f"{at[a]['efficiency']:.3f} → {at[b]['efficiency']:.3f}" for a, b in ((14, 15), (23, 24))]
        exhibit.comparison = [
            ("threads of the largest speedup", str(CARD_THREADS), str(int(best["threads"])), "modelled"),
            (f"speedup on {CARD_THREADS} threads", number(CARD_SPEEDUP, 4), number(at[CARD_THREADS]["speedup"], 4), "modelled"),
            (f"efficiency on {CARD_THREADS} threads", number(CARD_EFFICIENCY, 4),
             number(at[CARD_THREADS]["efficiency"], 4), "modelled"),
            ("efficiency from 14 to 15 threads", "rises", rises[0], "modelled"),
            ("efficiency from 23 to 24 threads", "falls", rises[1], "modelled")]
    return exhibit


def persistent_figure(results):
    exhibit = Exhibit("3.5", "Figure", "Assembly on the device with persistent data, k = 1 to 7",
                      "Modelled: speedup on the threads of a Xeon Phi. Measured on the device at hand: the time of 100 updates "
                      "of the matrix on the host, with a transfer each time, with persistent data, and with the transfers "
                      "overlapped; and the speedup over the threads of a virtual device.")
    modelled = {k: _points(rows, "speedup") for k, rows in results.model("xeon_phi_knc").items()}
    columns = ["degree", "unknowns", "threads", "speedup"]
    exhibit.add(Part("figure_3_5_modelled", "modelled", CARD, columns, sweep_rows(modelled),
                     charts.curves(labelled(modelled), "threads p", "speedup")), "tentpole model has no result.")
    series, rows = _transfers(results)
    exhibit.add(Part("figure_3_5_transfer", "measured", results.source("bench_traffic"),
                     ["mode", "degree", "unknowns", "seconds", "transfer [%]", "bytes up", "bytes down", "launches"], rows,
                     charts.curves(series, "degree k", "time of 100 updates [s]", logarithmic=True)),
                "bench_traffic has no result.")
    sweeps = measured_sweeps(results.file("bench_threads"), "device_rows", "speedup")
    exhibit.add(Part("figure_3_5_device", "measured", results.source("bench_threads"), columns, sweep_rows(sweeps),
                     charts.curves(labelled(sweeps), "threads of the device", "speedup", "speedup")),
                "bench_threads has no result on a device.")
    exhibit.comparison = _persistent_comparison(series, modelled)
    return exhibit


def _persistent_comparison(series, modelled):
    comparison = []
    if "transfer" in series and "persistent" in series:
        common = set(series["transfer"][0]) & set(series["persistent"][0])
        k = max(common, default=None)
        if k:
            ratio = dict(zip(*series["transfer"]))[k] / dict(zip(*series["persistent"]))[k]
            comparison.append((f"transfer each time over persistent, k = {k}", "–", number(ratio), "measured"))
    if 7 in modelled:
        comparison.append((f"speedup, k = 7, {CARD_THREADS} threads", number(CARD_SPEEDUP, 4),
                           number(dict(zip(*modelled[7]))[CARD_THREADS], 4), "modelled"))
    return comparison


def filtered_figure(results):
    exhibit = Exhibit("3.6", "Figure", "Efficiency on the card, well balanced thread counts only",
                      "The curve of figure 3.4 where u/p = 0 or > 0.9 with u = n mod p: no thread, or only few, idle in the "
                      "last round.")
    rows = [r for r in results.model("xeon_phi_knc").get(7, [])
            if is_balanced(r["imbalance"]) and r["threads"] <= CARD_THREADS]
    exhibit.add(_part("figure_3_6", rows, charts.curves({"efficiency": _points(rows, "efficiency")}, "threads p", "efficiency",
                                                        marks=[(15, "matrix fits the caches")])),
                "tentpole model has no result.")
    beyond = [r for r in rows if r["threads"] >= 15]
    if beyond:
        best = max(beyond, key=lambda r: r["efficiency"])
        lowest = min((r for r in rows if r["threads"] < 18), key=lambda r: r["efficiency"])
        exhibit.comparison = [
            ("balanced count of the best efficiency, from 15 on", str(BEST_BALANCED_THREADS),
             str(int(best["threads"])), "modelled"),
            ("last balanced count before the efficiency rises", "below 15", str(int(lowest["threads"])), "modelled")]
    return exhibit


def _host_rates(patches):
    """The most patches per second that the host solves, for each (D, k)."""
    rates = {}
    for b in patches.find("solve_patches"):
        size = b.arguments["D"], b.arguments["k"]
        rates[size] = max(rates.get(size, 0), b["patches/s"])
    return rates


def gpu_patches(results):
    """Whole patches on the GPU against the host of the same machine, for every shape of the launch."""
    exhibit = Exhibit("3.9", "Figure", "Whole patches on the GPU",
                      "Beyond the thesis: patches per second of one launch with all data on the GPU, by the patches of the "
                      "launch, the best of the shapes tried (teams x lanes); and the ratio to the fastest run of the same size "
                      "on this machine's processor.")
    patches = results.file("bench_patch")
    host = _host_rates(patches)
    rows, best = [], {}
    for b in patches.find("device_patches"):
        size, count, rate = (b.arguments["D"], b.arguments["k"]), b.arguments["patches"], b["patches/s"]
        ratio = rate / host[size] if size in host else None
        rows.append([*size, count, b.arguments["teams"], b.arguments["lanes"], number(rate), number(ratio)])
        curve = best.setdefault(f"D = {size[0]}, k = {size[1]}", {})
        curve[count] = max(curve.get(count, 0), rate)
    series = {name: (sorted(curve), [curve[count] for count in sorted(curve)]) for name, curve in best.items()}
    exhibit.add(Part("figure_3_9", "measured", results.source("bench_patch"),
                     ["D", "degree", "patches", "teams", "lanes", "patches/s", "over host"], rows,
                     charts.curves(series, "patches in a launch", "patches/s", logarithmic=True)),
                "bench_patch has no result on a GPU.")
    return exhibit


def device_figures(results):
    shown = [card_figure(results), persistent_figure(results), filtered_figure(results)]
    return shown + ([gpu_patches(results)] if results.has_gpu() else [])
