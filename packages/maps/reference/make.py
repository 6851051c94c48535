"""Roads and transforms as others read them.

roads.json: random path data with every command, its length, and the points at every eighth of it, by svgpathtools 1.8
(lengths integrated by SciPy to 1e-9). transforms.json: the matrices that Chromium makes of transforms; null: none.

    pip install svgpathtools==1.8.0 && CHROMIUM=/usr/bin/chromium python make.py
"""

import html
import json
import os
import random
import re
import subprocess
import tempfile
from pathlib import Path

from svgpathtools import parse_path

here = Path(__file__).parent
chance = random.Random(15)
SIZES = {"L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2}


def number(low, high):
    return f"{chance.uniform(low, high):.2f}"


def arc(low, high):
    flags = [str(chance.randint(0, 1)) for _ in range(2)]
    turn = chance.choice(["0", number(-180, 180)])
    return [number(20, 300), number(20, 300), turn, *flags, number(low, high), number(low, high)]


def piece(command):
    low, high = (-200, 200) if command.islower() else (0, 1000)
    values = arc(low, high) if command.upper() == "A" else [number(low, high) for _ in range(SIZES[command.upper()])]
    return command + chance.choice([" ", ","]).join(values)


def road():
    start = f"{chance.choice('Mm')}{number(0, 1000)} {number(0, 1000)}"
    commands = [chance.choice("LlHhVvCcSsQqTtAa") for _ in range(chance.randint(1, 6))]
    return start + "".join(map(piece, commands)) + chance.choice(["", "", "", "Z", "z"])


def as_svgpathtools(data):
    path = parse_path(data)
    length = path.length(error=1e-9)
    eighths = [path.point(path.ilength(length * share / 8)) if 0 < share < 8 else path.point(share / 8) for share in range(9)]
    return {"data": data, "length": length, "points": [[round(p.real, 6), round(p.imag, 6)] for p in eighths]}


def random_transform():
    one = {
        "translate": lambda: [number(-300, 300) for _ in range(chance.randint(1, 2))],
        "scale": lambda: [number(0.2, 3) for _ in range(chance.randint(1, 2))],
        "rotate": lambda: [number(-360, 360)] + chance.choice([[], [number(-300, 300), number(-300, 300)]]),
        "skewX": lambda: [number(-60, 60)],
        "skewY": lambda: [number(-60, 60)],
        "matrix": lambda: [number(-2, 2) for _ in range(6)],
    }
    names = [chance.choice(list(one)) for _ in range(chance.randint(1, 4))]
    return chance.choice(["", " ", ", "]).join(f"{name}({chance.choice([' ', ',', ' , ']).join(one[name]())})" for name in names)


BY_HAND = [
    "", "  ", "translate(10-5)", "translate(1e2,.5)", "scale(.5.25)", " rotate ( 90 ) ", "rotate(45,10,20)", "scale(2)scale(3)",
    "translate(1 2),scale(-1)", "rotate(30 10)", "translate()", "translate(1,2,3)", "matrix(1 0 0 1 5)", "turn(30)",
    "rotate(30deg)", "translate(10px,5px)", "rotate(30", "scale(1) x", "ROTATE(30)", "skewx(30)", "translate(1%)",
]  # fmt: skip


def as_chromium(texts):
    page = (
        "<svg><g id=g /></svg><script>const g=document.getElementById('g');document.title=''\n"
        "const read=(text)=>{g.setAttribute('transform',text);const list=g.transform.baseVal\n"
        "if(text.trim()==='')return [1,0,0,1,0,0]\n"
        "if(list.numberOfItems===0)return null\n"
        "const m=g.getCTM();const s=document.querySelector('svg').getCTM().inverse()\n"
        "const n=s.multiply(m);return [n.a,n.b,n.c,n.d,n.e,n.f]}\n"
        f"document.documentElement.innerHTML='<pre>'+JSON.stringify({json.dumps(texts)}.map(read))+'</pre>'</script>"
    )
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "page.html"
        file.write_text(page)
        call = [os.environ.get("CHROMIUM", "chromium"), "--headless", "--no-sandbox", "--disable-gpu", "--dump-dom"]
        out = subprocess.run([*call, f"--user-data-dir={folder}/profile", file.as_uri()], capture_output=True, text=True, check=True).stdout
    return json.loads(html.unescape(re.search(r"<pre>(.*)</pre>", out).group(1)))


def rows(values):
    return "[\n" + ",\n".join(json.dumps(value, separators=(",", ":")) for value in values) + "\n]\n"


(here / "roads.json").write_text(rows(as_svgpathtools(road()) for _ in range(150)))
texts = BY_HAND + [random_transform() for _ in range(100)]
matrices = as_chromium(texts)
(here / "transforms.json").write_text(rows({"text": text, "matrix": matrix} for text, matrix in zip(texts, matrices)))
