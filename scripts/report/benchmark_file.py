"""Reads result files of Google Benchmark: medians over the repetitions of each benchmark."""
import json
import re
import statistics
from dataclasses import dataclass

SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
FIELD = re.compile(r"^([A-Za-z]+):(\d+)$")


@dataclass
class Benchmark:
    path: list  # the parts of the name that are words: ["assembly", "sequential"]
    arguments: dict  # the others: {"d": 4, "k": 7, "threads": 1}
    seconds: float
    counters: dict

    def __getitem__(self, counter):
        return self.counters.get(counter)


class BenchmarkFile:
    """`context` and the benchmarks of a result of Google Benchmark."""

    def __init__(self, document):
        self.context = document.get("context", {})
        self.benchmarks = list(_medians(document.get("benchmarks", [])))

    @classmethod
    def read(cls, path):
        """The result of a driver in a file; without benchmarks where the file does not exist."""
        return cls(json.loads(path.read_text(encoding="utf-8")) if path.exists() and path.stat().st_size > 0 else {})

    def find(self, *path, **arguments):
        """Benchmarks whose name begins with these words and has these arguments."""
        return [b for b in self.benchmarks if b.path[:len(path)] == list(path)
                and all(b.arguments.get(key) == value for key, value in arguments.items())]

    def first(self, *path, **arguments):
        return next(iter(self.find(*path, **arguments)), None)


def _medians(entries):
    runs = {}
    for entry in entries:
        if entry.get("run_type", "iteration") == "iteration" and not entry.get("error_occurred"):
            runs.setdefault(entry.get("run_name", entry["name"]), []).append(entry)
    for name, repetitions in runs.items():
        words = [part for part in name.split("/") if not FIELD.match(part) and part != "real_time"]
        arguments = {match[1]: int(match[2]) for match in map(FIELD.match, name.split("/")) if match}
        counters = {key: statistics.median(run[key] for run in repetitions if key in run)
                    for key, value in repetitions[0].items() if isinstance(value, (int, float))}
        seconds = statistics.median(run["real_time"] * SECONDS[run.get("time_unit", "ns")] for run in repetitions)
        yield Benchmark(words, arguments, seconds, counters)
