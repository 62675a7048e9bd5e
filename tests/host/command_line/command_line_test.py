"""Exit codes, messages and files of the program's commands."""
import os
import resource
import shutil
import stat
import subprocess

from program import SOURCE, TENTPOLE, WAVE, ProgramTest, main


class Run(ProgramTest):
    def test_result_goes_to_a_folder_named_after_the_case_in_the_current_folder(self):
        (self.folder / "cases").mkdir()
        (self.folder / "cases/ring.toml").write_text(WAVE)
        out, err = self.tentpole("run", "cases/ring.toml")
        self.assertEqual(err, "")
        self.assertEqual(sorted(os.listdir(self.folder / "result_ring")),
                         ["history.csv", "probe_mid.csv", "snapshot.vtkhdf.series", "snapshot_0000.vtkhdf",
                          "snapshot_0001.vtkhdf", "snapshot_0002.vtkhdf", "summary.json"])
        for text in ("a wave on a ring", "1D, 20 intervals", "patches/s", "solution", "100.0 %", "balance error",
                     "tentpole plot result_ring"):
            self.assertIn(text, out)

    def test_quiet_prints_nothing(self):
        self.assertEqual(self.tentpole("run", "wave.toml", "--quiet"), ("", ""))

    def test_older_result_is_moved_aside_and_the_message_says_so(self):
        self.tentpole("run", "wave.toml", "--out", "r")
        first = (self.folder / "r/probe_mid.csv").read_bytes()
        _, err = self.tentpole("run", "wave.toml", "--out", "r", "--set", "time.end=0.25")
        self.assertIn("the older result in r is now in r.1", err)
        self.assertEqual((self.folder / "r.1/probe_mid.csv").read_bytes(), first)
        self.assertEqual(self.summary("r")["end_time"], 0.25)

    def test_broken_input_leaves_an_older_result_where_it_is(self):
        self.tentpole("run", "wave.toml", "--out", "r")
        for faulty in (["--set", "time.end=-1"], ["--resume", "r/checkpoint.h5"], ["--device", "999"],
                       ["--threads", "0"]):
            self.refused("run", "wave.toml", "--out", "r", *faulty)

    def test_folder_of_other_files_is_refused(self):
        (self.folder / "thesis").mkdir()
        (self.folder / "thesis/chapter.tex").write_text("text")
        self.assertIn("thesis: this folder holds files", self.refused("run", "wave.toml", "--out", "thesis"))

    def test_all_faults_are_reported_at_once_with_their_place(self):
        (self.folder / "bad.toml").write_text(WAVE.replace("degree = 2", "degree = 12").replace("end = 0.5", "end = 0"))
        err = self.refused("run", "bad.toml", "--set", "domain.cell=3")
        self.assertIn("bad.toml:19: discretization.degree = 12:", err)
        self.assertIn("bad.toml:17: time.end = 0:", err)
        self.assertIn('--set domain.cell=3: unknown key', err)

    def test_titles_and_names_reach_the_terminal_without_escapes(self):
        (self.folder / "odd\x1b[2J.toml").write_text(WAVE.replace("a wave on a ring", r"a wave\u001b[31m on\na ring\u009b"))
        for command in (["check", "odd\x1b[2J.toml"], ["run", "odd\x1b[2J.toml", "--out", "r\x1b[7m"], ["info", "r\x1b[7m"]):
            out, err = self.tentpole(*command)
            self.assertNotRegex(out + err, r"[\x00-\x09\x0b-\x1f\x7f-\x9f]")
            self.assertIn(r"a wave\x1b[31m on\na ring\u009b" + "\n", out)
        for faulty in (["run", "odd\x1b[2J.toml", "--set", "output.fields=['x\x1b[2Jy']"],
                       ["check", "odd\x1b[2J.toml", "--set", "domain.\x1b[2J=1"], ["check", "none\x1b[2J\n.toml"],
                       ["info", "none\x1b[2J"], ["chec\x1b[2Jk"], ["run", "odd\x1b[2J.toml", "--\x1b[2J"]):
            err = self.refused(*faulty)
            self.assertNotRegex(err, r"[\x00-\x09\x0b-\x1f\x7f-\x9f]")
            self.assertIn(r"\x1b[2J", err)

    def test_set_replaces_values_of_the_case(self):
        self.tentpole("run", "wave.toml", "--set", "discretization.degree=3", "--set", "time.end=0.1",
                      "--set", "initial.displacement=['0']")
        summary = self.summary("result_wave")
        self.assertEqual((summary["degree"], summary["end_time"]), (3, 0.1))

    def test_seed_changes_an_unstructured_mesh(self):
        self.tentpole("run", "wave.toml", "--set", "domain.pattern='unstructured'", "--seed", "7")
        self.assertEqual(self.summary("result_wave")["seed"], 7)
        rows = self.table("result_wave/history.csv")
        self.tentpole("run", "wave.toml", "--set", "domain.pattern='unstructured'", "--seed", "8")
        self.assertNotEqual(rows, self.table("result_wave/history.csv"))

    def test_threads_are_honoured_and_do_not_change_the_result(self):
        results = []
        for threads in (1, 3):
            out, _ = self.tentpole("run", "wave.toml", "--threads", threads, "--out", f"r{threads}")
            self.assertIn("1 thread\n" if threads == 1 else "3 threads\n", out)
            self.assertEqual(self.summary(f"r{threads}")["threads"], threads)
            results.append((self.folder / f"r{threads}/probe_mid.csv").read_bytes())
        self.assertEqual(results[0], results[1])

    def test_threads_survive_reading_a_mesh_file(self):
        example = SOURCE / "examples/two_material_reflection.toml"
        self.tentpole("run", example, "--threads", "3", "--set", "time.end=0.01", "--out", "r")
        self.assertEqual(self.summary("r")["threads"], 3)

    def test_limit_of_threads_is_respected_and_named(self):
        environment = dict(os.environ, OMP_THREAD_LIMIT="1")
        for arguments, warning in (([], ""), (["--threads", "3"], "warning: --threads 3: only 1, by OMP_THREAD_LIMIT\n")):
            for command in (["check", "wave.toml"], ["run", "wave.toml", "--out", f"r{len(arguments)}"]):
                result = subprocess.run([TENTPOLE, *command, *arguments], cwd=self.folder, capture_output=True, text=True,
                                        env=environment, check=True)
                self.assertEqual(result.stderr, warning)
                if arguments:
                    self.assertRegex(result.stdout, r"device +host, 1 thread \(OMP_THREAD_LIMIT[;)]")
                if command[0] == "check":
                    self.assertIn("scratch of 1 thread\n", result.stdout)
            self.assertEqual(self.summary(f"r{len(arguments)}")["threads"], 1)

    def test_energy_check_passes(self):
        self.tentpole("run", "wave.toml", "--check")

    def test_value_that_becomes_infinite_stops_the_run_with_place_and_time(self):
        faulty = WAVE + "[body_force]\nacceleration = ['1/(t - 0.25 - abs(t - 0.25))']\n"
        (self.folder / "infinite.toml").write_text(faulty)
        _, err = self.tentpole("run", "infinite.toml", exit_code=2)
        self.assertIn("body_force.acceleration", err)
        self.assertIn("t = 0.", err)

    def test_run_that_cannot_write_fails_with_exit_code_1_and_one_line(self):
        # Python ignores SIGXFSZ and lets the child inherit that, so writes beyond the limit fail as on a full disk.
        # Below 1024 bytes clang's OpenMP runtime has complaints of its own.
        for limit in (2000, 3000, 5000, 8000):
            result = subprocess.run([TENTPOLE, "run", "wave.toml", "--quiet", "--out", f"r{limit}"], cwd=self.folder,
                                    capture_output=True, text=True, restore_signals=False,
                                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertRegex(result.stderr, rf"^the run failed: .*r{limit}/.*\n$")

    def test_read_only_folder_is_bad_input(self):
        if os.geteuid() == 0:
            self.skipTest("permissions do not bind the superuser")
        (self.folder / "locked").mkdir()
        (self.folder / "locked").chmod(stat.S_IRUSR | stat.S_IXUSR)
        self.assertIn("locked/r: cannot be made a result folder",
                      self.refused("run", "wave.toml", "--out", "locked/r"))


class Check(ProgramTest):
    def test_number_of_patches_is_what_a_run_solves(self):
        out, _ = self.tentpole("check", "wave.toml")
        self.tentpole("run", "wave.toml")
        counts = self.summary("result_wave")["counts"]
        self.assertIn(f"patches   {counts['patches']:,}, at most 2 elements each\n", out)
        self.assertIn(f"elements  {counts['elements']:,}\n", out)
        self.assertIn(f"unknowns  {counts['dofs']:,}\n", out)

    def test_prints_wave_speeds_and_conditions_and_writes_nothing(self):
        before = self.tree()
        out, _ = self.tentpole("check", SOURCE / "examples/thesis_bar.toml")
        self.assertRegex(out, r"all +3690 +8906 +5396\n")  # c_p, c_s by hand from E, nu, rho
        self.assertRegex(out, r"left +velocity, rising over 5e-09 s\n")
        self.assertRegex(out, r"top +normal velocity, tangential traction, zero\n")
        self.assertEqual(self.tree(), before)

    def test_work_of_a_mesh_that_changes_is_called_that_of_the_first(self):
        changing, _ = self.tentpole("check", SOURCE / "examples/spall_bar.toml")
        self.assertIn("work of the initial mesh, if it stayed as it is\n", changing)
        fixed, _ = self.tentpole("check", SOURCE / "examples/thesis_bar.toml")
        self.assertIn("\nwork\n", fixed)

    def test_broken_case_is_refused(self):
        self.assertIn("time.end", self.refused("check", "wave.toml", "--set", "time.end=0"))

    def mesh_case(self, mesh):
        """A case with this mesh of tests/host/mesh, copied beside it."""
        shutil.copy(SOURCE / "tests/host/mesh" / mesh, self.folder / "mesh.msh")
        text = WAVE.replace("min = [0.0]\nmax = [1.0]\ncells = [20]", 'mesh = "mesh.msh"')
        text = text[:text.index("[initial]")] + text[text.index("[time]"):text.index("[output]")]
        text = text.replace("dimension = 1", "dimension = 2").replace('periodic = "right"', "absorbing = true")
        for side in ("right", "bottom", "top"):
            text += f"[boundary.{side}]\nabsorbing = true\n"
        (self.folder / "mesh.toml").write_text(text)

    def test_damaged_mesh_file_is_refused_with_line_and_way_out(self):
        self.mesh_case("broken/fewer_nodes_announced.msh")
        self.assertEqual(self.refused("check", "mesh.toml"),
                         'mesh.msh, line 10, $Nodes: "5" stands where $EndNodes must be: the section has more or fewer '
                         "entries than it announces. Save the mesh anew from Gmsh.\n")

    def test_nothing_beside_a_mesh_file_is_run(self):
        self.mesh_case("square_41.msh")
        (self.folder / "mesh.msh.opt").write_text('SystemCall "touch ran";\n')
        before = self.tree()
        self.tentpole("check", "mesh.toml")
        self.assertEqual(self.tree(), before)

    def test_warnings_go_to_stderr(self):
        _, err = self.tentpole("check", "wave.toml", "--set", "discretization.degree=1")
        self.assertIn("warning: ", err)


class Arguments(ProgramTest):
    def test_help_lists_commands_and_options(self):
        out, err = self.tentpole("--help")
        for command in ("run", "check", "compare", "devices", "info", "model", "plot", "Exit codes"):
            self.assertIn(command, out)
        self.assertEqual(err, "")
        out, _ = self.tentpole("run", "--help")
        for option in ("--out DIR", "--offload", "--device N", "--threads N", "--seed N", "--set KEY=VALUE",
                       "--resume FILE", "--check", "--quiet"):
            self.assertIn(option, out)

    def test_version_names_the_build(self):
        self.assertRegex(self.tentpole("--version")[0], r"^tentpole \d+\.\d+\.\d+ \(.+\)\n$")

    def test_wrong_arguments_are_bad_input_and_the_message_names_them(self):
        for arguments, text in (([], "Usage: tentpole"),
                                (["chek", "wave.toml"], 'there is no command chek. Did you mean "check"?'),
                                (["run"], "CASE is required"),
                                (["run", "wave.toml", "--fast"], "--fast"),
                                (["run", "wave.toml", "extra"], "extra"),
                                (["run", "wave.toml", "--threads", "many"], "many"),
                                (["run", "wave.toml", "--set", "degree"], "--set degree: is no override"),
                                (["run", "missing.toml"], "missing.toml: is not a readable file"),
                                (["devices", "--calibrate", "missing/m.toml"], "--calibrate missing/m.toml: cannot be written"),
                                (["model"], "MACHINE is required"),
                                (["model", "machine.toml"], "machine.toml: is not a readable file"),
                                (["model", "machine.toml"], "xeon_phi_knc.toml, xeon_x5680_dual.toml"),
                                (["model", "wave.toml"], "wave.toml:2: domain: unknown key."),
                                (["model", "xeon_phi_knc.toml", "--threads", "4-1"], '--threads 4-1: "4-1" runs backwards'),
                                (["model", "xeon_phi_knc.toml", "--rows", "0"], "--rows 0: must lie in [1, 100000]"),
                                (["model", "xeon_phi_knc.toml", "--rows", "many"], "many"),
                                (["info", "missing"], "missing: there is no such file"),
                                (["info", "wave.toml"], "tentpole check"),
                                (["info", "."], "holds no result")):
            self.assertIn(text, self.refused(*arguments))

    def test_offload_without_a_device_says_what_to_install(self):
        environment = dict(os.environ, OMP_TARGET_OFFLOAD="DISABLED")
        result = subprocess.run([TENTPOLE, "run", "wave.toml", "--offload"], cwd=self.folder, capture_output=True,
                                text=True, env=environment)
        self.assertEqual(result.returncode, 2)
        self.assertIn("no device:", result.stderr)
        self.assertIn("libomp-19-dev", result.stderr)
        self.assertEqual(self.tree(), ["wave.toml"])


class Model(ProgramTest):
    def sweep(self, *arguments):
        out, err = self.tentpole("model", *arguments)
        self.assertEqual(err, "")
        (self.folder / "sweep.csv").write_text(out)
        return out, self.table("sweep.csv")

    def test_prints_a_row_per_thread_count(self):
        out, rows = self.sweep("xeon_phi_knc.toml", "--threads", "1,59-61,30")
        self.assertEqual(out.splitlines()[0], "threads,time,speedup,efficiency,imbalance")
        self.assertEqual([row["threads"] for row in rows], [1, 30, 59, 60, 61])
        self.assertEqual((rows[0]["speedup"], rows[0]["efficiency"], rows[0]["imbalance"]), (1, 1, 0))
        for row in rows:
            self.assertAlmostEqual(row["speedup"] * row["time"] / rows[0]["time"], 1, places=4)
            self.assertAlmostEqual(row["efficiency"] * row["threads"] / row["speedup"], 1, places=4)
        self.assertEqual(self.sweep("xeon_phi_knc.toml", "--threads", "1,59-61,30")[0], out)

    def test_default_is_up_to_twice_the_usable_cores_with_990_rows(self):
        out, rows = self.sweep("xeon_phi_knc.toml")
        self.assertEqual(len(rows), 120)
        self.assertEqual(out, self.sweep(SOURCE / "device/machines/xeon_phi_knc.toml", "--rows", 990)[0])

    def test_calibrated_machine_can_be_modelled(self):
        out = self.tentpole("devices", "--calibrate")[0].splitlines()
        self.assertEqual(out[0], "machine.toml")
        self.assertEqual(out[1].split(), ["threads", "measured", "modelled", "ratio"])
        self.assertEqual([line.split()[0] for line in out[2:]], [str(1 + i) for i in range(len(out) - 2)])
        self.assertEqual(self.sweep("machine.toml")[1][0]["speedup"], 1)
        self.tentpole("devices", "--calibrate", "other.toml")
        self.assertEqual(self.tree(), ["machine.toml", "other.toml", "sweep.csv", "wave.toml"])


class Info(ProgramTest):
    def setUp(self):
        super().setUp()
        self.tentpole("run", "wave.toml", "--out", "r", "--quiet")

    def test_folder_shows_summary_and_files(self):
        out, _ = self.tentpole("info", "r")
        self.assertRegex(out, r"title +a wave on a ring\n")
        self.assertRegex(out, rf"patches +{self.summary('r')['counts']['patches']}\n")
        self.assertIn("3 snapshots", out)

    def test_snapshot_shows_time_and_range_of_fields(self):
        out, _ = self.tentpole("info", "r/snapshot_0002.vtkhdf")
        self.assertIn("snapshot at t = 0.5 s", out)
        self.assertRegex(out, r"displacement +3 +-(1|0\.99\d*|1\.00\d*) +(1|0\.99\d*|1\.00\d*)\n")

    def test_table_shows_first_and_last_row(self):
        out, _ = self.tentpole("info", "r/probe_mid.csv")
        self.assertIn("201 rows", out)
        self.assertRegex(out, r"time +0 +0\.5 +0 +0\.5\n")

    def test_incomplete_run_is_called_incomplete(self):
        (self.folder / "r/summary.json").unlink()
        self.assertIn("not complete", self.tentpole("info", "r")[0])

    def test_damaged_files_are_refused(self):
        (self.folder / "r/snapshot_0001.vtkhdf").write_bytes(b"noise")
        (self.folder / "r/summary.json").write_text("noise")
        (self.folder / "r/probe_mid.csv").write_text("time,ux\n0,zero\n")
        whole = (self.folder / "r/snapshot_0002.vtkhdf").read_bytes()
        (self.folder / "r/snapshot_0002.vtkhdf").write_bytes(whole[:len(whole) // 2])
        (self.folder / "r/checkpoint.h5").write_bytes(whole[:len(whole) // 2])
        for name in ("snapshot_0001.vtkhdf", "snapshot_0002.vtkhdf", "checkpoint.h5", "summary.json", "probe_mid.csv"):
            self.assertIn(name, self.refused("info", f"r/{name}"))


class Devices(ProgramTest):
    def test_host_is_listed_with_rates(self):
        out, _ = self.tentpole("devices")
        self.assertRegex(out, r"- +host +\d+ +[\d.]+ [GM]B/s +[\d.]+ [GM]B/s +[\d.]+ us")


class Plot(ProgramTest):
    """The script is looked for beside the program, so a copy of the program stands in a tree of its own."""

    def tree_with_script(self, program, script):
        for path in (program, script):
            (self.folder / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(TENTPOLE, self.folder / program)
        (self.folder / script).write_text("import sys\nprint(sys.argv[1:])\nsys.exit(7)\n")
        result = subprocess.run([self.folder / program, "plot", "r", "--time", "1e-8", "--help"], cwd=self.folder,
                                capture_output=True, text=True)
        return result.returncode, result.stdout

    def test_script_of_the_source_tree_gets_all_arguments(self):
        self.assertEqual(self.tree_with_script("build/host/tentpole", "scripts/plot.py"),
                         (7, "['r', '--time', '1e-8', '--help']\n"))

    def test_installed_script_is_found(self):
        self.assertEqual(self.tree_with_script("usr/bin/tentpole", "usr/share/tentpole/scripts/plot.py"),
                         (7, "['r', '--time', '1e-8', '--help']\n"))

    def test_missing_script_is_named(self):
        shutil.copy(TENTPOLE, self.folder / "tentpole")
        result = subprocess.run([self.folder / "tentpole", "plot", "r"], capture_output=True, text=True)
        self.assertEqual(result.returncode, 2)
        self.assertIn("plot.py", result.stderr)


if __name__ == "__main__":
    main()
