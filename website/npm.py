"""Packages of npm that are part of the site: fetched once, verified, and cached."""

import base64
import hashlib
import subprocess
import tarfile
from dataclasses import dataclass

from .kept import CACHE


@dataclass(frozen=True)
class Package:
    """A package of npm at one version; ``integrity`` is its SHA-512 as npm writes it."""

    name: str
    version: str
    integrity: str

    def files(self, *names: str) -> dict[str, bytes] | None:
        """{name: contents} of these files; None if the package is neither cached nor can be
        fetched.
        """
        archive = CACHE / "npm" / f"{self.name}-{self.version}.tgz"
        if not (self._is_whole(archive) or self._fetched(archive)):
            return None
        with tarfile.open(archive) as packed:
            found = {name: packed.extractfile(f"package/{name}") for name in names}
            return {name: file.read() for name, file in found.items() if file}

    def _is_whole(self, archive):
        if not archive.exists():
            return False
        digest = hashlib.sha512(archive.read_bytes()).digest()
        return self.integrity == f"sha512-{base64.b64encode(digest).decode()}"

    def _fetched(self, archive):
        """Fetch the package by npm; returns whether that succeeded."""
        archive.parent.mkdir(parents=True, exist_ok=True)
        command = ["npm", "pack", f"{self.name}@{self.version}", "--pack-destination"]
        try:
            subprocess.run([*command, archive.parent], capture_output=True, timeout=120, check=True)
        except (OSError, subprocess.SubprocessError):
            return False
        return self._is_whole(archive)
