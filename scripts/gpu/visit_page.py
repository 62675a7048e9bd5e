"""The page of a visit in Markdown. Every number comes from its files; what they lack is said."""
from gpu.visit_results import comparison

SIZES = [(2, 2), (2, 3), (3, 2), (3, 3)]  # D, k of the sweeps
STOPPED = ("124", "137", "143")
# What the steps are, by the beginning of their names; the longest one counts.
MEANING = {"machine": "processor, memory, GPU, driver", "unpack": "the archive", "devices": "what the OpenMP runtime sees, with copy rates",
           "devices_layout": "the same, images loaded in the layout of CUDA 13",
           "kernels": "tests of all kernels on the device", "launch_": "whole run on host and device, launches as large as a GPU takes",
           "device_tests": "tests of memory and copies", "traffic_tests": "counted bytes and launches against those of the runtime",
           "patches_": "sweep over batch and teams, one warp a team", "more_patches_": "the same with more lanes a team",
           "host_": "the largest batch on the host", "compare_": "an example on host and device", "profile": "trace of the offload runtime",
           "ncu": "Nsight Compute, one launch", "memcheck": "compute-sanitizer", "synccheck": "compute-sanitizer",
           "traffic": "100 updates of a cell matrix", "threads": "threads over patches", "lu": "LU of a patch, on the host"}


def page(results):
    sections = [("Failures", _failures), ("Missing", _missing), ("Machine", _machine), ("Steps", _steps),
                ("Patches per second", _sweeps), ("Device against host, patches alone", _ratios),
                ("Device against host, whole runs", _runs), ("Traffic", _traffic), ("Threads over patches", _threads),
                ("LU of a patch", _lu), ("Where the time goes", _profile), ("The image", _image)]
    parts = [_head(results)]
    for title, section in sections:
        parts.append(f"## {title}\n\n{section(results).strip()}\n")
    return "\n".join(parts)


