"""killed_writer.py WRITER SOURCE: kill -9 at any moment leaves complete files under their final names."""
import json
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from vtkhdf import read_grid


def check_folder(folder):
    """Reads everything that has a final name; returns how many VTKHDF files there are."""
    snapshots = sorted(folder.glob("snapshot_*.vtkhdf")) + sorted(folder.glob("cracks_*.vtkhdf"))
    for path in snapshots:
        # There is no crack in the beginning.
        assert read_grid(path).GetNumberOfCells() > 0 or path.name.startswith("cracks"), path
    for series in folder.glob("*.series"):
        for entry in json.loads(series.read_text())["files"]:
            assert (folder / entry["name"]).exists(), entry
    if (folder / "summary.json").exists():
        json.loads((folder / "summary.json").read_text())
    for path in list(folder.glob("probe_*.csv")) + list(folder.glob("history.csv")):
        # The system may end an append of a killed process between two pages: the beginning of a line can be the last.
        whole, _, _ = path.read_text().rpartition("\n")
        assert len({line.count(",") for line in whole.split("\n")}) == 1, path.read_text()
    return len(snapshots)


def main():
    writer, num_snapshots, num_partial = sys.argv[1], 0, 0
    for attempt in range(12):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            field, awaited = ("quadratic", "snapshot_0002.vtkhdf") if attempt < 8 else ("crack", "cracks_0008.vtkhdf")
            process = subprocess.Popen([writer, name, "1" if attempt >= 8 else "2", "2", field, "1", "100000"])
            while not (folder / awaited).exists():
                time.sleep(0.001)
            time.sleep(0.0037 * attempt)
            process.send_signal(signal.SIGKILL)
            assert process.wait() == -signal.SIGKILL, "the writer ended before it was killed"
            num_snapshots += check_folder(folder)
            num_partial += len(list(folder.glob(".*.partial")))
    assert num_snapshots >= 12
    print(f"{num_snapshots} VTKHDF files readable after 12 kills; {num_partial} partial files were caught")


if __name__ == "__main__":
    main()
