"""scripts/check_gpu_image: what it reads and refuses.    usage: gpu_image_test.py SOURCE_FOLDER [BAD_PROGRAM]

BAD_PROGRAM is bad_kernel.cpp as the compiler made it, where the build has nvptx images.
"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import synthetic_cubin

SOURCE = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(SOURCE / "scripts"))
from gpu.cubin import Cubin  # noqa: E402
from gpu.earlier_layout import in_earlier_layout  # noqa: E402

BAD_PROGRAM = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
PATCHES = "_ZN8tentpole12_GLOBAL__N_110run_on_gpuILi2EEEvNS_15PatchSolverTaskEi"
ROWS = "_ZN8tentpole14target_runtime9pack_rowsEiNS0_8SlotRowsE"
LIMITS = '''architecture = "sm_90"
registers = 128
[program.tentpole]
"run_on_gpu<2>" = { name = "patches, D = 2", stack = 1050 }
"target_runtime::pack_rows" = { name = "rows", stack = 0 }
'''


class CheckGpuImage(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "limits.toml").write_text(LIMITS)
        self.image = synthetic_cubin.Image()
        self.patches = self.image.kernel(PATCHES, shared=1044)
        self.rows = self.image.kernel(ROWS, registers=55, stack=0)

    def check(self, content, exit_code, *options):
        """Both streams of the script's output for a program of these bytes."""
        path = self.folder / "tentpole"
        path.write_bytes(content)
        result = subprocess.run([sys.executable, "-B", SOURCE / "scripts/check_gpu_image", path, "--limits",
                                 self.folder / "limits.toml", *options], capture_output=True, text=True)
        self.assertEqual(result.returncode, exit_code, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def faults_of(self, *patterns):
        """Checks the image; the patterns are those of its faults, in order."""
        out = self.check(self.image.content(), 1 if patterns else 0)
        lines = [line for line in out.splitlines() if line.startswith("check_gpu_image: ")]
        self.assertEqual(len(lines), len(patterns), out)
        for line, pattern in zip(lines, patterns):
            self.assertRegex(line, pattern)

    def test_figures_of_each_kernel_are_printed_and_written(self):
        out = self.check(self.image.content(), 0, "--json", self.folder / "image.json")
        self.assertRegex(out, r"patches, D = 2 +128 +1000 +1050 +1044  SPMD +0\n")
        self.assertRegex(out, r"rows +55 +0 +0 +0  SPMD +0\n")
        written = json.loads((self.folder / "image.json").read_text())
        self.assertEqual(written["kernels"][0], {"kernel": "patches, D = 2", "function": "run_on_gpu<2>", "registers": 128, "stack": 1000,
                                                 "shared": 1044, "mode": "SPMD", "heap_calls": 0})

    def test_image_is_found_inside_a_program(self):
        self.assertIn("2 kernels, 0 faults", self.check(synthetic_cubin.program(self.image.content()), 0))

    def test_heap_calls_count_where_a_kernel_reaches_them(self):
        self.image.call(self.patches, "_Z6helperv")
        self.image.call("_Z6helperv", "malloc", places=2)
        self.image.call("_Z6helperv", "free")
        self.image.call("_Z9unreachedv", "malloc")
        self.faults_of(r"patches, D = 2: 3 calls of the heap, limit 0 \(1 of free in helper, 2 of malloc in helper\)")

    def test_heap_calls_count_through_pointers(self):
        self.image.call_through_pointer(self.rows, "_Z6helperv")
        self.image.call("_Z6helperv", "__kmpc_alloc_shared")
        self.image.call("__kmpc_alloc_shared", "malloc")
        self.faults_of(r"rows: 1 calls of the heap, limit 0 \(1 of __kmpc_alloc_shared in helper\)")

    def test_modes_other_than_spmd_are_refused(self):
        for mode, name in ((1, "generic"), (3, "generic-SPMD")):
            self.image.kernel(PATCHES, mode=mode)
            self.faults_of(f"patches, D = 2: execution mode {name}, limit SPMD. Put `parallel`")

    def test_registers_and_stack_have_limits(self):
        self.image.kernel(PATCHES, registers=129, stack=1051)
        self.faults_of("patches, D = 2: 129 registers, limit 128", "patches, D = 2: 1051 B of stack, limit 1050 B.*record 1103")

    def test_stack_that_depends_on_the_run_is_refused(self):
        self.image.kernel(PATCHES, stack=None)
        self.faults_of("patches, D = 2: stack cannot be known before it runs, limit 1050")

    def test_kernel_without_record_says_how_to_add_it(self):
        self.image.kernel("_ZN8tentpole11loop_on_gpuINS_12_GLOBAL__N_110TransplantILi3EEEEEvNS_11LaunchShapeEiT_i", stack=200)
        self.faults_of(r'no limit is recorded.*"loop_on_gpu<Transplant<3>>" = \{ name = "loop_on_gpu<Transplant<3>>", stack = 210 \}')

    def test_recorded_kernel_must_be_there(self):
        del self.image.kernels[self.rows]
        self.faults_of("rows: target_runtime::pack_rows is recorded for tentpole, and its image has no such kernel")

    def test_second_region_of_a_function_is_a_kernel_of_its_own(self):
        self.image.kernels[self.rows.replace("_l5", "_l17")] = (2, 20, 0, 0)
        self.faults_of("target_runtime::pack_rows, region 2: no limit is recorded")

    def test_program_without_image_is_refused_or_skipped(self):
        program = synthetic_cubin.program(self.image.content(), triple="amdgcn-amd-amdhsa")
        self.assertIn("Configure where a CUDA toolkit is found", self.check(program, 2))
        self.assertIn("nothing to check", self.check(program, 77, "--skip-without-image"))

    def test_image_of_another_architecture_is_not_judged(self):
        self.assertIn("this image is for sm_80: nothing was judged",
                      self.check(synthetic_cubin.program(self.image.content(), arch="sm_80"), 77))

    def test_files_that_are_no_image_are_refused(self):
        content = self.image.content()
        for damaged in (b"", content[:60], content[:200], content[:16] + b"\1\0" + content[18:], content[:18] + b"\x3e\0" + content[20:]):
            self.assertIn("holds no linked nvptx image", self.check(damaged, 2))

    def test_limits_that_are_incomplete_are_refused(self):
        for text in ("", "registers = 128", LIMITS.replace("stack = 0", 'stack = "0"'), LIMITS + "["):
            (self.folder / "limits.toml").write_text(text)
            self.assertIn("limits.toml: ", self.check(self.image.content(), 2))

    def new_layout(self, architecture=90):
        """The image as CUDA 13 writes it: ABI version 8, architecture in the second byte of the flags."""
        self.image.barriers = {self.patches: 1, self.rows: 0}
        content = bytearray(self.image.content())
        content[7], content[8] = 0x41, 8
        struct.pack_into("<I", content, 48, 0x06000004 | architecture << 8)
        return bytes(content)

    def test_image_of_cuda_13_is_written_in_the_layout_of_cuda_12(self):
        content = self.new_layout()
        earlier = in_earlier_layout(content)
        self.assertEqual((earlier[7], earlier[8]), (0x33, 7))
        self.assertEqual(struct.unpack_from("<I", earlier, 48)[0], 0x5A055A)  # as ptxas 12.9 marks sm_90
        self.assertEqual(Cubin(earlier).kernels(), Cubin(content).kernels())
        flags = {place: (struct.unpack_from("<Q", earlier, place + 8)[0], struct.unpack_from("<Q", content, place + 8)[0])
                 for place in range(struct.unpack_from("<Q", content, 40)[0], len(content), 64)}
        self.assertEqual([new ^ old for new, old in flags.values() if new != old], [1 << 20], "the kernel with a barrier, and no other")

    def test_other_images_keep_their_layout(self):
        for content in (self.image.content(), self.new_layout(architecture=100), b"\x7fELF\x02", b""):
            self.assertEqual(in_earlier_layout(content), content)

    @unittest.skipUnless(BAD_PROGRAM, "this build has no nvptx image")
    def test_a_bad_kernel_of_the_compiler_fails_on_every_count(self):
        out = self.check(BAD_PROGRAM.read_bytes(), 1, "--program", "bad")
        for pattern in ("execution mode generic", r"[1-9]\d* calls of the heap", r"\d{3} registers, limit 128",
                        "stack cannot be known", "no limit is recorded"):
            self.assertRegex(out, "sum_rows: " + pattern)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
