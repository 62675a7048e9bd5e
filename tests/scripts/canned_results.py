"""Small result files as the drivers write them, for the tests of the report."""
import json

STAGES = {"library_operators": (70, 29, 1), "sequential": (42, 56, 2), "vectorized": (34, 64, 2),
          "threaded_rows": (20, 77, 3), "offload_persistent": (30, 69, 1), "ours": (10, 85, 5)}
SECONDS = {"library_operators": 12.0, "sequential": 4.0, "vectorized": 2.5, "threaded_rows": 1.25}
CONTEXT = {"date": "2026-11-24", "compiler": "clang <19>", "commit": "abc1234", "device": "virtual_cpu: 2 threads", "cores": "2",
           "dgemm_1_GF/s": "40"}


def entry(name, milliseconds, **counters):
    return {"name": name + "/real_time", "run_name": name + "/real_time", "run_type": "iteration", "real_time": milliseconds,
            "cpu_time": milliseconds, "time_unit": "ms", "iterations": 1, **counters}


def profile():
    for stages, percent in STAGES.items():
        names = [f"{stage}_%" for stage in ("assembly", "solution", "post")]
        seconds = {f"{stage}_s": share / 10 for stage, share in zip(("assembly", "solution", "post"), percent)}
        threads = 2 if stages == "threaded_rows" else 1
        yield entry(f"profile/{stages}/d:4/k:7/K:2/threads:{threads}", 1e4, n=990, N=1980, **dict(zip(names, percent)), **seconds)


def assembly():
    for rung, seconds in SECONDS.items():
        for k in (6, 7):
            for factor in (1, 3):  # repetitions; the median counts
                yield entry(f"assembly/{rung}/d:4/k:{k}/threads:1/iterations:1", 1e3 * seconds * factor,
                            s_per_cell=seconds * factor)


def sweep(kind, k):
    for p, speedup in ((1, 1.0), (2, 1.5), (4, 1.4)):
        yield entry(f"threads/{kind}/d:4/k:{k}/threads:{p}", 10 / speedup, n=990, speedup=speedup,
                    efficiency=speedup / p, imbalance=0)


def traffic():
    for mode, milliseconds in (("host", 8), ("transfer", 40), ("persistent", 10), ("overlapped", 9)):
        for k in (6, 7):
            yield entry(f"traffic/{mode}/d:4/k:{k}/threads:2", milliseconds * k, bytes_up=100, bytes_down=50, launches=3,
                        **{"transfer_%": 10})


def solution():
    for variant, K in (("lapack", 2), ("lapack", 1), ("batched", 2), ("eigen", 2)):
        for p in (1, 2):
            yield entry(f"lu/{variant}/d:4/k:3/K:{K}/threads:{p}", 5 / p, n=105, N=105 * K, speedup=p, efficiency=1.0, **{"GF/s": 5})


def gpu_patches():
    for D, k, host in ((2, 2, 5e4), (2, 3, 2e4)):
        yield entry(f"solve_patches/D:{D}/k:{k}/patches:256/threads:2", 5, **{"patches/s": host})
        for lanes in (32, 64):
            yield entry(f"device_patches/D:{D}/k:{k}/patches:4096/teams:2112/lanes:{lanes}", 5, **{"patches/s": host * lanes / 4})


def write_gpu(folder):
    """What bench_patch leaves on a machine with a GPU."""
    context = dict(CONTEXT, device="GPU (nvptx64 image): Canned")
    (folder / "bench_patch.json").write_text(json.dumps({"context": context, "benchmarks": list(gpu_patches())}))


def write(folder, drivers=None):
    """Writes DRIVER.json for the drivers named, all by default."""
    files = {"bench_profile": profile(), "bench_assembly": assembly(),
             "bench_threads": [*sweep("rows", 7), *sweep("device_rows", 7)], "bench_traffic": traffic(), "bench_lu": solution()}
    folder.mkdir(parents=True, exist_ok=True)
    for driver in drivers if drivers is not None else files:
        (folder / f"{driver}.json").write_text(json.dumps({"context": CONTEXT, "benchmarks": list(files[driver])}))
