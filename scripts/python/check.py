"""Holds the stand-ins and the generated files to the real libraries.

    npm run python -- /tmp/python-files
    pip install pybricks==4.0.0 python-ev3dev2==2.1.0.post1 black==26.10.1 ruff==0.17.6 vermin==1.9.2
    python scripts/python/check.py /tmp/python-files

Every name and every parameter that a stand-in has is there in the real library; what Pybricks 4 has on its bricks is in
firmware.json. Every generated file compiles as Python 3.5, black leaves it as it is, and ruff finds nothing.
"""

import ast
import json
import pathlib
import subprocess
import sys
from importlib import metadata, util

here = pathlib.Path(__file__).parent
stand_ins = here.parent.parent / "packages/programs/python/testing/stand-ins"
firmware = json.loads((here / "firmware.json").read_text())
libraries = ("pybricks", "ev3dev2")
# What the bricks have built in: the classes behind it are called otherwise in the stubs.
parts = {
    "_Light": "light",
    "_Screen": "screen",
    "_Speaker": "speaker",
    "_Keypad": "buttons",
    "_PrimeKeypad": "buttons",
    "_LightMatrix": "display",
    "_IMU": "imu",
    "_System": "system",
}
# Classes of the stubs behind those whose parameters are held to them, too.
in_stubs = {"_LightMatrix": "LightMatrix", "_IMU": "IMU", "_System": "System"}


def tree_of(path):
    return ast.parse(path.read_text(encoding="utf-8"))


def real_path(module):
    spec = util.find_spec(module.split(".")[0])
    base = pathlib.Path(spec.submodule_search_locations[0]).joinpath(*module.split(".")[1:])
    return base / "__init__.py" if base.is_dir() else base.with_suffix(".py")


def classes_in(tree):
    return {node.name: node for node in ast.walk(tree) if isinstance(node, ast.ClassDef)}


def members(cls, everywhere, seen=()):
    """Methods by name with their parameters, attributes with None; those of its bases included."""
    found = {}
    for base in cls.bases:
        name = base.attr if isinstance(base, ast.Attribute) else getattr(base, "id", "")
        for other in everywhere.get(name, []):
            if other is not cls and other not in seen:
                found.update(members(other, everywhere, (*seen, cls)))
    for node in cls.body:
        if isinstance(node, ast.FunctionDef):
            args = [arg.arg for arg in node.args.args[1:] + node.args.kwonlyargs]
            found.setdefault(node.name, set()).update(args + (["*"] if node.args.vararg else []))
            if node.name == "settings":
                found[node.name].update(args)
        elif isinstance(node, (ast.Assign, ast.AnnAssign)):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            for target in targets:
                found.setdefault(getattr(target, "id", ""), set())
        elif isinstance(node, ast.If):
            found.update(members(ast.ClassDef(cls.name, [], [], node.body + node.orelse, []), {}))
    return found


def problems_of(path):
    module = ".".join(path.relative_to(stand_ins).with_suffix("").parts)
    if module.split(".")[0] not in libraries or path.name == "__init__.py" and path.stat().st_size == 0:
        return
    real = tree_of(real_path(module.removesuffix(".__init__")))
    everywhere = {}
    folder = real_path(module.split(".")[0]).parent
    trees = [real] + [tree_of(other) for other in folder.rglob("*.py")]
    for tree in trees:
        for name, cls in classes_in(tree).items():
            everywhere.setdefault(name, []).append(cls)
    for name, cls in classes_in(tree_of(path)).items():
        if name in parts:
            for method in members(cls, {}):
                if method not in firmware[parts[name]]:
                    yield f"{module}: {parts[name]}.{method} is not in firmware.json"
            if name not in in_stubs:
                continue
        public = name.lstrip("_")
        target = {"_Motor": "Motor", "_Sensor": "Sensor", **in_stubs}.get(name, public)
        if target not in everywhere:
            yield f"{module}: no class {target}"
            continue
        there = members(everywhere[target][0], everywhere)
        for method, args in members(cls, {}).items():
            if method.startswith("_") and method != "__init__":
                continue
            if method == "__init__" and not args:
                continue
            if method not in there:
                yield f"{module}: {target} has no {method}"
            elif args and not args <= there[method] | {"value", "address"}:
                yield f"{module}: {target}.{method} does not take {sorted(args - there[method])}"


def module_names_problems(files):
    """Every name that a file imports from a robot's library exists there."""
    wanted = set()
    for path in files:
        for node in ast.walk(tree_of(path)):
            if isinstance(node, ast.ImportFrom):
                wanted.update((node.module, alias.name) for alias in node.names)
    for module, name in sorted(wanted):
        if module in firmware:
            if name not in firmware[module]:
                yield f"{module}.{name} is not in firmware.json"
        elif module.split(".")[0] in libraries:
            source = real_path(module).read_text(encoding="utf-8")
            if name not in source:
                yield f"{module} has no {name}"


def run(tool, *options):
    command = [str(pathlib.Path(sys.executable).parent / tool), *options]
    result = subprocess.run(command, capture_output=True, text=True)
    return result.returncode, result.stdout + result.stderr


def main(folder):
    files = sorted(pathlib.Path(folder).glob("*.py"))
    found = [problem for path in sorted(stand_ins.rglob("*.py")) for problem in problems_of(path)]
    found += list(module_names_problems(files))
    for path in files:
        try:
            ast.parse(path.read_text(encoding="utf-8"), feature_version=(3, 5))
        except SyntaxError as error:
            found.append(f"{path.name}: {error}")
    ev3dev = [str(path) for path in files if ".ev3dev2." in path.name]
    checks = [
        ("black", "--check", "--quiet", folder),
        ("ruff", "check", "--isolated", "--select", "E4,E7,E9,F,I", "--ignore", "F841", "--quiet", folder),
        ("vermin", "--quiet", "--no-tips", "-t=3.5-", "--violations", *ev3dev),
    ]
    for command in checks:
        code, output = run(*command)
        if code != 0:
            found.append(f"{command[0]}: {output.strip()[-600:]}")
    report(files, found)
    return 1 if found else 0


def report(files, found):
    names = ("pybricks", "python-ev3dev2", "black", "ruff", "vermin")
    versions = ", ".join(f"{name} {metadata.version(name)}" for name in names)
    lines = ["# Generated Python and the real libraries", "", "Made by `scripts/python/check.py`.", ""]
    lines += [f"{len(files)} files; {versions}.", ""]
    lines += [f"- {problem}" for problem in found] or ["Nothing was found."]
    (here / "result.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
