# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""Debian's suites beside the one that runs here, asked by apt without being root.

A suite has one version of VTK. Its package lists and packages are kept in a folder of the
caller's, with a configuration of apt of its own, so that nothing of the system is changed.

    python3 suites.py FOLDER VERSION     # the first suite that has this VTK, such as 9.6 or 9.6.2,
                                         # and where its packages come from
"""
import pathlib
import subprocess
import sys

# Stable first: what was found there once is found there again.
NAMES = ("bookworm", "trixie", "forky", "sid")

# Without a proxy of one's own apt takes what the system's configuration says; the lists of the
# moving suites may be older than they say they are valid.
CONFIGURATION = """
Dir::Etc::sourcelist "{folder}/sources.list";
Dir::Etc::sourceparts "/dev/null";
Dir::Etc::preferences "/dev/null";
Dir::Etc::preferencesparts "/dev/null";
Dir::State "{folder}/state";
Dir::State::status "{folder}/status";
Dir::Cache "{folder}/cache";
Acquire::Languages "none";
Acquire::Check-Valid-Until "false";
APT::Sandbox::User "";
"""


class Suite:
    """One of Debian's suites.

    Parameters
    ----------
    name : str
        One of `NAMES`.
    folder : path
        Where its lists are kept; made where it is missing.
    """

    def __init__(self, name, folder):
        self.name = name
        self.folder = pathlib.Path(folder).resolve() / name
        self.environment = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL": "C",
                            "APT_CONFIG": str(self.folder / "apt.conf")}
        self._updated = False

    def update(self):
        """Fetch the suite's lists of packages."""
        if self._updated:
            return
        for place in ("state/lists/partial", "cache/archives/partial"):
            (self.folder / place).mkdir(parents=True, exist_ok=True)
        (self.folder / "status").touch()
        (self.folder / "apt.conf").write_text(CONFIGURATION.format(folder=self.folder))
        (self.folder / "sources.list").write_text(
            "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] "
            f"{mirror()} {self.name} main\n")
        self._run("apt-get", "update", "--quiet")
        self._updated = True

    def version(self, package="libvtk9-dev"):
        """The version that the suite has, as upstream counts, or None."""
        self.update()
        for line in self._run("apt-cache", "policy", package).splitlines():
            key, _, value = line.strip().partition(": ")
            if key == "Candidate" and value != "(none)":
                return value.split(":")[-1].split("-")[0].split("+")[0]
        return None

    def unpack(self, packages, folder, *files):
        """Download packages without what they depend on, and unpack them into a folder.

        Parameters
        ----------
        packages : sequence of str
            Their names.
        folder : path
            What they are unpacked into.
        files : str
            Patterns of the files that are wanted; all where none is given.
        """
        self.update()
        archives = self.folder / "packages"
        archives.mkdir(exist_ok=True)
        self._run("apt-get", "download", "--quiet", *packages, cwd=archives)
        for package in packages:
            newest = max(archives.glob(f"{package}_*.deb"), key=lambda file: file.stat().st_mtime)
            pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
            content = subprocess.Popen(
                ["dpkg-deb", "--fsys-tarfile", newest], stdout=subprocess.PIPE)
            subprocess.run(["tar", "--extract", "--directory", folder, "--wildcards", *files],
                           stdin=content.stdout, check=True)
            content.stdout.close()
            content.wait()

    def _run(self, *command, cwd=None):
        done = subprocess.run(
            command, env=self.environment, cwd=cwd, text=True, capture_output=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
        return done.stdout


def mirror():
    """Where Debian's packages come from: what the system has, or else Debian's own address."""
    places = [pathlib.Path("/etc/apt/sources.list"),
              *sorted(pathlib.Path("/etc/apt/sources.list.d").glob("debian.*"))]
    for place in places:
        for line in place.read_text().splitlines() if place.is_file() else ():
            for word in line.split():
                if not line.startswith("#") and word.rstrip("/").endswith("/debian"):
                    return word
    return "http://deb.debian.org/debian"


def find(folder, version):
    """The first suite whose VTK is of this version; an error that lists them all if there is none.

    Parameters
    ----------
    folder : path
        Where the suites' lists are kept.
    version : str
        "9.6.2", or "9.6" for any patch release.
    """
    there = {}
    for name in NAMES:
        suite = Suite(name, folder)
        there[name] = suite.version()
        if there[name] and (there[name] + ".").startswith(version + "."):
            return suite
    listed = ", ".join(f"{name} {found}" for name, found in there.items() if found)
    raise LookupError(f"No suite of Debian has VTK {version}. There are: {listed}.")


if __name__ == "__main__":
    try:
        print(find(sys.argv[1], sys.argv[2]).name, mirror())
    except LookupError as error:
        sys.exit(str(error))
