"""Runs the cells of the notebooks beside it one after the other, by plain Python with NumPy, without Jupyter.

python3 run.py > outputs.json, after a change of the notebooks (vitest --update writes them); NumPy 1.24 or later.
"""

import contextlib
import io
import json
import pathlib


def printed(path):
    """What a notebook's code cells print."""
    cells = json.loads(path.read_text())["cells"]
    names, out = {}, io.StringIO()
    with contextlib.redirect_stdout(out):
        for cell in cells:
            if cell["cell_type"] == "code":
                exec("".join(cell["source"]), names)
    return out.getvalue().split()


here = pathlib.Path(__file__).parent
print(json.dumps({path.stem: printed(path) for path in sorted(here.glob("*.ipynb"))}, indent=1))
