"""Runs a benchmark driver on its smallest sizes and reads its JSON: it ends with code 0, all its benchmarks ran, and
each one carries the given counters, finite and not negative.

usage: smoke_test.py DRIVER FILTER COUNTER...
"""

import json
import math
import subprocess
import sys
import tempfile


def run(driver, pattern):
    """What the driver wrote with --benchmark_out."""
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        subprocess.run(
            [driver, f"--benchmark_filter={pattern}", "--benchmark_min_time=0.001", f"--benchmark_out={out.name}",
             "--benchmark_out_format=json"],
            check=True, stdout=subprocess.DEVNULL)
        return json.load(open(out.name, encoding="utf-8"))


def main():
    driver, pattern, counters = sys.argv[1], sys.argv[2], sys.argv[3:]
    report = run(driver, pattern)
    for key in ("compiler", "commit", "device"):
        assert report["context"].get(key), f"{driver}: no {key} in the context"
    assert report["benchmarks"], f"{driver}: nothing matches {pattern}"
    for benchmark in report["benchmarks"]:
        assert "error_occurred" not in benchmark, benchmark["name"]
        for counter in counters:
            value = benchmark.get(counter)
            is_fine = value is not None and math.isfinite(value) and value >= 0
            assert is_fine, f"{benchmark['name']}: {counter} = {value}"


main()
