"""What a kernel may take (gpu_image_limits.toml), and what of an image does not keep to it."""
import tomllib
from typing import NamedTuple

from gpu.kernel_name import function_of

ALLOWANCE = 1.05  # a compiler's next version or an edit elsewhere moves stacks by a few bytes


class Limits(NamedTuple):
    path: str
    architecture: str
    registers: int
    programs: dict  # {program: {function: {"name": text, "stack": bytes}}}

    def record(self, function):
        return next((kernels[function] for kernels in self.programs.values() if function in kernels), None)

    def name(self, function):
        record = self.record(function)
        return record["name"] if record else function


def read_limits(path):
    """ValueError says what is wrong with the file."""
    with open(path, "rb") as stream:
        content = tomllib.load(stream)
    try:
        programs = content["program"]
        for program, kernels in programs.items():
            for function, record in kernels.items():
                if not isinstance(record["stack"], int) or not isinstance(record["name"], str):
                    raise ValueError(f'[program.{program}], "{function}": name must be a text, stack a number of bytes')
        return Limits(str(path), str(content["architecture"]), int(content["registers"]), programs)
    except (KeyError, TypeError, AttributeError) as error:
        raise ValueError(f"{error} is missing or of another type") from error


def record_line(function, kernel):
    """The line that records a kernel as it is."""
    stack = int((kernel.stack or 0) * ALLOWANCE)
    return f'"{function}" = {{ name = "{function}", stack = {stack} }}'


def _findings_of(function, kernel, limits):
    name = limits.name(function)
    record = limits.record(function)
    if kernel.mode != "SPMD":
        yield (f"{name}: execution mode {kernel.mode}, limit SPMD. Put `parallel` directly inside `target teams`, with no statement "
               "between them (kernels/launch/launch.hpp).")
    if kernel.heap_calls:
        calls = ", ".join(f"{count} of {callee} in {function_of(caller)}" for (caller, callee), count in sorted(kernel.heap_calls.items()))
        yield (f"{name}: {sum(kernel.heap_calls.values())} calls of the heap, limit 0 ({calls}). Local variables belong to a lane "
               "(-fopenmp-cuda-mode), schedules of loops are not dynamic, scratch is an argument.")
    if kernel.registers > limits.registers:
        yield (f"{name}: {kernel.registers} registers, limit {limits.registers}. A number of threads that only the launch knows leaves "
               "the bound to -maxrregcount (device/offload.cmake).")
    if kernel.stack is None:
        yield (f"{name}: stack cannot be known before it runs, limit {record['stack'] if record else 'none recorded'}. Leave out recursion, "
               "calls through pointers and parallel regions inside of parallel regions.")
    elif record and kernel.stack > record["stack"]:
        yield (f"{name}: {kernel.stack} B of stack, limit {record['stack']} B. Make arrays of its functions smaller or share them out; "
               f"if it must be so, record {int(kernel.stack * ALLOWANCE)} in {limits.path}.")
    if not record:
        yield (f"{name}: no limit is recorded. Add to [program.NAME] of {limits.path}, with a name that a reader knows: "
               f"{record_line(function, kernel)}")


def findings(program, kernels, limits):
    """Faults of an image, a line each. kernels: {function: Kernel}."""
    found = [line for function, kernel in kernels.items() for line in _findings_of(function, kernel, limits)]
    for function, record in limits.programs.get(program, {}).items():
        if function not in kernels:
            found.append(f"{record['name']}: {function} is recorded for {program}, and its image has no such kernel. If it was renamed or "
                         f"removed, do so in {limits.path}; else something was not linked.")
    return found
