# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Draws the table of layers.py: one box per layer, one arrow for "may include"."""
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Longest matching prefix wins.
GROUPS = {"generator/": "generators", "typekit_gen/": "generators", "templates/": "generators", "deployer/": "deployer",
          "runtime/": "runtime", "ros/": "ROS"}


def existing(layer_of):
    """layer -> its places, for layers that the tree has already."""
    places = {}
    for prefix, layer in layer_of.items():
        # A prefix may end within a file name; a header may be made from a file with ".in" behind its name.
        if list(ROOT.glob(prefix + ("" if prefix.endswith("/") else "*"))):
            places.setdefault(layer, []).append(prefix)
    return places


def arrows(may_include, layers):
    """The pairs that remain when those are left out which a way over others replaces."""
    def reachable(layer):
        found = set()
        for below in may_include[layer] & layers:
            found |= {below} | reachable(below)
        return found

    for layer in sorted(layers):
        direct = may_include[layer] & layers
        for below in sorted(direct):
            if not any(below in reachable(other) for other in direct - {below}):
                yield layer, below


def place_of(prefixes):
    """A folder, if the layer has one."""
    return next((prefix for prefix in prefixes if prefix.endswith("/")), prefixes[0])


def grouped(places):
    groups = {}
    for layer in sorted(places):
        group = next(name for prefix, name in GROUPS.items() if places[layer][0].startswith(prefix))
        groups.setdefault(group, []).append(layer)
    return groups


def dot(layer_of, may_include):
    places = existing(layer_of)
    lines = ["digraph rooms {", "  rankdir=TB;", "  node [shape=box];"]
    for group, layers in grouped(places).items():
        lines += [f"  subgraph cluster_{group} {{", f'    label="{group}";']
        lines += [f'    {layer} [label="{layer}\\n{place_of(places[layer])}"];' for layer in layers]
        lines.append("  }")
    lines += [f"  {above} -> {below};" for above, below in arrows(may_include, set(places))]
    return "\n".join(lines + ["}"])


def mermaid(layer_of, may_include):
    places = existing(layer_of)
    lines = ["flowchart TB"]
    for group, layers in grouped(places).items():
        lines.append(f"  subgraph {group}")
        lines += [f'    {layer}_["{layer}<br/>{place_of(places[layer])}"]' for layer in layers]
        lines.append("  end")
    lines += [f"  {above}_ --> {below}_" for above, below in arrows(may_include, set(places))]
    return "\n".join(lines)
