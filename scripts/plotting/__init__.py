"""Pictures of a result folder; scripts/plot.py is the way in. Files are described in docs/results.md."""
import os

# File systems without locks are read too; HDF5 looks at this when h5py is first imported.
os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")
