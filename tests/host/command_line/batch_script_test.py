"""The batch script of docs/clusters.md, with a Slurm that is a fake: it goes on where the last job stopped until the run ends.

usage: batch_script_test.py TENTPOLE SOURCE_FOLDER
"""
import os
import re
import signal
import subprocess

from program import SOURCE, TENTPOLE, WAVE, ProgramTest, main


class BatchScript(ProgramTest):
    def setUp(self):
        super().setUp()
        text = (SOURCE / "docs/clusters.md").read_text()
        script = re.search(r"```bash\n(#!/bin/bash\n.*?)```", text, re.DOTALL).group(1)
        (self.folder / "job.sh").write_text(script)
        (self.folder / "spall_plate.toml").write_text(WAVE.replace("end = 0.5", "end = 20.0").replace("snapshots = 3", "snapshots = 400"))
        (self.folder / "bin").mkdir()
        (self.folder / "bin/tentpole").symlink_to(TENTPOLE)
        (self.folder / "bin/scontrol").write_text('#!/bin/sh\necho "$@" >> requeued\n')
        (self.folder / "bin/scontrol").chmod(0o755)
        self.environment = dict(os.environ, PATH=f"{self.folder / 'bin'}:{os.environ['PATH']}", SLURM_CPUS_PER_TASK="1",
                                SLURM_JOB_ID="4711")

    def start_job(self):
        process = subprocess.Popen(["bash", "job.sh"], cwd=self.folder, env=self.environment, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        for clean_up in (process.stderr.close, process.wait, process.kill):
            self.addCleanup(clean_up)
        return process

    def test_job_is_put_back_into_the_queue_until_the_run_has_ended(self):
        job = self.start_job()
        self.wait_for("snapshot_0003.vtkhdf", "result_spall_plate")
        job.send_signal(signal.SIGUSR1)
        _, err = job.communicate(timeout=60)
        self.assertEqual(job.returncode, 130, err)
        self.assertEqual((self.folder / "requeued").read_text(), "requeue 4711\n")
        self.assertTrue((self.folder / "result_spall_plate/checkpoint.h5").exists())
        job = self.start_job()
        _, err = job.communicate(timeout=120)
        self.assertEqual(job.returncode, 0, err)
        self.assertTrue((self.folder / "result_spall_plate/summary.json").exists())
        self.assertFalse((self.folder / "result_spall_plate.1").exists(), "it began anew")
        self.assertEqual((self.folder / "requeued").read_text(), "requeue 4711\n")


if __name__ == "__main__":
    main()
