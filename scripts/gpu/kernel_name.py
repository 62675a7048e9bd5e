"""Readable names of kernels from the symbols of OpenMP target regions.

A region of a function has the symbol __omp_offloading_DEVICE_FILE_FUNCTION_lLINE. Device, file and line change with the machine and
with every edit; what stays is the function: `run_on_gpu<2>`, `loop_on_gpu<Transplant<3>>`, `target_runtime::pack_rows`.
"""
import re

SYMBOL = re.compile(r"__omp_offloading_[0-9a-f]+_[0-9a-f]+_(.+)_l(\d+)$")
BUILTIN = {"b": "bool", "c": "char", "d": "double", "f": "float", "i": "int", "j": "unsigned", "l": "long", "m": "unsigned long"}
DROPPED = {"tentpole", "_GLOBAL__N_1"}


class _Reader:
    """The part of the Itanium C++ ABI's mangling that names of functions and their template arguments need."""

    def __init__(self, text):
        self.text, self.position = text, 0

    def take(self, pattern):
        match = re.compile(pattern).match(self.text, self.position)
        if not match:
            raise ValueError(f"{self.text}: unknown mangling at {self.position}")
        self.position = match.end()
        return match

    def ahead(self, characters):
        return self.position < len(self.text) and self.text[self.position] in characters

    def plain_name(self):
        length = int(self.take(r"\d+").group())
        return self.take(f".{{{length}}}").group()

    def argument(self):
        if self.ahead("L"):
            return self.take(r"L[a-z](n?\d+)E").group(1).replace("n", "-")
        return self.name() if self.ahead("NS0123456789") else BUILTIN[self.take("[a-z]").group()]

    def name(self):
        """A name with its scopes and template arguments; our own namespaces and repeated scopes are left out."""
        nested = self.ahead("N")
        if nested:
            self.take("N[rVK]*")
        parts = []
        while not self.ahead("E"):
            if self.ahead("S"):
                self.take(r"S[0-9A-Z]*_")
            elif self.ahead("I"):
                self.take("I")
                arguments = []
                while not self.ahead("E"):
                    arguments.append(self.argument())
                self.take("E")
                parts[-1] += f"<{', '.join(arguments)}>"
            elif parts and not nested:
                break
            else:
                parts.append(self.plain_name())
        if nested:
            self.take("E")
        return "::".join(part for part in parts if part not in DROPPED)


def function_of(symbol):
    """The function whose target region a kernel is; the symbol itself where its name is none of the known forms."""
    match = SYMBOL.match(symbol)
    mangled = match.group(1) if match else symbol.removesuffix("_$_internalized")
    try:
        reader = _Reader(mangled)
        reader.take("_Z")
        return reader.name()
    except (ValueError, KeyError, IndexError):
        return mangled


def line_of(symbol):
    """The line of the target region in its file; 0 where the name is none of the known forms."""
    match = SYMBOL.match(symbol)
    return int(match.group(2)) if match else 0
