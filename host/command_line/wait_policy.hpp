#pragma once

namespace tentpole {

/// Makes idle OpenMP threads sleep (OMP_WAIT_POLICY=passive) unless the environment says otherwise. The runtimes spin
/// by default, on the very cores that pitch the next batch and write output: measured on 2 busy cores, a run of
/// examples/thesis_bar.toml spends half the time in assembly and solution when they sleep. They read the variable when
/// they are loaded, so the program starts itself once more; if that fails it goes on as it is.
void sleep_idle_threads(char** argv);

}  // namespace tentpole
