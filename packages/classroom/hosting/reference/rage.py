"""Backups and the Rust implementation of age (https://github.com/str4d/rage), by its Python package `pyrage`, and Python's tarfile.

`python rage.py write`: makes rage.age, which sealed.test.ts opens.
`python rage.py open FILE PHRASE`: opens a backup of `botgarten backup` and compares its parts with the manifest.
Last run with pyrage 1.4.0 and Python 3.11, 2026-11-29, in both directions; pip install pyrage. `age -d FILE | tar -x` was tried with age 1.3.2 and GNU tar.
"""
import hashlib
import io
import json
import pathlib
import sys
import tarfile

from pyrage import passphrase

PHRASE = "kite-otter-plum-rope-kite-otter-plum-rope-kite-otter"
PARTS = {"botgarten.db": b"a database" * 10_000, "secret.key": bytes(range(32))}


def write(path: pathlib.Path) -> None:
    parts = [
        {"name": name, "bytes": len(data), "sha256": hashlib.sha256(data).hexdigest()}
        for name, data in PARTS.items()
    ]
    manifest = {"format": "botgarten-backup", "version": 1, "day": "2026-11-24", "parts": parts}
    archive = io.BytesIO()
    with tarfile.open(fileobj=archive, mode="w") as tar:
        for name, data in {"manifest.json": json.dumps(manifest).encode(), **PARTS}.items():
            header = tarfile.TarInfo(name)
            header.size = len(data)
            tar.addfile(header, io.BytesIO(data))
    path.write_bytes(passphrase.encrypt(archive.getvalue(), PHRASE))


def open_backup(path: pathlib.Path, phrase: str) -> None:
    opened = passphrase.decrypt(path.read_bytes(), phrase)
    with tarfile.open(fileobj=io.BytesIO(opened)) as tar:
        files = {one.name: tar.extractfile(one).read() for one in tar.getmembers()}
    manifest = json.loads(files["manifest.json"])
    for part in manifest["parts"]:
        data = files[part["name"]]
        assert len(data) == part["bytes"], part
        assert hashlib.sha256(data).hexdigest() == part["sha256"], part
    print(manifest["format"], manifest["day"], sorted(files))


if __name__ == "__main__":
    if sys.argv[1] == "write":
        write(pathlib.Path(__file__).with_name("rage.age"))
    else:
        open_backup(pathlib.Path(sys.argv[2]), sys.argv[3])
