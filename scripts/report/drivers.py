"""Runs the drivers and the model into the folder that results.py reads."""
import os
import subprocess
import time

from report.results import DRIVERS, MACHINES
from report.thesis_numbers import DEGREES, unknowns

# --quick: fewer degrees and short measurements; the regular expressions are Google Benchmark's filters.
QUICK_FILTER = {
    "bench_profile": r"k:[1-3]/",
    "bench_assembly": r"d:4/k:[1-4]/",
    "bench_threads": r"rows/d:4/k:[3-7]/",
    "bench_traffic": r"d:4",
    "bench_lu": r"d:4/k:[1-3]/",
}
FULL_FILTER = {"bench_assembly": r"d:4/", "bench_threads": r"rows/", "bench_lu": r"d:4/"}
MINIMAL_TIME = {True: "0.02", False: "0.2"}
LIMIT = {True: 45, False: 400}  # seconds of one driver


def _command(program, output, quick):
    filters = QUICK_FILTER if quick else FULL_FILTER
    command = [program, f"--benchmark_out={output}", "--benchmark_out_format=json",
               f"--benchmark_min_time={MINIMAL_TIME[quick]}"]
    chosen = filters.get(program.name)
    return command + ([f"--benchmark_filter={chosen}"] if chosen else [])


def run_drivers(build, folder, quick):
    """Runs each driver that the build has; says which are missing, failed or were stopped, and goes on without them."""
    environment = dict(os.environ, OMP_WAIT_POLICY=os.environ.get("OMP_WAIT_POLICY", "passive"))
    for driver in DRIVERS:
        output, program = folder / f"{driver}.json", build / "bench" / driver
        output.unlink(missing_ok=True)
        if not program.exists():
            print(f"{driver}: {program} is not built; its tables and figures stay empty")
            continue
        start = time.monotonic()
        with open(folder / f"{driver}.log", "w", encoding="utf-8") as log:
            code = _run(_command(program, output, quick), environment, log, LIMIT[quick])
        if code != 0:
            output.unlink(missing_ok=True)
            print(f"{driver}: {code}, see {folder / driver}.log; its tables and figures stay empty")
        print(f"{driver}: {time.monotonic() - start:.0f} s")


def _run(command, environment, log, limit):
    """Exit code, or what stopped the program."""
    try:
        return subprocess.run(command, env=environment, stdout=log, stderr=subprocess.STDOUT, timeout=limit).returncode
    except subprocess.TimeoutExpired:
        return f"stopped after {limit} s"


def run_model(tentpole, folder):
    for machine, threads in MACHINES.items():
        for degree in DEGREES:
            rows = unknowns(degree)
            sweep = subprocess.run([tentpole, "model", f"{machine}.toml", "--rows", str(rows), "--threads", threads],
                                   stdout=subprocess.PIPE, text=True, check=True).stdout
            (folder / f"{machine}_{rows}.csv").write_text(sweep, encoding="utf-8")
