"""The memory that `check` announces is what a run takes at its peak."""
import os
import re
import subprocess

from program import TENTPOLE, ProgramTest, main

SIDES = ("left", "right", "bottom", "top", "back", "front")
UNITS = {"B": 1, "kB": 1e3, "MB": 1e6, "GB": 1e9}


def case(dimension, cells, adaptive):
    zeros, ones = [0.0] * dimension, [1.0] * dimension
    text = (f"[domain]\ndimension = {dimension}\nmin = {zeros}\nmax = {ones}\ncells = {[cells] * dimension}\n"
            "[material.all]\ndensity = 1.0\nyoungs_modulus = 1.0\npoisson_ratio = 0.0\n")
    for side in SIDES[:2 * dimension]:
        text += f"[boundary.{side}]\nabsorbing = true\n"
    text += f"[time]\nend = {0.01 / cells}\n[discretization]\ndegree = 2\n[output]\nsnapshots = 0\n"
    text += f"history_interval = {0.01 / cells}\n"
    if adaptive:
        text += "[adaptivity]\nenabled = true\nerror_tolerance = 1.0\nmin_size = 1e-3\ncoarsening = 0\n"
    return text


class Memory(ProgramTest):
    def peak(self, *arguments):
        """Largest resident memory of the program [bytes], and what it prints."""
        with subprocess.Popen([TENTPOLE, *arguments], cwd=self.folder, stdout=subprocess.PIPE, text=True) as process:
            out = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        return 1024 * usage.ru_maxrss, out

    def announced(self, out):
        number, unit = re.search(r"about ([0-9.]+) (\w+) in all", out).groups()
        return float(number) * UNITS[unit]

    def test_peak_is_announced(self):
        # of few and of many cells, so that what the program and a batch take drops out
        for dimension, few, many, adaptive in ((1, 5000, 60000, False), (1, 5000, 40000, True), (2, 40, 110, False),
                                               (2, 40, 100, True), (3, 6, 13, False)):
            with self.subTest(dimension=dimension, adaptive=adaptive):
                peaks, said = [], []
                for cells in (few, many):
                    (self.folder / "case.toml").write_text(case(dimension, cells, adaptive))
                    memory, out = self.peak("check", "case.toml", "--threads", "1")
                    ran, _ = self.peak("run", "case.toml", "--threads", "1", "--quiet", "--out", f"r{cells}")
                    peaks.append(max(memory, ran))
                    said.append(self.announced(out))
                measured, announced = peaks[1] - peaks[0], said[1] - said[0]
                self.assertGreater(announced, 0.75 * measured)
                self.assertLess(announced, 2.5 * measured)


if __name__ == "__main__":
    main()
