#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Whether links lead to files and headings that there are: check_links.py ROOT [PAGE…]; else those of ROOT."""
import pathlib
import re
import sys

FENCED = re.compile(r"^```.*?^```$|^<!-- .*?-->$", re.M | re.S)  # and comments
CODE = re.compile(r"`[^`\n]+`")
LINK = re.compile(r"\[[^][]*\]\(([^()\s]+)\)")
HEADING = re.compile(r"^#+ +(.*?) *$", re.M)


def blank(text):
    """As many lines, with nothing in them."""
    return re.sub(r"[^\n]", " ", text)


def anchors(page):
    """What headings are called in links, as GitHub does it: of several alike the second has a -1."""
    found = set()
    for title in HEADING.findall(FENCED.sub("", page.read_text())):
        title = LINK.sub(lambda link: link.group().split("]")[0][1:], title)
        word = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
        number = 0
        while (name := f"{word}-{number}" if number else word) in found:
            number += 1
        found.add(name)
    return found


def check(root, page):
    text = FENCED.sub(lambda listing: blank(listing.group()), page.read_text())
    text = CODE.sub(lambda code: blank(code.group()), text)
    for link in LINK.finditer(text):
        file, _, anchor = link.group(1).partition("#")
        if re.match(r"\w+:", file):
            continue  # of the web
        place = f"{page}:{text.count(chr(10), 0, link.start()) + 1}"
        target = (page.parent / file).resolve() if file else page
        if not target.is_relative_to(root):
            yield f"{place}: {file} leads out of the repository"
        elif not target.exists():
            yield f"{place}: there is no {file}"
        elif anchor and anchor not in anchors(target):
            yield f"{place}: no heading '{anchor}' in {file or 'this page'}"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = sys.argv[2:] or [*root.glob("*.md"), *root.glob("docs/**/*.md"), *root.glob("examples/**/*.md")]
    faults = [fault for page in pages for fault in check(root, root / page)] if pages else [f"no pages in {root}"]
    print("".join(f"{fault}\n" for fault in faults), end="")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
