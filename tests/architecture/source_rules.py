"""Rules that the source tree obeys and no compiler checks. Each function takes the root folder and returns its
findings, one line "FILE:LINE: what is wrong and what to do" each.

usage: source_rules.py ROOT RULE...        prints the findings; exit code 0 none, 1 some, 2 unknown rule
"""

import pathlib
import re
import sys

# Whom each folder may include: the architecture in one table. Only bench and tests include bench or tests.
MAY_INCLUDE = {
    "common": {"common"},
    "kernels": {"common", "kernels"},
    "device": {"common", "device"},
    "host": {"common", "kernels", "device", "host"},
    "bench": {"common", "kernels", "device", "host", "bench", "tests"},
    "tests": {"common", "kernels", "device", "host", "bench", "tests"},
}
# The rooms of the host in their order: a room includes itself and those before it.
HOST_ROOMS = ("mesh", "case_file", "problem", "fracture", "front", "output", "batch", "field", "books", "march", "run", "many_core",
              "command_line")
# Libraries whose headers cost seconds in every file that sees them: only a .cpp may include them.
HEAVY_HEADER = re.compile(r"(toml\+\+|toml|CLI|nlohmann|Eigen|muParser\w*|hdf5\w*|H5\w*|vtk\w*)[./]")
INCLUDE = re.compile(r'\s*#\s*include\s*(["<])([^">]+)[">]')
FAULTY_SCHEDULE = re.compile(r"schedule\s*\(\s*(static\s*,\s*1\s*\)|(nonmonotonic\s*:\s*)?(dynamic|guided)\b)")
MACHINE_PATH = re.compile(r"(?<![\w.})>*-])/(work|root|home|tmp|Users)(?![\w.-])")
FIXED_FOLDER = re.compile(r"\bTempDir\s*\(|\btemp_directory_path\b|\bmkdtemp\b|\btmpnam\b|\bgettempdir\b|\btempfile\.mktemp\b")
MOST_LINES_OF_A_FILE, MOST_LINES_OF_A_FUNCTION, MOST_ARGUMENTS = 350, 60, 6
BLOCK = re.compile(r"( *)(?!namespace|class|struct|enum|union|extern|#|//)\S.*\{$")
# The head of a function: its name, after a type, and its arguments, up to the body or the end of the declaration.
FUNCTION_HEAD = re.compile(r"^(?!return|else|#|//)[\w:<>,\[\]&* ]*?[\w>&*\]] [&*]?(\w+)\(((?:[^(){};]|\([^(){};]*\))*)\)[^(){};=]*[{;]",
                           re.MULTILINE)
NAMED_FILE = re.compile(r"`((?:common|kernels|device|host|bench|tests|scripts|examples|docs)/[\w./-]+)`")
UNFINISHED = re.compile(r"\b(TODO|FIXME)\b")
TEXT_SUFFIXES = {".cpp", ".hpp", ".cmake", ".txt", ".md", ".toml", ".json", ".py", ".in", ".csv", ""}


def files(root, suffixes, folders=None):
    """Files under the given folders (default: everywhere), without build products, results and this checker."""
    # Build folders are never entered: tests that run at the same time create and remove files there.
    for top in sorted(root.iterdir()):
        if top.name.startswith((".git", ".gpu", "build", "gpu_out", "result", "report")) or (folders and top.name not in folders):
            continue
        for path in sorted(top.rglob("*")) if top.is_dir() else [top]:
            parts = path.relative_to(root).parts
            if "__pycache__" not in parts and parts[:2] != ("tests", "architecture"):
                if path.suffix in suffixes and path.is_file():
                    yield path


def matching_lines(root, paths, pattern, message):
    found = []
    for path in paths:
        for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
            if pattern.search(line):
                found.append(f"{path.relative_to(root)}:{number}: {message}")
    return found


def includes(root):
    """Quoted includes start at the root, exist and point down; heavy headers stay out of headers."""
    found = []
    for path in files(root, {".hpp", ".cpp"}, MAY_INCLUDE):
        folder = path.relative_to(root).parts[0]
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            quote, name = match.groups()
            where = f"{path.relative_to(root)}:{number}"
            target = name.split("/")[0]
            if quote == '"' and target not in MAY_INCLUDE:
                found.append(f'{where}: "{name}" does not start with a folder of the root')
            elif target in MAY_INCLUDE and target not in MAY_INCLUDE[folder]:
                allowed = ", ".join(sorted(MAY_INCLUDE[folder]))
                found.append(f"{where}: {folder}/ must not include {name} (it may include {allowed})")
            elif quote == '"' and not (root / name).exists() and not (root / (name + ".in")).exists():
                found.append(f'{where}: "{name}" does not exist')
            elif quote == "<" and path.suffix == ".hpp" and HEAVY_HEADER.match(name):
                found.append(f"{where}: include <{name}> in a .cpp, it is too heavy for a header")
    return found


def rooms(root):
    """Within host/ includes point one way, too: up in the table HOST_ROOMS. Every file of the host is in a room."""
    found = []
    for path in files(root, {".hpp", ".cpp"}, {"host"}):
        name, room = path.relative_to(root), path.relative_to(root).parts[1]
        if room not in HOST_ROOMS:
            found.append(f"{name}:1: {room} is no room of the host; the table HOST_ROOMS of tests/architecture/source_rules.py has them")
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = re.match(r'\s*#\s*include\s*"host/(\w+)/', line)
            if match and match[1] not in HOST_ROOMS[:HOST_ROOMS.index(room) + 1]:
                found.append(f"{name}:{number}: host/{room} must not include host/{match[1]}, which comes after it")
    return found


