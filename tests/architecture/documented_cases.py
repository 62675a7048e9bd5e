"""Every complete case file in the documentation, and every example, is one that the program accepts.

usage: documented_cases.py ROOT TENTPOLE        runs `TENTPOLE check` on each; exit code 0 if all are accepted
"""

import pathlib
import re
import subprocess
import sys
import tempfile

TOML_BLOCK = re.compile(r"^```toml\n(.*?)^```", re.MULTILINE | re.DOTALL)


def case_files(text):
    """The TOML blocks of a Markdown page that are whole case files, not excerpts."""
    return [block for block in TOML_BLOCK.findall(text) if "[domain]" in block and "[time]" in block]


def main(root, tentpole):
    root = pathlib.Path(root).resolve()
    with tempfile.TemporaryDirectory() as folder:
        cases = sorted((root / "examples").glob("*.toml"))
        for page in [root / "README.md", *sorted((root / "docs").glob("*.md"))]:
            for number, text in enumerate(case_files(page.read_text(encoding="utf-8")), 1):
                cases.append(pathlib.Path(folder) / f"{page.stem}_{number}.toml")
                cases[-1].write_text(text, encoding="utf-8")
        refused = 0
        for case in cases:
            result = subprocess.run([tentpole, "check", case], capture_output=True, text=True)
            if result.returncode != 0:
                refused += 1
                print(f"{case.name}: exit code {result.returncode}\n{result.stdout}{result.stderr}")
        print(f"{len(cases)} case files, {refused} refused")
        return 1 if refused or not cases else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
