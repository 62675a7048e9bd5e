"""What the program says of a GPU that it cannot use, with a driver that is a fake.

usage: unused_gpu_test.py TENTPOLE FAKE_LIBCUDA SOURCE_FOLDER
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

TENTPOLE, LIBRARY, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])


class UnusedGpu(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        shutil.copy(LIBRARY, self.folder / "libcuda.so.1")

    def run_program(self, *arguments, architecture="90"):
        environment = dict(os.environ, FAKE_GPU_ARCHITECTURE=architecture,
                           LD_LIBRARY_PATH=f"{self.folder}:{os.environ.get('LD_LIBRARY_PATH', '')}")
        return subprocess.run([TENTPOLE, *arguments], env=environment, cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, check=True)

    def test_devices_names_the_gpu_and_the_way_out(self):
        out = self.run_program("devices", architecture="80").stdout
        self.assertIn("GPU 0 (Fake GPU) is not used: ", out)
        self.assertIn("-DTENTPOLE_GPU_ARCH=sm_80", out)

    def test_an_offloaded_run_warns_that_it_leaves_the_gpu_alone(self):
        case = SOURCE / "examples/plane_wave_1d.toml"
        if "no device" in self.run_program("devices").stdout:
            self.skipTest("this build has no device")
        run = self.run_program("run", case, "--offload", "--out", "result", "--quiet", "--set", "time.end=0.01")
        self.assertIn("warning: GPU 0 (Fake GPU) is not used: ", run.stderr)

    def test_a_run_on_the_host_does_not(self):
        case = SOURCE / "examples/plane_wave_1d.toml"
        run = self.run_program("run", case, "--out", "result", "--quiet", "--set", "time.end=0.01")
        self.assertNotIn("Fake GPU", run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
