"""What the drivers and the model left in a folder: DRIVER.json and MACHINE_ROWS.csv."""
import csv
import functools

from report.benchmark_file import BenchmarkFile
from report.thesis_numbers import DEGREES, unknowns

DRIVERS = ["bench_profile", "bench_assembly", "bench_threads", "bench_traffic", "bench_lu"]
GPU_DRIVERS = ["bench_patch"]  # only where there is a GPU
MACHINES = {"xeon_phi_knc": "1-120", "xeon_x5680_dual": "1-24"}  # with the thread counts of their sweeps


class Results:
    def __init__(self, folder):
        self.folder = folder

    @functools.lru_cache(maxsize=None)
    def file(self, driver):
        return BenchmarkFile.read(self.folder / f"{driver}.json")

    def has_gpu(self):
        return str(self.file("bench_patch").context.get("device", "")).startswith("GPU")

    def source(self, driver):
        """Driver, compiler and commit of its numbers."""
        context = self.file(driver).context
        details = [context[key] for key in ("compiler", "commit", "device") if context.get(key)]
        return ", ".join([driver, *map(str, details)])

    @functools.lru_cache(maxsize=None)
    def model(self, machine):
        """{degree: rows of the modelled sweep as dictionaries of numbers}, without degrees that were not modelled."""
        sweeps = {}
        for degree in DEGREES:
            path = self.folder / f"{machine}_{unknowns(degree)}.csv"
            if path.exists():
                with open(path, encoding="utf-8") as stream:
                    sweeps[degree] = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(stream)]
        return sweeps

    def machine(self):
        """Lines (what, value) on where the measured numbers come from."""
        context = next((self.file(driver).context for driver in DRIVERS if self.file(driver).context), {})
        wanted = [("cores", "cores"), ("device", "device"), ("compiler", "compiler"),
                  ("commit", "commit"), ("measured", "date"), ("dgemm, one thread [GF/s]", "dgemm_1_GF/s"),
                  ("dgemm, all [GF/s]", "dgemm_all_GF/s"), ("copy, one thread [GB/s]", "copy_1_GB/s"),
                  ("copy, all [GB/s]", "copy_all_GB/s")]
        lines = [(label, str(context[key])) for label, key in wanted if context.get(key)]
        notes = self.folder / "notes.txt"
        noted = [tuple(line.split(": ", 1)) for line in notes.read_text().splitlines()] if notes.exists() else []
        lines = noted[:1] + lines + noted[1:]
        return lines or [("measured", "nothing: no driver has run")]
