"""Runs that are stopped from outside: what they write stays readable, and the exit code tells how they ended."""
import json
import os
import resource
import shlex
import shutil
import signal
import subprocess
import time

from program import LONG, TENTPOLE, ProgramTest, main


class Interruption(ProgramTest):
    def check_finished_files(self):
        """Everything under its final name is complete; returns the number of snapshots."""
        snapshots = sorted((self.folder / "r").glob("snapshot_*.vtkhdf"))
        for path in snapshots:
            self.assertIn("snapshot at t = ", self.tentpole("info", path)[0])
        for entry in json.loads((self.folder / "r/snapshot.vtkhdf.series").read_text())["files"]:
            self.assertTrue((self.folder / "r" / entry["name"]).exists())
        for table in ("history.csv", "probe_mid.csv"):
            rows = self.table(f"r/{table}")
            self.assertTrue(all(None not in row.values() for row in rows))
            times = [row["time"] for row in rows]
            self.assertEqual(times, sorted(times))
        return len(snapshots)

    def test_signals_that_ask_for_the_end_finish_the_batch_and_exit_with_130(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1, signal.SIGUSR2, signal.SIGXCPU):
            shutil.rmtree(self.folder / "r", ignore_errors=True)
            process = self.start(*LONG)
            self.wait_for("snapshot_0003.vtkhdf")
            process.send_signal(number)
            _, err = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 130, f"{number!r} {err}")
            self.assertIn("a second Ctrl-C quits at once", err)
            self.assertRegex(err, r"interrupted at t = [\d.e-]+ s; go on with:\n  tentpole run wave.toml --set time.end=50 "
                                  r".* --resume r/checkpoint.h5\n")
            self.assertFalse((self.folder / "r/summary.json").exists())
            self.assertGreaterEqual(self.check_finished_files(), 4)
            self.assertRegex(self.tentpole("info", "r/checkpoint.h5")[0], r"front_times +50\n")

    def test_interrupted_and_resumed_run_is_bitwise_the_uninterrupted_one(self):
        case = ["--set", "time.end=5", "--set", "output.snapshots=100", "--set", "run.batch_size=4", "--check",
                "--set", "initial.displacement=['sin(2 * pi * x)']"]
        self.tentpole("run", "wave.toml", "--out", "whole", "--quiet", *case)
        process = self.start(*case)
        self.wait_for("snapshot_0010.vtkhdf")
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertLess(self.check_finished_files(), 100)
        self.assertIn("--resume r/checkpoint.h5", self.tentpole("info", "r")[0])
        self.assertIn("Leave out --out", self.refused("run", "wave.toml", "--resume", "r/checkpoint.h5", "--out", "whole"))
        command = shlex.split(err[err.index("tentpole run"):])  # what the message says
        self.tentpole(*command[1:])
        for path in (self.folder / "whole").iterdir():
            if path.name != "summary.json":
                self.assertEqual((self.folder / "r" / path.name).read_bytes(), path.read_bytes(), path.name)
        for section in ("energy", "title", "seed"):
            self.assertEqual(self.summary("r")[section], self.summary("whole")[section])
        self.assertFalse((self.folder / "r/checkpoint.h5").exists())

    def test_checkpoint_of_another_case_or_a_damaged_one_is_refused(self):
        process = self.start(*LONG)
        self.wait_for("snapshot_0002.vtkhdf")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=60), 130)
        err = self.refused("run", "wave.toml", "--quiet", "--resume", "r/checkpoint.h5", *LONG, "--set",
                           "material.all.density=2")
        self.assertIn("density", err)
        for lost in ("history.csv", "probe_mid.csv", "snapshot_0001.vtkhdf", "snapshot.vtkhdf.series"):
            (self.folder / "r" / lost).rename(self.folder / lost)
            err = self.refused("run", "wave.toml", "--quiet", "--resume", "r/checkpoint.h5", *LONG)
            self.assertIn(f"r/{lost} is missing. Resume in the result folder", err)
            (self.folder / lost).rename(self.folder / "r" / lost)
        (self.folder / "r/checkpoint.h5").write_bytes(b"noise")
        self.assertIn("r/checkpoint.h5", self.refused("run", "wave.toml", "--quiet", "--resume", "r/checkpoint.h5", *LONG))

    def start_long_batch(self, cells):
        """The first batch of all the patches of a flat front of this size takes seconds."""
        process = self.start("--set", f"domain.cells=[{cells}]", "--set", "run.batch_size=1000000",
                             "--set", "discretization.degree=6", "--threads", "1")
        self.wait_for(".lock")
        time.sleep(1.0)
        return process

    def test_further_signals_of_a_batch_system_do_not_cost_the_checkpoint(self):
        process = self.start_long_batch(60000)
        for number in (signal.SIGUSR1, signal.SIGTERM, signal.SIGXCPU, signal.SIGXCPU, signal.SIGHUP, signal.SIGTERM):
            process.send_signal(number)
            time.sleep(0.05)
        _, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 130, err)
        self.assertTrue((self.folder / "r/checkpoint.h5").exists())

    def test_run_outlives_its_terminal_under_nohup_and_a_closed_stdout(self):
        process = self.start("--set", "time.end=5", "--set", "output.snapshots=20",
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        process.stdout.close()
        self.wait_for("snapshot_0001.vtkhdf")
        process.send_signal(signal.SIGHUP)
        self.assertEqual(process.wait(timeout=60), 0)
        self.assertTrue((self.folder / "r/summary.json").exists())

    def test_stdout_closed_before_the_first_line_does_not_end_a_run(self):
        reader, writer = os.pipe()
        os.close(reader)
        result = subprocess.run([TENTPOLE, "run", "wave.toml", "--out", "r"], cwd=self.folder, stdout=writer,
                                stderr=subprocess.PIPE, text=True)
        os.close(writer)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue((self.folder / "r/summary.json").exists())

    def test_limit_of_file_sizes_is_an_error_that_names_the_file(self):
        # As from a shell: Python would ignore SIGXFSZ, and its default ends a program without a word.
        for limit in (3000, 9000, 20000):
            result = subprocess.run([TENTPOLE, "run", "wave.toml", "--out", "r", "--quiet", "--set", "domain.cells=[100]"],
                                    cwd=self.folder, capture_output=True, text=True,
                                    preexec_fn=lambda limit=limit: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
            self.assertEqual(result.returncode, 1, limit)
            self.assertRegex(result.stderr, r"^(note: .*\n)?the run failed: .*r/.*\n$")

    def test_second_interrupt_quits_at_once(self):
        process = self.start_long_batch(200000)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.stderr.readline(), "\n")
        self.assertIn("a second Ctrl-C quits at once", process.stderr.readline())
        started = time.monotonic()
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=60), -signal.SIGINT)
        self.assertLess(time.monotonic() - started, 1.0)

    def test_killed_run_leaves_readable_files_and_the_next_run_moves_them_aside(self):
        process = self.start(*LONG)
        self.wait_for("snapshot_0005.vtkhdf")
        process.kill()
        process.communicate()
        number = self.check_finished_files()
        self.assertGreaterEqual(number, 6)
        self.assertIn("not complete", self.tentpole("info", "r")[0])
        _, err = self.tentpole("run", "wave.toml", "--out", "r")
        self.assertIn("the older result in r is now in r.1", err)
        self.assertEqual(len(list((self.folder / "r.1").glob("snapshot_*.vtkhdf"))), number)


if __name__ == "__main__":
    main()
