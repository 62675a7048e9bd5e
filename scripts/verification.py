"""What the scripts verify_* have in common."""
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def program_and_options(documentation):
    """PROGRAM and the options for it from the command line. Prints the documentation for --help; ends with 2 where there is no program."""
    arguments = sys.argv[1:]
    if "--help" in arguments:
        print(documentation)
        sys.exit(0)
    program = arguments.pop(0) if arguments and not arguments[0].startswith("-") else str(ROOT / "build/virtual/tentpole")
    if not os.access(program, os.X_OK):
        name = pathlib.Path(sys.argv[0]).name
        print(f"{name}: there is no program {program}. Build it with scripts/build, or give it first.", file=sys.stderr)
        sys.exit(2)
    return program, arguments


def solve(program, example, folder, settings, options):
    """Runs an example into a folder with settings KEY=VALUE; its summary. Ends with the program's exit code where that fails."""
    chosen = [item for setting in settings for item in ("--set", setting)]
    command = [program, "run", str(ROOT / "examples" / example), "--out", str(folder), "--quiet", *chosen, *options]
    code = subprocess.run(command).returncode
    if code != 0:
        print(f"{pathlib.Path(sys.argv[0]).name}: {' '.join(command)} failed.", file=sys.stderr)
        sys.exit(code)
    return json.loads((folder / "summary.json").read_text())
