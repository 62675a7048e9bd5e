"""The report of scripts/reproduce_thesis: reads what the drivers and the model wrote, and sets it beside the thesis."""
