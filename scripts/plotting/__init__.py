"""Pictures of a result folder; scripts/plot.py is the way in. Files are described in docs/results.md."""
