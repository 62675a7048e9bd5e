"""`tentpole compare`: host and device give the same solution. Skipped in builds without device images."""
import re
import subprocess
import unittest

from program import TENTPOLE, ProgramTest, main

HAS_DEVICE = "no device:" not in subprocess.run([TENTPOLE, "devices"], capture_output=True, text=True).stdout


class Compare(ProgramTest):
    @unittest.skipIf(HAS_DEVICE, "there is a device")
    def test_without_a_device_it_is_refused_and_nothing_is_written(self):
        self.assertIn("no device:", self.refused("compare", "wave.toml", "--out", "c"))

    @unittest.skipUnless(HAS_DEVICE, "there is no device")
    def test_host_and_device_agree_to_rounding(self):
        out, err = self.tentpole("compare", "wave.toml")
        self.assertEqual(err, "")
        for stage in ("meshing", "assembly", "solution", "post-solution", "transfer", "total"):
            self.assertRegex(out, rf"\n +{stage} +[\d.]+ s +[\d.]+ s")
        self.assertRegex(out, r"[\d.]+ kB to the device, [\d.]+ [kM]B back, \d+ launches")
        difference = re.search(r"largest relative difference of the solutions\n +([\d.e-]+)", out)
        self.assertLess(float(difference[1]), 1e-10)
        self.assertEqual(self.tree(), ["wave.toml"])

    @unittest.skipUnless(HAS_DEVICE, "there is no device")
    def test_results_are_kept_where_asked_and_older_ones_moved_aside(self):
        self.tentpole("compare", "wave.toml", "--out", "c", "--quiet")
        _, err = self.tentpole("compare", "wave.toml", "--out", "c", "--quiet")
        self.assertIn("now in c/host.1", err)
        self.assertEqual(self.summary("c/host")["device"], "host")
        self.assertNotEqual(self.summary("c/device")["device"], "host")
        self.assertEqual(self.summary("c/device.1")["counts"], self.summary("c/device")["counts"])

    @unittest.skipUnless(HAS_DEVICE, "there is no device")
    def test_offloaded_run_counts_its_traffic(self):
        out, _ = self.tentpole("run", "wave.toml", "--offload")
        summary = self.summary("result_wave")
        self.assertGreater(summary["traffic"]["launches"], 0)
        self.assertIn("launches", out)


if __name__ == "__main__":
    main()
