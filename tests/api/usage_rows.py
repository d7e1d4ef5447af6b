#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Every row of usage_rows.txt is used by the code of a snippet or program; prints those that are not."""

import pathlib
import re
import sys

HERE = pathlib.Path(__file__).parent
COMMENT = re.compile(r"//.*?$", re.MULTILINE)


def code():
    files = [*HERE.glob("snippets/*"), *HERE.glob("program/*")]
    return {file: COMMENT.sub("", file.read_text(encoding="utf-8")) for file in files}


def rows():
    for line in (HERE / "usage_rows.txt").read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            yield line.split("\t")


def main():
    sources = code()
    total, missing = 0, []
    for repositories, what, pattern in rows():
        total += 1
        if not any(re.search(pattern, text) for text in sources.values()):
            missing.append(f"{what}  ({repositories} repositories): nothing matches /{pattern}/")
    for text in missing:
        print(text)
    print(f"usage_rows: {total - len(missing)} of {total} rows are used in {len(sources)} files")
    return bool(missing)


if __name__ == "__main__":
    sys.exit(main())
