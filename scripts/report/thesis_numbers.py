"""What the text of the thesis states [Marwah 2014, chapter 3]; its curves are pictures and not reproduced here."""

STAGES = ["assembly", "solution", "post"]
# Tables 3.1 to 3.4, per cent of the time of the physics code, k = 7. Table 3.5 is announced, but the source ends before it.
PROFILES = {
    "3.1": ("library_operators", (69.88, 29.37, 0.68), "library operators"),
    "3.2": ("sequential", (42.29, 56.25, 1.33), "sequential optimisation"),
    "3.3": ("vectorized", (34.27, 64.05, 1.53), "and vectorization"),
    "3.4": ("threaded_rows", (20.40, 77.07, 2.32), "and 12 threads"),
}
PROFILE_NOTE = {"3.4": "The text of the thesis says 70.07 % for the solution, its table 77.07 %; the table adds up, so "
                       "it is used."}

# Speedups of the assembly, k = 7.
SEQUENTIAL, VECTORIZED, THREADED, NET = 3.2, 1.45, 2.29, 10.6
HOST_THREADS, HOST_EFFICIENCY = 12, 0.1906
CARD_THREADS, CARD_SPEEDUP, CARD_EFFICIENCY = 60, 33.17, 0.5528
BEST_BALANCED_THREADS = 30

DEGREES = range(1, 8)


def unknowns(degree):
    """n = 3 C(k + 4, 4): three components in three space dimensions and time."""
    return 3 * (degree + 1) * (degree + 2) * (degree + 3) * (degree + 4) // 24


def is_balanced(imbalance):
    """Section 3.3.4: u/p = 0 or > 0.9 with u = n mod p."""
    return imbalance == 0 or imbalance > 0.9
