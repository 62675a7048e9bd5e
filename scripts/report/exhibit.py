"""What the report shows: tables and figures, each with parts that are either measured or modelled, never both."""
import csv
from dataclasses import dataclass, field


@dataclass
class Part:
    """One set of numbers, its file NAME.csv and, if it has a drawing, NAME.png."""
    name: str
    nature: str  # "measured" or "modelled"
    source: str  # machine and program
    columns: list
    rows: list
    draw: object = None  # function of matplotlib axes

    def write_csv(self, folder):
        with open(folder / f"{self.name}.csv", "w", newline="", encoding="utf-8") as stream:
            writer = csv.writer(stream)
            writer.writerow([f"# {self.nature}: {self.source}"])
            writer.writerow(self.columns)
            writer.writerows(self.rows)


@dataclass
class Exhibit:
    number: str  # "3.1"
    kind: str  # "Table" or "Figure"
    title: str
    caption: str
    comparison: list = field(default_factory=list)  # rows (quantity, thesis, here, nature)
    parts: list = field(default_factory=list)
    missing: list = field(default_factory=list)  # why a part is not there

    @property
    def name(self):
        return f"{self.kind.lower()}_{self.number.replace('.', '_')}"

    def add(self, part, reason):
        """Adds a part that has rows; otherwise keeps the reason why there is none."""
        if part.rows:
            self.parts.append(part)
        else:
            self.missing.append(f"{part.nature.capitalize()}: {reason}")


def number(value, digits=3):
    """A number for people; a dash where there is none."""
    return "–" if value is None else f"{value:.{digits}g}" if abs(value) < 100 else f"{value:.0f}"
