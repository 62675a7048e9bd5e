"""Runs the drivers and the model into the folder that results.py reads."""
import json
import os
import subprocess
import time

from report.results import DRIVERS, GPU_DRIVERS, MACHINES
from report.thesis_numbers import DEGREES, unknowns

# Google Benchmark's filters. --quick has fewer degrees; the whole run leaves out what the report does not show.
QUICK_FILTER = {
    "bench_profile": r"k:4/",
    "bench_assembly": r"d:4/k:[1-4]/",
    "bench_threads": r"rows/d:4/k:[57]/",
    "bench_traffic": r"d:4/k:",
    "bench_lu": r"d:4/k:[23]/K:[24]/",
    "bench_patch": r"device_patches/D:(2/k:[23]|3/k:2)/patches:4096/|solve_patches/D:(2/k:[23]/patches:256|3/k:2/patches:64)/",
}
FULL_FILTER = {
    "bench_profile": r"k:[57]/",
    "bench_assembly": r"d:4/",
    "bench_threads": r"rows/",
    "bench_traffic": r"d:4",
    "bench_lu": r"d:4/k:[1-7]/K:[24]/",
    "bench_patch": r"device_patches/D:[23]/k:[23]/|solve_patches/D:[23]/k:[23]/patches:(64|256|1024)/",
}
MINIMAL_TIME = {True: "0.02", False: "0.2"}
# Seconds after which a driver is stopped; what it has measured by then is kept. On a quiet machine they take less.
QUICK_LIMIT = {"bench_profile": 20, "bench_assembly": 30, "bench_threads": 40, "bench_traffic": 35, "bench_lu": 35,
               "bench_patch": 60}
FULL_LIMIT = {"bench_profile": 250, "bench_assembly": 400, "bench_threads": 150, "bench_traffic": 100, "bench_lu": 200,
              "bench_patch": 200}


def _command(program, output, quick):
    filters = QUICK_FILTER if quick else FULL_FILTER
    return [program, f"--benchmark_out={output}", "--benchmark_out_format=json", f"--benchmark_filter={filters[program.name]}",
            f"--benchmark_min_time={MINIMAL_TIME[quick]}"]


def processor_name():
    """Model of the processor as Linux reports it."""
    with open("/proc/cpuinfo", encoding="utf-8") as stream:
        names = [line.split(":", 1)[1].strip() for line in stream if line.startswith("model name")]
    return names[0] if names else "unknown"


def has_gpu(tentpole):
    """Whether the program's devices include a GPU."""
    devices = subprocess.run([tentpole, "devices"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
    return "GPU (nvptx64 image)" in devices.stdout


def run_drivers(build, folder, quick):
    """Runs each driver that the build has; keeps notes for the report: the processor, and drivers missing,
    failed or stopped."""
    environment = dict(os.environ, OMP_WAIT_POLICY=os.environ.get("OMP_WAIT_POLICY", "passive"))
    notes = [f"processor: {processor_name()}\n"]
    for driver in DRIVERS + (GPU_DRIVERS if has_gpu(build / "tentpole") else []):
        start = time.monotonic()
        note = _run_driver(build / "bench" / driver, folder, quick, environment)
        print(f"{driver}: {time.monotonic() - start:.0f} s{', ' + note if note else ''}")
        notes += [f"{driver}: {note}\n"] if note else []
    (folder / "notes.txt").write_text("".join(notes), encoding="utf-8")


def _run_driver(program, folder, quick, environment):
    """Leaves DRIVER.json and DRIVER.log; returns what went wrong, or nothing."""
    output = folder / f"{program.name}.json"
    output.unlink(missing_ok=True)
    if not program.exists():
        return "is not built"
    limit = (QUICK_LIMIT if quick else FULL_LIMIT)[program.name]
    with open(folder / f"{program.name}.log", "w", encoding="utf-8") as log:
        try:
            code = subprocess.run(_command(program, output, quick), env=environment, stdout=log, stderr=subprocess.STDOUT,
                                  timeout=limit).returncode
        except subprocess.TimeoutExpired:
            return f"stopped after {limit} s, {close_file(output)} benchmarks kept"
    if code != 0:
        output.unlink(missing_ok=True)
        return f"exit code {code}, see {program.name}.log; nothing of it is shown"
    return ""


def close_file(output):
    """Makes the file of a stopped driver complete: its last benchmark ends the list. Returns the number of benchmarks."""
    text = output.read_text(encoding="utf-8") if output.exists() else ""
    end = text.rfind("\n    }")
    if end < 0:
        output.unlink(missing_ok=True)
        return 0
    output.write_text(text[:end] + "\n    }\n  ]\n}\n", encoding="utf-8")
    return len(json.loads(output.read_text(encoding="utf-8"))["benchmarks"])


def run_model(tentpole, folder):
    for machine, threads in MACHINES.items():
        for degree in DEGREES:
            rows = unknowns(degree)
            sweep = subprocess.run([tentpole, "model", f"{machine}.toml", "--rows", str(rows), "--threads", threads],
                                   stdout=subprocess.PIPE, text=True, check=True).stdout
            (folder / f"{machine}_{rows}.csv").write_text(sweep, encoding="utf-8")
