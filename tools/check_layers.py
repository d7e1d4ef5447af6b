#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Checks who includes whom against the table in layers.py.

LAY01  a layer includes a layer it must not know
LAY02  a header of another project outside its one folder
LAY03  a header in detail/ included from outside the part it belongs to
LAY04  an installed header includes one that is not installed
LAY05  a source file that belongs to no layer
LAY06  headers that include each other
"""
import posixpath
import re
import sys

import layers
from source_tree import Report, open_tree

SOURCES = (".hpp", ".h", ".inl", ".cpp", ".c", ".h.in", ".hpp.in", ".mustache")
HEADERS = (".hpp", ".h", ".inl")
LAYERED = ("runtime/", "deployer/", "generator/", "typekit_gen/", "templates/")


def layer_of(path):
    matches = [prefix for prefix in layers.LAYER_OF if path.startswith(prefix)]
    return layers.LAYER_OF[max(matches, key=len)] if matches else None


def resolve(tree, includer, name, quoted):
    """The file of this project that an include names, or None if it is another project's."""
    candidates = [posixpath.normpath(posixpath.join(posixpath.dirname(includer), name))] if quoted else []
    candidates += [posixpath.normpath(root + name) for root in layers.INCLUDE_ROOTS]
    for candidate in candidates:
        if candidate in tree or candidate + ".in" in tree:
            return candidate
    # A header that is not written yet still has a place.
    for candidate in candidates:
        if candidate.count("/") >= 2 and layer_of(candidate) and not re.match(r"[^/]*\.", name):
            if quoted and not candidate.startswith(tuple(r + name.split("/")[0] for r in layers.INCLUDE_ROOTS)):
                continue
            return candidate
    return None


def private_home(path):
    """The folder whose files may include this one, or None if it is not private."""
    head, found, _ = path.rpartition("/detail/")
    return head + "/" if found else None


def is_installed_header(path):
    return (path.endswith(HEADERS) and path.startswith(tuple(layers.INSTALLED)) and "/detail/" not in path
            and not path.startswith(tuple(layers.NOT_INSTALLED)))


def check_foreign(report, path, line, name):
    for pattern, homes in layers.FOREIGN.items():
        if re.match(pattern, name) and not path.startswith(tuple(homes)):
            where = "only in " + ", ".join(homes) if homes else "nowhere"
            report.error(path, line, "LAY02", f"<{name}> may be included {where}")


def check_own(report, path, line, target):
    if f"{path} -> {target}" in layers.ALLOWED:
        return
    source_layer, target_layer = layer_of(path), layer_of(target)
    if source_layer and target_layer and source_layer != target_layer:
        allowed = layers.MAY_INCLUDE[source_layer]
        if target_layer not in allowed:
            report.error(path, line, "LAY01", f"layer '{source_layer}' includes {target} of layer '{target_layer}', "
                         f"expected one of: {', '.join(sorted(allowed)) or 'none'}")
    home = private_home(target) if source_layer != target_layer else None
    if home and not path.startswith((home, "tests/")):
        report.error(path, line, "LAY03", f"{target} is private to {home}")
    if is_installed_header(path) and ("/detail/" in target or target.startswith(tuple(layers.NOT_INSTALLED))):
        report.error(path, line, "LAY04", f"installed header includes {target}, which is not installed")


def check_table():
    """The table itself must have no cycle, or it would not be a layering."""
    done = set()

    def visit(layer, trail):
        if layer in trail:
            sys.exit("layers.py: cycle: " + " -> ".join(trail[trail.index(layer):] + [layer]))
        if layer not in done:
            for below in sorted(layers.MAY_INCLUDE[layer]):
                visit(below, trail + [layer])
            done.add(layer)

    for layer in set(layers.LAYER_OF.values()):
        visit(layer, [])


def check_circles(report, includes):
    """Headers must not include each other, except for those in layers.CIRCLES."""
    finished, trail = set(), []

    def visit(path):
        if path in trail:
            circle = trail[trail.index(path):]
            if not any(allowed.issuperset(circle) for allowed in layers.CIRCLES):
                report.error(circle[-1], 1, "LAY06", "headers include each other: " + " -> ".join([*circle, path]))
        elif path not in finished:
            trail.append(path)
            for target in includes.get(path, ()):
                visit(target)
            finished.add(trail.pop())

    for path in includes:
        visit(path)


def main():
    check_table()
    tree = open_tree(__doc__.splitlines()[0])
    report = Report()
    checked = 0
    includes = {}
    for path in tree.files:
        if not path.endswith(SOURCES) or path.startswith("tests/golden/"):
            continue
        checked += 1
        if path.startswith(LAYERED) and layer_of(path) is None:
            report.error(path, 1, "LAY05", "no layer for this file, expected a folder named in tools/layers.py")
        for line, name, quoted in tree.includes(path):
            target = resolve(tree, path, name, quoted)
            if target:
                check_own(report, path, line, target)
                includes.setdefault(path, []).append(target)
            else:
                check_foreign(report, path, line, name)
    check_circles(report, includes)
    return report.finish("check_layers", checked)


if __name__ == "__main__":
    sys.exit(main())
