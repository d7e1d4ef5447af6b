# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""What the rule scripts share: the files of the tree, their #include lines, and how findings are printed."""
import argparse
import os
import pathlib
import re
import sys

SKIPPED_DIRS = {".git", "__pycache__", ".cache"}
SKIPPED_AT_THE_TOP = {"build"}  # tests/build is source
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:<([^>\n]+)>|"([^"\n]+)")', re.MULTILINE)
BLOCK_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)


class Tree:
    """The files below one root, by their path relative to it (with '/')."""

    def __init__(self, root):
        self.root = pathlib.Path(root).resolve()
        self.files = sorted(self._walk())
        self._known = set(self.files)

    def _walk(self):
        for folder, dirs, names in os.walk(self.root):
            skipped = SKIPPED_DIRS | (SKIPPED_AT_THE_TOP if pathlib.Path(folder) == self.root else set())
            dirs[:] = [d for d in dirs if d not in skipped]
            for name in names:
                path = pathlib.Path(folder) / name
                if path.is_file():
                    yield path.relative_to(self.root).as_posix()

    def __contains__(self, path):
        return path in self._known

    def text(self, path):
        """Contents, or None for a binary file."""
        data = (self.root / path).read_bytes()
        if b"\0" in data:
            return None
        return data.decode("utf-8", errors="replace")

    def includes(self, path):
        """(line, name, quoted) of each #include outside block comments."""
        text = BLOCK_COMMENT.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), self.text(path) or "")
        for match in INCLUDE.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            yield line, match.group(1) or match.group(2), match.group(2) is not None


class Report:
    """Prints findings in the form editors understand and remembers whether there were any."""

    def __init__(self):
        self.count = 0

    def error(self, path, line, code, message):
        self.count += 1
        print(f"{path}:{line}: error: [{code}] {message}", file=sys.stderr)

    def finish(self, script, checked):
        if self.count:
            print(f"{script}: {self.count} finding(s) in {checked} files", file=sys.stderr)
            return 1
        print(f"{script}: {checked} files, no finding")
        return 0


def open_tree(description):
    """The tree named on the command line; the one this script lies in by default."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--root", default=pathlib.Path(__file__).resolve().parent.parent,
                        help="tree to check (default: the one this script lies in)")
    root = pathlib.Path(parser.parse_args().root)
    if not root.is_dir():
        parser.error(f"'{root}' is not a directory")
    return Tree(root)
