"""scripts/gpu_visit with programs that only pretend.    usage: gpu_visit_test.py SOURCE_FOLDER"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

VISIT = pathlib.Path(sys.argv[1]).resolve() / "scripts/gpu_visit"
PROGRAMS = ("tentpole", "kernels_tests", "tentpole_device_tests", "tentpole_traffic_tests", "bench_patch", "bench_lu", "bench_threads",
            "bench_traffic")
# Every program writes its arguments, and does what FAKE says for it: "PROGRAM SHELL-COMMANDS" a line.
PROGRAM = '''#!/bin/sh
name=${0##*/}
echo "$name $*"
[ "$1" = devices ] && echo "$FAKE_DEVICE"
case $* in
  *--benchmark_list_tests*) cat_names "$name"; exit 0 ;;
esac
for argument; do
  case $argument in --benchmark_out=*) printf '{\\n  "context": {\\n  },\\n  "benchmarks": [\\n    {\\n      "name": "a"\\n    }' >"${argument#*=}" ;; esac
done
eval "$(printf '%s\\n' "$FAKE" | while read -r program commands; do [ "$program" = "$name" ] && echo "$commands"; done)"
for argument; do
  case $argument in --benchmark_out=*) printf '\\n  ]\\n}\\n' >>"${argument#*=}" ;; esac
done
exit 0
'''
NAMES = {"bench_patch": ["device_patches/D:2/k:2/patches:64/teams:2/lanes:1/real_time",
                         "device_patches/D:2/k:2/patches:4096/teams:2/lanes:1/real_time",
                         "device_patches/D:2/k:2/patches:64/teams:2/lanes:64/real_time",
                         "solve_patches/D:2/k:2/patches:1/threads:2/real_time", "solve_patches/D:2/k:2/patches:4/threads:1/real_time",
                         "solve_patches/D:2/k:2/patches:4/threads:2/real_time"],
         "bench_lu": ["lu/lapack/d:3/k:3/K:1/threads:1/manual_time"]}


def pack(folder, image, shared=()):
    """gpu_bundle.tar.xz with the pretenders, and files of these names in share/."""
    listing = "cat_names() {\n  case $1 in\n" + "".join(
        f"    {driver}) printf '%s\\n' {' '.join(names)} ;;\n" for driver, names in NAMES.items()) + "  esac\n}\n"
    bundle = folder / "gpu_bundle"
    for name in ("bin", "libexec", "lib", "share"):
        (bundle / name).mkdir(parents=True)
    for name in PROGRAMS:
        (bundle / "bin" / name).write_text(PROGRAM.replace("\n", "\n" + listing, 1))
        (bundle / "bin" / name).chmod(0o755)
    (bundle / "share/bundle.txt").write_text(f"commit: abc1234\nimage: {image}\n")
    for name in shared:
        (bundle / "share" / name).write_text(name)
    with tarfile.open(folder / "gpu_bundle.tar.xz", "w:xz") as archive:
        archive.add(bundle, "gpu_bundle")
    shutil.rmtree(bundle)
    shutil.copy(VISIT, folder)


def folder_of(programs, folder):
    """A folder with links to these programs alone, for PATH; None where one is missing."""
    folder.mkdir()
    for program in programs:
        path = sys.executable if program == "python3" else shutil.which(program)
        if not path:
            return None
        (folder / program).symlink_to(os.path.realpath(path))
    return folder


class GpuVisit(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.environment = {"PATH": os.environ["PATH"], "TMPDIR": temporary.name, "FAKE_DEVICE": "0  virtual device"}

    def shorten(self, call):
        """Gives this call of a step one second."""
        if not (self.folder / "gpu_visit").exists():
            pack(self.folder, "virtual")
        text = VISIT.read_text()
        self.assertIn(call, text)
        (self.folder / "gpu_visit").write_text(text.replace(call, call.rpartition(" ")[0] + " 1"))

    def visit(self, exit_code=0, seconds=60, image="virtual", **environment):
        """{step: (exit code, seconds)}; self.output is what the visit printed."""
        if not (self.folder / "gpu_visit").exists():
            pack(self.folder, image)
        result = subprocess.run([shutil.which("bash"), "gpu_visit", str(seconds)], cwd=self.folder, capture_output=True, text=True,
                                env={**self.environment, **environment})
        self.output = result.stdout + result.stderr
        self.assertEqual(result.returncode, exit_code, self.output)
        rows = [line.split("\t") for line in (self.folder / "gpu_out/steps.tsv").read_text().splitlines()]
        self.assertEqual(list(self.folder.glob("gpu_visit.*")), [], "the visit leaves its temporary folder")
        return {row[0]: (row[1], float(row[2])) for row in rows}

    def log(self):
        return (self.folder / "gpu_out/log.txt").read_text()

    def test_all_steps_run_in_order_with_small_sizes_and_results_are_written(self):
        steps = self.visit()
        codes = {name: code for name, (code, _) in steps.items()}
        self.assertEqual(list(codes)[:4], ["machine", "unpack", "devices", "kernels"])
        for name in ("patches_D2k2", "host_D2k2", "compare_spall", "profile", "lu"):
            self.assertEqual(codes[name], "0")
        for name in ("patches_D3k3", "more_patches_D2k3", "ncu", "memcheck", "traffic"):
            self.assertEqual(codes[name], "absent")
        self.assertIn("0 failed, 0 were skipped", self.output)
        self.assertEqual((self.folder / "gpu_out/bundle.txt").read_text(), "commit: abc1234\nimage: virtual\n")
        results = json.loads((self.folder / "gpu_out/benchmarks.json").read_text())
        self.assertEqual(list(results), ["patches_D2k2", "host_D2k2", "more_patches_D2k2", "lu"])
        # A rehearsal is small, and the host takes the largest of its batches.
        self.assertIn("--benchmark_filter=^(device_patches/D:2/k:2/patches:64/teams:2/lanes:1/real_time)$", self.log())
        self.assertIn("^(solve_patches/D:2/k:2/patches:4/threads:1/real_time|solve_patches/D:2/k:2/patches:4/threads:2/real_time)$",
                      self.log())
        self.assertIn("domain.cells=[12,12]", self.log())

    def test_gpus_get_sizes_of_real_runs(self):
        self.visit(image="nvptx", FAKE_DEVICE="0  GPU (nvptx64 image)", ONLY="^patches|launch_2d")
        self.assertIn("patches:64/teams:2/lanes:1/real_time|device_patches/D:2/k:2/patches:4096/teams:2/lanes:1/real_time", self.log())
        self.assertIn("domain.cells=[150,150]", self.log())
        self.assertIn("steps ran on the GPU", self.output)

    def test_failing_step_is_told_and_does_not_end_the_visit(self):
        steps = self.visit(1, FAKE="kernels_tests echo wrong by 3; exit 4", ONLY="kernels|lu")
        self.assertEqual((steps["kernels"][0], steps["lu"][0]), ("4", "0"))
        self.assertIn("=== kernels (4, ", self.log())
        self.assertIn("wrong by 3", self.log())
        self.assertIn("1 failed", self.output)

    def test_steps_without_time_are_skipped_and_counted(self):
        steps = self.visit(seconds=9, ONLY="kernels|device_tests")
        self.assertEqual({name: code for name, (code, _) in steps.items()},
                         {"machine": "0", "unpack": "0", "devices": "0", "kernels": "skipped", "device_tests": "skipped"})
        self.assertIn("3 steps ran on the virtual device", self.output)
        self.assertIn("0 failed, 2 were skipped for want of time", self.output)

    def test_stopped_driver_keeps_what_is_complete(self):
        self.shorten("measure lu 40")
        steps = self.visit(1, FAKE="bench_lu sleep 30", ONLY="lu")
        self.assertEqual(steps["lu"][0], "124")
        results = json.loads((self.folder / "gpu_out/benchmarks.json").read_text())
        self.assertEqual(results["lu"]["benchmarks"], [{"name": "a"}])

    def test_only_restricts_steps(self):
        self.assertEqual(list(self.visit(ONLY="^compare_[12]d")), ["machine", "unpack", "devices", "compare_1d", "compare_2d"])

    def test_long_output_keeps_its_end(self):
        self.visit(ONLY="^kernels", FAKE="kernels_tests i=0; while [ $i -lt 5000 ]; do echo 'line of output'; i=$((i+1)); done; echo last")
        self.assertIn("the beginning is left out", self.log())
        self.assertIn("last\n", self.log())
        self.assertLess(len(self.log()), 60000)

    def test_machine_without_a_gpu_refuses_its_image(self):
        self.visit(1, image="nvptx")
        self.assertIn("no GPU takes the image of this bundle", self.output)

    def test_images_go_back_to_their_own_layout_where_the_driver_refuses_the_earlier_one(self):
        pack(self.folder, "nvptx", shared=["libcuda.so"])
        lists = "tentpole [ -s ${LD_LIBRARY_PATH%%:*}/libcuda.so ] && [ ! -L ${LD_LIBRARY_PATH%%:*}/libcuda.so ] && echo '0  GPU (nvptx64 image)'"
        steps = self.visit(FAKE=lists, ONLY="^lu$")
        self.assertEqual(list(steps), ["machine", "unpack", "devices", "devices_layout", "lu"])

    def test_broken_list_of_devices_does_not_end_a_visit_to_a_gpu(self):
        steps = self.visit(1, image="nvptx", FAKE="tentpole exit 139", ONLY="^lu$")
        self.assertEqual({name: code for name, (code, _) in steps.items()},
                         {"machine": "0", "unpack": "0", "devices": "139", "lu": "0"})

    def test_tar_and_xz_or_python_alone_are_enough(self):
        coreutils = ("bash", "mkdir", "rm", "cp", "ln", "timeout", "cat", "awk")
        for number, programs in enumerate([(*coreutils, "tar", "xz"), (*coreutils, "python3"), ("python3",)]):
            path = folder_of(programs, self.folder / f"path{number}")
            if path is None:
                self.skipTest(f"{programs} are not all here")
            steps = self.visit(PATH=str(path), ONLY="^(kernels|lu)$")
            self.assertEqual({name: code for name, (code, _) in steps.items()},
                             dict.fromkeys(("machine", "unpack", "devices", "kernels", "lu"), "0"), programs)
        self.shorten("measure lu 40")
        steps = self.visit(1, PATH=str(path), FAKE="bench_lu while :; do :; done", ONLY="lu")
        self.assertEqual(steps["lu"][0], "124")

    def test_usage_and_missing_archive(self):
        shutil.copy(VISIT, self.folder)
        for arguments, text in (([], "usage: bash gpu_visit SECONDS"), (["x"], "usage: bash gpu_visit SECONDS"),
                                (["5"], "gpu_bundle.tar.xz does not exist; make it with scripts/gpu_bundle")):
            result = subprocess.run(["bash", "gpu_visit", *arguments], cwd=self.folder, capture_output=True, text=True)
            self.assertEqual(result.returncode, 2)
            self.assertIn(text, result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
