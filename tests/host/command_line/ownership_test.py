"""A run owns its result folder: another one is refused, and it writes nothing once the folder is not its own.

usage: ownership_test.py TENTPOLE SOURCE_FOLDER NO_LOCKS_LIBRARY
"""
import os
import pathlib
import re
import shutil
import signal
import socket
import sys
import time

from program import LONG, ProgramTest, main

NO_LOCKS = str(pathlib.Path(sys.argv[3]).resolve())
RECORD = "host {}\nprocess {}\nstart 2026-12-01 10:22:33 UTC\nboot {}\nprocess_space {}\nticks 5\n"


class Ownership(ProgramTest):
    def finished_files(self, folder):
        return {path.name: path.read_bytes() for path in (self.folder / folder).iterdir() if path.name[0] != "."}

    def check_unchanged(self, folder, before):
        """Names the files that differ: a difference of their bytes would take minutes to print."""
        now = self.finished_files(folder)
        self.assertEqual([name for name in sorted(before.keys() | now.keys()) if before.get(name) != now.get(name)], [])

    def check_second_runs_are_refused(self, process):
        """While `process` runs in r, nothing begins there, and nothing changes but what it writes itself."""
        for arguments in (["--out", "r", "--set", "material.all.density=4"], ["--out", "r/"]):
            _, err = self.tentpole("run", "wave.toml", *arguments, exit_code=2)
            self.assertRegex(err, rf"^r: another run works in this folder \(process {process.pid} of {socket.gethostname()}, "
                                  r"at work since \d{4}-\d\d-\d\d \d\d:\d\d:\d\d UTC\)\. Wait for its end, stop it, or give "
                                  r"another folder with --out\.\n$")
        self.assertFalse((self.folder / "r.1").exists())
        self.assertIsNone(process.poll())

    def test_second_run_in_a_folder_is_refused_and_the_first_goes_on(self):
        process = self.start(*LONG)
        self.wait_for("snapshot_0002.vtkhdf")
        self.check_second_runs_are_refused(process)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=60), 130)
        self.assertFalse((self.folder / "r/.lock").exists())

    def test_resuming_beside_the_run_that_wrote_the_checkpoint_is_refused(self):
        process = self.start(*LONG, "--set", "checkpoint.interval_minutes=1e-4")
        self.wait_for("checkpoint.h5")
        for program in ([], ["--out", "r"]):
            _, err = self.tentpole("run", "wave.toml", *LONG, "--resume", "r/checkpoint.h5", *program, exit_code=2)
            self.assertIn(f"r: another run works in this folder (process {process.pid} ", err)
        self.assertIsNone(process.poll())
        process.kill()
        process.wait()
        self.assertTrue((self.folder / "r/.lock").exists())
        case = LONG + ["--set", "checkpoint.interval_minutes=1e-4"]
        resumed = self.start("--resume", "r/checkpoint.h5", *case, out=None)  # the lock died with its process
        resumed.stdout.readline()
        resumed.send_signal(signal.SIGINT)
        _, err = resumed.communicate(timeout=60)
        self.assertEqual(resumed.returncode, 130, err)

    def test_lock_of_a_killed_run_does_not_block(self):
        process = self.start(*LONG)
        self.wait_for("snapshot_0002.vtkhdf")
        process.kill()
        process.wait()
        _, err = self.tentpole("run", "wave.toml", "--out", "r")
        self.assertIn("the older result in r is now in r.1", err)
        self.assertEqual([path for path in self.tree() if ".lock" in path], [])

    def test_folder_with_nothing_but_a_lock_is_used(self):
        (self.folder / "r").mkdir()
        (self.folder / "r/.lock").write_text("")
        self.assertEqual(self.tentpole("run", "wave.toml", "--out", "r", "--quiet"), ("", ""))
        self.assertFalse((self.folder / "r.1").exists())

    def stop_by(self, change, message):
        """`change` takes the folder away from a run; the run must stop with `message`."""
        for folder in ("r", "moved"):
            shutil.rmtree(self.folder / folder, ignore_errors=True)
        process = self.start(*LONG, "--set", "checkpoint.interval_minutes=1e-4")
        for name in ("checkpoint.h5", "history.csv", "snapshot_0001.vtkhdf"):
            self.wait_for(name)
        while "snapshot_0001" not in (self.folder / "r/snapshot.vtkhdf.series").read_text():
            time.sleep(0.001)
        process.send_signal(signal.SIGSTOP)
        change()
        process.send_signal(signal.SIGCONT)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, err)
        self.assertRegex(err, message)

    def test_run_writes_nothing_into_a_folder_that_is_not_its_own_any_more(self):
        copied = {}

        def replace():
            (self.folder / "r").rename(self.folder / "moved")
            shutil.copytree(self.folder / "moved", self.folder / "r", ignore=shutil.ignore_patterns(".*"))
            copied.update(self.finished_files("r"))

        self.stop_by(replace, r"r: another folder has taken the place of the run's result folder|"
                              r"r/\w+\.csv: the table is not this run's any more|r/.*: its folder was deleted, moved or replaced")
        self.check_unchanged("r", copied)
        self.stop_by(lambda: shutil.rmtree(self.folder / "r"),
                     r"r: the result folder was deleted|its folder is gone|r/.*: its folder was deleted, moved or replaced")
        self.assertFalse((self.folder / "r").exists())
        self.stop_by((self.folder / "r/.lock").unlink, r"the lock file r/\.lock was deleted")
        self.stop_by((self.folder / "r/history.csv").unlink, r"r/history\.csv: the table is not this run's any more: it was deleted")
        self.assertFalse((self.folder / "r/history.csv").exists())


