"""What gpu_visit left in a folder. Missing and damaged files are told, not guessed at."""
import json
import re
from typing import NamedTuple

from report.benchmark_file import BenchmarkFile

STEP_LINE = re.compile(r"^=== (\S+) \(([^,]+), ([\d.]+) s\)$")


class Step(NamedTuple):
    name: str
    code: str     # exit code as text, "skipped" or "absent"
    seconds: float
    output: str   # its part of log.txt

    @property
    def failed(self):
        return self.code not in ("0", "skipped", "absent")


class VisitResults:
    """steps: of steps.tsv, in their order; bundle, image, profile, benchmarks {step: BenchmarkFile}: of the files of these names;
    errors: (step, benchmark, message); missing: what is wrong with the files."""

    def __init__(self, folder):
        self.missing = []
        outputs = self._outputs(folder / "log.txt")
        self.steps = []
        for line in self._read(folder / "steps.tsv", "").splitlines():
            cells = line.split("\t")
            if len(cells) == 3:
                self.steps.append(Step(cells[0], cells[1], float(cells[2]), outputs.get(cells[0], "")))
        self.bundle = dict(line.split(": ", 1) for line in self._read(folder / "bundle.txt", "").splitlines() if ": " in line)
        documents = self._json(folder / "benchmarks.json")
        self.benchmarks = {name: BenchmarkFile(document) for name, document in documents.items()}
        self.errors = [(name, *error) for name, document in documents.items() for error in _errors(document)]
        self.image = self._json(folder / "image.json")
        self.profile = self._json(folder / "profile.json")

    def step(self, name):
        return next((step for step in self.steps if step.name == name), None)

    def machine(self):
        """{key: text} of the step `machine`."""
        step = self.step("machine")
        pairs = re.findall(r"^([a-z-]+): +(.*)$", step.output if step else "", re.MULTILINE)
        return dict(reversed(pairs))  # the first of a key counts

    def _read(self, path, otherwise):
        if path.exists():
            return path.read_text(encoding="utf-8", errors="replace")
        self.missing.append(f"{path.name} is not there")
        return otherwise

    def _json(self, path):
        try:
            return json.loads(self._read(path, "{}"))
        except ValueError as error:
            self.missing.append(f"{path.name} cannot be read ({error})")
            return {}

    def _outputs(self, path):
        outputs, name = {}, None
        for line in self._read(path, "").splitlines():
            match = STEP_LINE.match(line)
            if match:
                name = match.group(1)
                outputs[name] = []
            elif name:
                outputs[name].append(line)
        return {name: "\n".join(lines).strip("\n") for name, lines in outputs.items()}


def _errors(document):
    """Benchmarks that ended with an error, with its message."""
    return [(entry.get("name", "?"), entry.get("error_message", "")) for entry in document.get("benchmarks", [])
            if entry.get("error_occurred")]


class Comparison(NamedTuple):
    """What `tentpole compare` printed: its title, {stage: (host, device, ratio)} as texts, and the difference of the solutions."""
    title: str
    mesh: str
    stages: dict
    difference: str


def comparison(output):
    """None where the run did not come to its end."""
    stages = dict((match[1], match.groups()[1:]) for match in
                  re.finditer(r"^  (\S+)  +(\d.*? (?:s|min))  +(\d.*? (?:s|min))  +(\S+)$", output, re.MULTILINE))
    difference = re.search(r"^largest relative difference of the solutions\n +(.*)$", output, re.MULTILINE)
    mesh = re.search(r"^  mesh +(.*)$", output, re.MULTILINE)
    if "total" not in stages or not difference:
        return None
    lines = [line for line in output.splitlines() if line.strip()]
    title = next((before for before, line in zip(lines, lines[1:]) if re.match("  mesh ", line)), "")
    return Comparison(title, mesh[1] if mesh else "", stages, difference[1])