def circles(root):
    """No headers include each other in a circle."""
    graph = {}
    for path in files(root, {".hpp"}, MAY_INCLUDE):
        matches = map(INCLUDE.match, path.read_text(encoding="utf-8").splitlines())
        graph[str(path.relative_to(root))] = [match[2] for match in matches if match and match[1] == '"']
    found, done = [], set()

    def visit(name, way):
        if name in way:
            found.append(f"{name}:1: includes itself by way of {', '.join(way[way.index(name) + 1:]) or 'nothing else'}")
        elif name not in done:
            for target in graph.get(name, []):
                visit(target, [*way, name])
            done.add(name)

    for name in graph:
        visit(name, [])
    return found


def listed(root):
    """Every .cpp is named in the CMakeLists.txt of its folder or of one above: an unlisted test never runs."""
    found = []
    for path in files(root, {".cpp"}, MAY_INCLUDE):
        folders = [folder for folder in path.parents if folder.is_relative_to(root)]
        lists = [folder / "CMakeLists.txt" for folder in folders if (folder / "CMakeLists.txt").exists()]
        name = re.compile(rf"(?<![\w.-]){re.escape(path.name)}(?![\w.-])")
        stem = re.compile(rf"(?<![\w.-]){re.escape(path.stem)}(?![\w-])")
        if not any(name.search(text) or stem.search(text) for text in (each.read_text() for each in lists)):
            found.append(f"{path.relative_to(root)}:1: not named in any CMakeLists.txt, so it is never compiled")
    return found


def schedule(root):
    """Two faults of LLVM 19: a team of one thread runs one iteration of n with schedule(static, 1), and where chunks of a
    dynamic schedule may be stolen (without "monotonic") the runtime now and then aborts in kmp_dispatch.cpp."""
    message = "schedule(static, 1) loses iterations and dynamic without monotonic may abort in LLVM 19"
    return matching_lines(root, files(root, {".hpp", ".cpp"}), FAULTY_SCHEDULE, message)


def paths(root):
    message = "absolute path of one machine, use a relative or a temporary one"
    return matching_lines(root, files(root, TEXT_SUFFIXES), MACHINE_PATH, message)


def temporary(root):
    """Tests and scripts of two checkouts or two users run beside each other: no name in the temporary folder is fixed."""
    checked = [path for path in files(root, {".hpp", ".cpp", ".py", ""}, {"tests", "bench", "scripts"})
               if path.name != "temporary_folder.hpp"]
    message = "names in the temporary folder are not fixed, use TemporaryFolder or test_folder of tests/, in Python TemporaryDirectory"
    return matching_lines(root, checked, FIXED_FOLDER, message)


def _num_arguments(text):
    """Commas outside of brackets, and one more."""
    depth = count = 0
    for letter in text:
        depth += (letter in "<([{") - (letter in ">)]}")
        count += letter == "," and depth == 0
    return count + bool(text.strip())


def sizes(root):
    """Files, functions and lists of arguments that fit in a head. A function is a block that ends where it is indented."""
    found = []
    for path in files(root, {".hpp", ".cpp"}, {"common", "kernels", "device", "host"}):
        name, text = path.relative_to(root), path.read_text(encoding="utf-8")
        lines = text.splitlines()
        if len(lines) > MOST_LINES_OF_A_FILE:
            found.append(f"{name}:1: has {len(lines)} lines, more than {MOST_LINES_OF_A_FILE}: which two ideas are in it?")
        for number, line in enumerate(lines):
            match = BLOCK.match(line)
            if not match or len(match[1]) > 2:
                continue
            length = next((i for i, other in enumerate(lines[number:]) if other.startswith(match[1] + "}")), 0) + 1
            if length > MOST_LINES_OF_A_FUNCTION:
                found.append(f"{name}:{number + 1}: a function of {length} lines, more than {MOST_LINES_OF_A_FUNCTION}: name its steps")
        if name.parts[0] == "kernels":
            for match in FUNCTION_HEAD.finditer(text):
                if _num_arguments(match[2]) > MOST_ARGUMENTS:
                    number = text.count("\n", 0, match.start()) + 1
                    found.append(f"{name}:{number}: {match[1]} has more than {MOST_ARGUMENTS} arguments: a struct is missing")
    return found


def named(root):
    """Files that a page names are there. Pages of decisions and measurements speak of their day."""
    found = []
    for path in files(root, {".md"}):
        if path.name == "CHANGELOG.md" or path.parent.name in ("decisions", "measurements"):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            for name in NAMED_FILE.findall(line):
                # A name may leave out its suffix.
                if not any(True for _ in root.glob(name + "*")):
                    found.append(f"{path.relative_to(root)}:{number}: {name} does not exist")
    return found


def unfinished(root):
    message = "unfinished work is not marked in the source, finish it or open an issue"
    return matching_lines(root, files(root, TEXT_SUFFIXES), UNFINISHED, message)


RULES = {rule.__name__: rule for rule in (includes, rooms, circles, listed, named, sizes, schedule, paths, temporary, unfinished)}


def main(root, *names):
    unknown = [name for name in names if name not in RULES]
    if unknown or not names:
        print(f"unknown rules {unknown}, known are {', '.join(RULES)}", file=sys.stderr)
        return 2
    findings = [line for name in names for line in RULES[name](pathlib.Path(root).resolve())]
    print("\n".join(findings))
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
