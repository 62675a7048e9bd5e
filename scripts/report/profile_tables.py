"""Tables 3.1 to 3.5: where the time of assembly, solution and post-processing goes."""
from report import charts
from report.exhibit import Exhibit, Part, number
from report.thesis_numbers import PROFILE_NOTE, PROFILES, STAGES

OURS = ["offload_persistent", "ours"]


def _chosen(profile, stages):
    """The benchmark of the largest problem, with the most threads up to the number of cores."""
    cores = int(profile.context.get("cores", 0) or 0)
    found = [b for b in profile.find("profile", stages) if not cores or b.arguments["threads"] <= cores]
    return max(found, key=lambda b: (b.arguments.get("d", 0), b.arguments["k"], b.arguments["threads"]), default=None)


def _percent(benchmark):
    return [benchmark[f"{stage}_%"] for stage in STAGES]


def _rows(benchmark):
    return [[stage, number(benchmark[f"{stage}_%"], 4), number(benchmark[f"{stage}_s"])] for stage in STAGES]


def _problem(benchmark):
    return ", ".join(f"{key} = {value}" for key, value in benchmark.arguments.items())


def thesis_tables(profile, source):
    for table, (stages, percent, label) in PROFILES.items():
        benchmark = _chosen(profile, stages)
        exhibit = Exhibit(table, "Table", f"Time profile, {label}",
                          "Share of assembly, solution and post-processing in the time of the physics code. The thesis does "
                          "not state its patch size or number of quadrature points, so the problems differ. " +
                          PROFILE_NOTE.get(table, ""))
        values = _percent(benchmark) if benchmark else [None] * 3
        exhibit.comparison = [(f"{stage} [%]", number(theirs, 4), number(ours, 4), "measured")
                              for stage, theirs, ours in zip(STAGES, percent, values)]
        bars = {"thesis": percent, "here": values}
        exhibit.add(Part(exhibit.name, "measured", source + (f"; {_problem(benchmark)}" if benchmark else ""),
                         ["stage", "percent", "seconds"], _rows(benchmark) if benchmark else [],
                         charts.shares(bars, STAGES)), f"the profile driver has no result for {stages}.")
        yield exhibit


def announced_table(profile, source):
    """Table 3.5 is in the thesis's list only; ours shows what the project itself does."""
    exhibit = Exhibit("3.5", "Table", "Time profile of this project's own rungs",
                      "The thesis announces a profile with a threaded solution; its source ends before the table, so there is "
                      "nothing to compare with. Shown instead: assembly on the device with persistent data, and this "
                      "project's condensed assembly and solution.")
    bars, rows = {}, []
    for stages in OURS:
        benchmark = _chosen(profile, stages)
        if benchmark:
            bars[stages.replace("_", " ")] = _percent(benchmark)
            rows += [[stages, _problem(benchmark), *row] for row in _rows(benchmark)]
    exhibit.comparison = [(f"{label}, {stage} [%]", "–", number(value, 4), "measured")
                          for label, values in bars.items() for stage, value in zip(STAGES, values)]
    exhibit.add(Part(exhibit.name, "measured", source, ["stages", "problem", "stage", "percent", "seconds"], rows,
                     charts.shares(bars, STAGES)), "the profile driver has no result for them.")
    return exhibit


def profile_tables(results):
    profile, source = results.file("bench_profile"), results.source("bench_profile")
    return [*thesis_tables(profile, source), announced_table(profile, source)]