def table(header, rows):
    """Markdown; the first column is text, the others are numbers."""
    lines = ["| " + " | ".join(header) + " |", "|---|" + "---:|" * (len(header) - 1)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def number(value, digits=3):
    """With that many digits, and thousands apart: 41 800, 0.0123; a dash for nothing."""
    if value is None:
        return "-"
    text = f"{float(f'{value:.{digits}g}'):.{digits}g}"
    return f"{float(text):,.0f}".replace(",", " ") if "e+" in text or abs(value) >= 10**digits else text


def _verbatim(text):
    return f"```text\n{text}\n```\n"


def _head(results):
    machine, bundle = results.machine(), results.bundle
    ran = [step for step in results.steps if step.code not in ("skipped", "absent")]
    counts = {what: sum(step.code == what for step in results.steps) for what in ("skipped", "absent")}
    device = "the virtual device, a rehearsal" if bundle.get("image") == "virtual" else machine.get("gpu", "GPU unknown").split(",")[0]
    return (f"# {machine.get('date', 'date unknown')[:10]}, visit to {device}\n\n"
            f"Commit {bundle.get('commit', 'unknown')}, image {bundle.get('image', 'unknown')}, {bundle.get('compiler', 'compiler unknown')}. "
            f"{len(ran)} steps ran, {sum(step.failed for step in ran)} failed, {counts['skipped']} skipped for want of time, "
            f"{counts['absent']} not possible here. Written by `scripts/gpu_report` from the files of `scripts/gpu_visit`, one run; "
            "what is not in them is not here.\n")


def _failures(results):
    parts = [f"`{step.name}`: exit code {step.code} after {step.seconds} s"
             f"{' (stopped at its limit)' if step.code in STOPPED else ''}.\n\n{_verbatim(step.output or '(no output)')}"
             for step in results.steps if step.failed]
    parts += [f"`{step}`: {name} ended with an error: {message or 'no message'}.\n" for step, name, message in results.errors]
    return "\n".join(parts) or "None: every step that ran had exit code 0."


def _missing(results):
    lines = list(results.missing)
    for code, reason in (("skipped", "no time was left"), ("absent", "")):
        for step in results.steps:
            if step.code == code:
                lines.append(f"`{step.name}`: {reason or step.output or 'machine or bundle lack what it needs'}")
    return "\n".join(f"- {line}" for line in lines) or "Nothing."


def _machine(results):
    parts = [_verbatim(step.output) for step in map(results.step, ("machine", "devices", "devices_layout")) if step and step.output]
    contexts = [(name, file.context) for name, file in results.benchmarks.items() if file.context.get("device")]
    if contexts:
        name, context = contexts[0]
        keys = ("dgemm_1_GF/s", "dgemm_all_GF/s", "copy_1_GB/s", "copy_all_GB/s")
        parts.append(f"The host measured itself in step `{name}`: " + ", ".join(f"{key} {context.get(key, '-')}" for key in keys) + ".\n")
    return "\n".join(parts) or "No description."


def _steps(results):
    rows = []
    for step in results.steps:
        prefix = max((prefix for prefix in MEANING if step.name.startswith(prefix)), key=len, default=None)
        ran = step.code not in ("skipped", "absent")
        rows.append((f"`{step.name}`", step.code, step.seconds if ran else "-", MEANING.get(prefix, "-")))
    return table(("step", "exit code", "seconds", "what"), rows)


def _patches(results, kind, dimension, degree):
    """Benchmarks of device_patches or solve_patches of one size, of all steps."""
    return [benchmark for file in results.benchmarks.values() for benchmark in file.find(kind, D=dimension, k=degree)
            if benchmark["patches/s"]]


def _best(benchmarks):
    return max(benchmarks, key=lambda benchmark: benchmark["patches/s"], default=None)


def _sweeps(results):
    parts = []
    for dimension, degree in SIZES:
        found = _patches(results, "device_patches", dimension, degree)
        if not found:
            parts.append(f"D = {dimension}, k = {degree}: not measured.\n")
            continue
        best = _best(found)
        batches = sorted({benchmark.arguments["patches"] for benchmark in found})
        shapes = sorted({(benchmark.arguments.get("lanes", 1), benchmark.arguments.get("teams", 1)) for benchmark in found})
        cells = {(b.arguments.get("lanes", 1), b.arguments.get("teams", 1), b.arguments["patches"]): b for b in found}
        rows = []
        for lanes, teams in shapes:
            rates = [cells.get((lanes, teams, batch)) for batch in batches]
            rows.append((lanes, teams, *("-" if b is None else f"**{number(b['patches/s'])}**" if b is best else number(b["patches/s"])
                                         for b in rates)))
        parts.append(f"D = {dimension}, k = {degree}, by lanes of a team, teams and patches of a batch:\n\n" +
                     table(("lanes", "teams", *(f"{batch}" for batch in batches)), rows))
    return "\n".join(parts)


def _ratios(results):
    rows = []
    for dimension, degree in SIZES:
        device, host = (_best(_patches(results, kind, dimension, degree)) for kind in ("device_patches", "solve_patches"))
        ratio = number(device["patches/s"] / host["patches/s"]) if device and host else "-"
        rows.append((f"{dimension}, {degree}", number(device and device["patches/s"]),
                     "{patches}, {teams}, {lanes}".format(**device.arguments) if device else "-", number(host and host["patches/s"]),
                     "{patches}, {threads}".format(**host.arguments) if host else "-", ratio))
    return ("Best of each, in patches per second; the host with the numbers of threads that the driver offers, which need not be all of its "
            "cores.\n\n" + table(("D, k", "device", "patches, teams, lanes", "host", "patches, threads", "device / host"), rows))


def _runs(results):
    rows, parts = [], []
    for step in results.steps:
        if not step.name.startswith(("launch_", "compare_")) or step.code in ("skipped", "absent"):
            continue
        run = comparison(step.output)
        if run is None:
            rows.append((f"`{step.name}`", "-", "-", "-", "-", f"did not end (exit code {step.code})"))
            continue
        solved = [run.stages.get(stage, ("-", "-"))[1] for stage in ("assembly", "solution", "transfer")]
        difference = run.difference if step.code == "0" else f"{run.difference} (exit code {step.code})"
        rows.append((f"`{step.name}`", *run.stages["total"], ", ".join(solved), difference))
        stages = table(("stage", "host", "device", "host / device"), [(stage, *cells) for stage, cells in run.stages.items()])
        parts.append(f"`{step.name}`: {run.title}; {run.mesh}.\n\n{stages}")
    if not rows:
        return "No whole run."
    header = ("step", "host", "device", "host / device", "assembly, solution, transfer on the device", "largest relative difference")
    return table(header, rows) + "\n" + "\n".join(parts)


def _words(benchmark):
    """Of its name, without the clock that Google Benchmark adds."""
    return [word for word in benchmark.path if word not in ("manual_time", "real_time")]


def _driver_table(results, step, columns):
    """All benchmarks of a step: its name, time and those counters."""
    file = results.benchmarks.get(step)
    if file is None or not file.benchmarks:
        return "Not measured."
    rows = [("/".join([*_words(b), *(f"{key}:{value}" for key, value in b.arguments.items())]), number(1e3 * b.seconds),
             *(number(b[column], digits) for column, digits in columns)) for b in file.benchmarks]
    return table(("benchmark", "ms", *(column for column, _ in columns)), rows)


def _traffic(results):
    return _driver_table(results, "traffic", [("bytes_up", 4), ("bytes_down", 4), ("launches", 4), ("transfer_%", 3)])


def _threads(results):
    return _driver_table(results, "threads", [("patches/s", 3), ("speedup", 3)])


def _lu(results):
    return "On the host.\n\n" + _driver_table(results, "lu", [("N", 4), ("GF/s", 3), ("error", 2)])


def _profile(results):
    totals = [event for event in results.profile.get("traceEvents", []) if event.get("name", "").startswith("Total ")]
    parts = []
    if totals:
        totals.sort(key=lambda event: -event["dur"])
        rows = [(event["name"].removeprefix("Total "), event.get("args", {}).get("count", "-"), number(event["dur"] / 1e3))
                for event in totals[:12]]
        parts.append("Of the offload runtime, in step `profile`, with whatever it contains:\n\n" + table(("what", "count", "ms"), rows))
    else:
        parts.append("No trace of the offload runtime.\n")
    for name, title in (("ncu", "Nsight Compute, one launch of the patch kernel"), ("memcheck", "compute-sanitizer, memory"),
                        ("synccheck", "compute-sanitizer, barriers")):
        step = results.step(name)
        if step and step.code == "0":
            parts.append(f"{title}:\n\n{_verbatim(step.output)}")
        else:
            parts.append(f"{title}: no result.\n")
    return "\n".join(parts)


def _image(results):
    if not results.image.get("kernels"):
        return "No figures of the kernels."
    rows = [(kernel["kernel"], kernel["registers"], kernel["stack"], kernel["shared"], kernel["mode"], kernel["heap_calls"])
            for kernel in results.image["kernels"]]
    faults = results.image.get("faults", [])
    return table(("kernel", "registers", "stack [B]", "shared [B]", "mode", "heap calls"), rows) + "\n" + (
        "\n".join(faults) or f"No faults, for {results.image.get('architecture') or 'an unknown architecture'}.")
