"""scripts/gpu_report on canned results of a visit.    usage: gpu_report_test.py SOURCE_FOLDER"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from canned_results import entry

SCRIPT = pathlib.Path(sys.argv[1]).resolve() / "scripts/gpu_report"
COMPARISON = """P and S waves in a square
  mesh    2D, 45000 triangles, shortest edge 0.004 m
running on host
  stage              host   device  host / device
  assembly        9.085 s  0.135 s          67.3
  solution        1 min 05 s  0.152 s       430
  total           1 min 15 s  0.993 s        75.5
traffic
  3.3 MB to the device, 3.1 MB back, 34 launches
largest relative difference of the solutions
  3e-14 (velocity); 7 of 34,560 numbers are the same bit for bit"""
OUTPUTS = {"machine": ("0", 0.3, "date: 2026-12-01 10:00\nprocessor: EPYC, 16 threads of hardware\ngpu: NVIDIA H100 80GB HBM3, 580.1\n"
                                 "| NVIDIA-SMI table |"),
           "devices": ("0", 2.0, "0  GPU (nvptx64 image)"),
           "kernels": ("4", 12.5, "expected 1, found 2 at patch 17"),
           "launch_2d": ("0", 9.0, COMPARISON),
           "compare_1d": ("1", 1.0, "no device"),
           "patches_D2k3": ("0", 20.0, "measured"),
           "ncu": ("skipped", 0, ""),
           "memcheck": ("absent", 0, "needs a GPU and compute-sanitizer"),
           "lu": ("124", 40.0, "stopped")}


def patches(kind, size, rate, **arguments):
    name = f"{kind}/{size}/" + "/".join(f"{key}:{value}" for key, value in arguments.items())
    return entry(name, 5.0, **{"patches/s": rate})


BENCHMARKS = {"patches_D2k3": [patches("device_patches", "D:2/k:3", 41800, patches=1024, teams=1056, lanes=32),
                               patches("device_patches", "D:2/k:3", 228000, patches=4096, teams=1056, lanes=32),
                               patches("device_patches", "D:2/k:3", 229000, patches=4096, teams=2112, lanes=32),
                               dict(patches("device_patches", "D:2/k:3", 9e9, patches=4096, teams=2112, lanes=64),
                                    error_occurred=True, error_message="residual 3")],
              "host_D2k3": [patches("solve_patches", "D:2/k:3", 11400, patches=1024, threads=2)],
              "lu": [entry("lu/lapack/d:3/k:3/K:1/threads:1/manual_time", 0.014, N=40, error=3.2e-16, **{"GF/s": 5.5})]}
PROFILE = {"traceEvents": [{"name": "Total Kernel Target", "dur": 24800, "args": {"count": 4}}, {"name": "Kernel Target", "dur": 1}]}
IMAGE = {"architecture": "sm_90", "faults": [], "kernels": [{"kernel": "patches, D = 2", "registers": 128, "stack": 1560, "shared": 1044,
                                                            "mode": "SPMD", "heap_calls": 0}]}


class GpuReport(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        write = lambda name, text: (self.folder / name).write_text(text)
        write("steps.tsv", "".join(f"{name}\t{code}\t{seconds}\n" for name, (code, seconds, _) in OUTPUTS.items()))
        write("log.txt", "".join(f"=== {name} ({code}, {seconds} s)\n{text}\n" for name, (code, seconds, text) in OUTPUTS.items()))
        write("bundle.txt", "commit: abc1234\nimage: nvptx\ncompiler: clang++-19\n")
        write("benchmarks.json", json.dumps({step: {"context": {"device": "GPU", "dgemm_1_GF/s": "40"}, "benchmarks": entries}
                                             for step, entries in BENCHMARKS.items()}))
        write("profile.json", json.dumps(PROFILE))
        write("image.json", json.dumps(IMAGE))

    def page(self, exit_code=0):
        result = subprocess.run([sys.executable, "-B", SCRIPT, self.folder, "-o", self.folder / "page.md"], capture_output=True, text=True)
        self.assertEqual(result.returncode, exit_code, result.stderr)
        return (self.folder / "page.md").read_text() if exit_code == 0 else result.stderr

    def sections(self):
        parts = self.page().split("\n## ")
        return {"": parts[0], **{part.split("\n")[0]: part for part in parts[1:]}}

    def test_head_names_day_gpu_commit_and_counts(self):
        head = self.sections()[""]
        self.assertIn("# 2026-12-01, visit to NVIDIA H100 80GB HBM3\n", head)
        self.assertIn("Commit abc1234, image nvptx, clang++-19. 7 steps ran, 3 failed, 1 skipped for want of time, 1 not possible", head)

    def test_failures_come_first_and_in_full(self):
        sections = self.sections()
        self.assertEqual(list(sections)[1], "Failures")
        for text in ("`kernels`: exit code 4 after 12.5 s.", "expected 1, found 2 at patch 17", "`compare_1d`: exit code 1",
                     "`lu`: exit code 124 after 40.0 s (stopped at its limit)", "lanes:64/real_time ended with an error: residual 3"):
            self.assertIn(text, sections["Failures"])

    def test_what_is_missing_is_said(self):
        missing = self.sections()["Missing"]
        self.assertIn("- `ncu`: no time was left\n- `memcheck`: needs a GPU and compute-sanitizer", missing)
        for name in ("profile.json", "image.json", "log.txt"):
            (self.folder / name).unlink()
        (self.folder / "benchmarks.json").write_text('{"patches')
        sections = self.sections()
        for text in ("profile.json is not there", "image.json is not there", "log.txt is not there", "benchmarks.json cannot be read"):
            self.assertIn(text, sections["Missing"])
        self.assertIn("D = 2, k = 3: not measured.", sections["Patches per second"])
        self.assertIn("No figures of the kernels.", sections["The image"])

    def test_sweep_has_lanes_teams_and_batches_and_marks_the_best(self):
        sweep = self.sections()["Patches per second"]
        self.assertIn("| lanes | teams | 1024 | 4096 |\n|---|---:|---:|---:|\n| 32 | 1056 | 41 800 | 228 000 |\n| 32 | 2112 | - | **229 000** |",
                      sweep)
        self.assertNotIn("| 64 |", sweep)
        self.assertIn("D = 3, k = 3: not measured.", sweep)

    def test_best_is_set_against_the_host_of_the_same_machine(self):
        ratios = self.sections()["Device against host, patches alone"]
        self.assertIn("| 2, 3 | 229 000 | 4096, 2112, 32 | 11 400 | 1024, 2 | 20.1 |", ratios)
        self.assertIn("| 3, 2 | - | - | - | - | - |", ratios)

    def test_whole_runs_have_stages_and_difference(self):
        runs = self.sections()["Device against host, whole runs"]
        self.assertIn("| `launch_2d` | 1 min 15 s | 0.993 s | 75.5 | 0.135 s, 0.152 s, - | 3e-14 (velocity); 7 of 34,560", runs)
        self.assertIn("| solution | 1 min 05 s | 0.152 s | 430 |", runs)
        self.assertIn("| `compare_1d` | - | - | - | - | did not end (exit code 1) |", runs)

    def test_drivers_trace_and_image_have_tables(self):
        sections = self.sections()
        self.assertIn("| lu/lapack/d:3/k:3/K:1/threads:1 | 0.014 | 40 | 5.5 | 3.2e-16 |", sections["LU of a patch"])
        self.assertIn("| Kernel Target | 4 | 24.8 |", sections["Where the time goes"])
        self.assertIn("| patches, D = 2 | 128 | 1560 | 1044 | SPMD | 0 |", sections["The image"])
        self.assertIn("dgemm_1_GF/s 40", sections["Machine"])

    def test_other_folders_are_refused(self):
        (self.folder / "steps.tsv").unlink()
        self.assertIn("has no steps.tsv. Give the folder that gpu_visit wrote", self.page(2))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
