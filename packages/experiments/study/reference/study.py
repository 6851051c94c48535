"""What pandas makes of log.jsonl: python study.py > study.json

Needs pandas. Writes the table that `botgarten replay` prints, worked out anew, and what the lines in docs/study.md print: run as
they stand there.
"""
import contextlib
import io
import json
import os
import pathlib
import re

import pandas as pd

here = pathlib.Path(__file__).parent
docs = (here / "../../../../docs/study.md").read_text(encoding="utf-8")
log = pd.read_json(here / "log.jsonl", lines=True)


def pulls(own):
    """A pull of a knob is over where it rests for a second."""
    moved = own[own.event == "knob"]
    rests = moved.groupby(["session", "brain", "from", "to", "set"]).t.diff()
    return int((rests.isna() | (rests >= 1000)).sum())


def first_run(own):
    runs = own[(own.session == own.session.iloc[0]) & (own.event == "run")]
    return None if runs.empty else float(runs.t.iloc[0]) / 1000


def row(pseudonym, own):
    counts = own.event.value_counts()
    green = own[(own.event == "check") & (own.passed == True)]  # noqa: E712
    return {
        "pseudonym": pseudonym,
        "group": int(own.group.dropna().iloc[0]),
        "sessions": int(own.session.nunique()),
        "seconds": float(own.groupby("session").t.max().sum()) / 1000,
        "places": int(own.place.nunique()),
        "firstRun": first_run(own),
        "tries": int(counts.get("run", 0)),
        "knobs": pulls(own),
        "edits": int(counts.get("edit", 0)),
        "steps": int(counts.get("step", 0)),
        "hints": int(counts.get("hint", 0)),
        "checks": len(green[["at", "check"]].drop_duplicates()),
    }


def run_lines(code):
    """What the lines print, with log.jsonl beside them."""
    shown = io.StringIO()
    os.chdir(here)
    with contextlib.redirect_stdout(shown):
        exec(code, {})
    return [line.split() for line in shown.getvalue().splitlines()]


# "place" of a thing that was put somewhere is "thing": a card's place is that of its session's last line "open".
log["place"] = log.place.where(log.event == "open")
log["at"] = log.groupby("session").place.ffill()
lines = re.search(r"```python\n(.*?)```", docs, re.DOTALL).group(1)
table = [row(pseudonym, own) for pseudonym, own in log.groupby("pseudonym")]
print(json.dumps({"lines": lines, "printed": run_lines(lines), "table": table}, indent=1))
