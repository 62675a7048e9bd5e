"""Runs the program `tentpole` in a temporary folder; base class of the tests beside this file.

usage of each test: NAME_test.py TENTPOLE SOURCE_FOLDER
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

TENTPOLE, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])

WAVE = """title = "a wave on a ring"
[domain]
dimension = 1
min = [0.0]
max = [1.0]
cells = [20]
[material.all]
density = 1.0
youngs_modulus = 1.0
poisson_ratio = 0.0
[boundary.left]
periodic = "right"
[initial]
displacement = ["sin(2*pi*x)"]
velocity = ["-2*pi*cos(2*pi*x)"]
[time]
end = 0.5
[discretization]
degree = 2
[output]
snapshots = 3
[[output.probe]]
name = "mid"
point = [0.5]
"""


# A run of WAVE with these takes minutes.
LONG = ["--set", "time.end=50", "--set", "output.snapshots=1000", "--set", "domain.cells=[50]",
        "--set", "run.batch_size=16"]


class ProgramTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "wave.toml").write_text(WAVE)

    def tentpole(self, *arguments, exit_code=0):
        """Runs the program to its end and returns (stdout, stderr)."""
        result = subprocess.run([TENTPOLE, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(result.returncode, exit_code, f"{arguments}\n{result.stdout}{result.stderr}")
        return result.stdout, result.stderr

    def start(self, *arguments, out="r", **options):
        """Starts a run of wave.toml with its result in r; it is killed when the test ends."""
        process = subprocess.Popen([TENTPOLE, "run", "wave.toml", *(["--out", out] if out else []), *map(str, arguments)],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)
        for clean_up in (process.stdout.close, process.stderr.close, process.wait, process.kill):
            self.addCleanup(clean_up)  # the last one runs first
        return process

    def wait_for(self, name, folder="r"):
        deadline = time.monotonic() + 60
        while not (self.folder / folder / name).exists():
            self.assertLess(time.monotonic(), deadline, f"{name} did not appear")
            time.sleep(0.005)

    def refused(self, *arguments):
        """Runs the program, which must refuse its input and write nothing; returns stderr."""
        before = self.tree()
        out, err = self.tentpole(*arguments, exit_code=2)
        self.assertEqual(out, "")
        self.assertEqual(self.tree(), before)
        return err

    def tree(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))

    def summary(self, folder):
        return json.loads((self.folder / folder / "summary.json").read_text())

    def table(self, path):
        """Rows of a CSV file as dictionaries of numbers."""
        with open(self.folder / path, encoding="utf-8") as stream:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(stream)]


def main():
    unittest.main(argv=sys.argv[:1])