class WithoutLocks(ProgramTest):
    """On file systems without locks the lock file alone counts; HDF5 files are read and written as well."""

    def setUp(self):
        super().setUp()
        os.environ["LD_PRELOAD"] = NO_LOCKS
        self.addCleanup(os.environ.pop, "LD_PRELOAD")

    def test_runs_are_solved_described_and_resumed(self):
        process = self.start(*LONG)
        self.wait_for("snapshot_0002.vtkhdf")
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)
        self.assertIn("snapshot at t = ", self.tentpole("info", "r/snapshot_0000.vtkhdf")[0])
        self.assertIn("front_times", self.tentpole("info", "r/checkpoint.h5")[0])
        case = ["--set", "checkpoint.interval_minutes=1e-4"]
        self.tentpole("run", "wave.toml", "--out", "s", "--quiet", *case)
        process = self.start(*LONG, "--resume", "r/checkpoint.h5", out=None)
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)

    def test_living_run_of_this_machine_is_named_and_a_dead_one_is_not_in_the_way(self):
        process = self.start(*LONG)
        self.wait_for("snapshot_0002.vtkhdf")
        _, err = self.tentpole("run", "wave.toml", "--out", "r", exit_code=2)
        self.assertIn(f"r: another run works in this folder (process {process.pid} of {socket.gethostname()}, ", err)
        self.assertIsNone(process.poll())
        process.kill()
        process.wait()
        self.tentpole("run", "wave.toml", "--out", "r")
        self.assertTrue((self.folder / "r.1").exists())

    def test_lock_of_another_machine_is_refused_with_the_way_out(self):
        self.tentpole("run", "wave.toml", "--out", "r")
        for record in (RECORD.format("elsewhere", 4711, "other", "pid:[1]"), ""):
            (self.folder / "r/.lock").write_text(record)
            err = self.refused("run", "wave.toml", "--out", "r")
            self.assertIn("r: another run may work in this folder", err)
            self.assertIn("delete r/.lock and try again", err)
            self.assertEqual("(process 4711 of elsewhere, at work since 2026-12-01 10:22:33 UTC)" in err, record != "")
        (self.folder / "r/.lock").unlink()
        self.tentpole("run", "wave.toml", "--out", "r")

    def test_run_whose_lock_file_another_machine_took_stops(self):
        process = self.start(*LONG)
        self.wait_for("snapshot_0002.vtkhdf")
        (self.folder / "new").write_text(RECORD.format("elsewhere", 4711, "other", "pid:[1]"))
        (self.folder / "new").rename(self.folder / "r/.lock")
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, err)
        self.assertRegex(err, re.escape("r: another run has taken over the result folder (process 4711 of elsewhere, "))
        self.assertTrue((self.folder / "r/.lock").exists())


if __name__ == "__main__":
    main()
