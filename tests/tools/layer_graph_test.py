#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs/design/architecture.md"


def draw(form):
    return subprocess.run([sys.executable, str(ROOT / "tools/layers.py"), form], check=True, capture_output=True,
                          text=True).stdout


class LayerGraph(unittest.TestCase):
    def test_arrows_that_others_replace_are_left_out(self):
        drawn = draw("--dot")
        self.assertIn("  deployment -> ocl;\n", drawn)
        # By way of ocl and of the umbrella header.
        self.assertNotIn("  deployment -> core;\n", drawn)

    def test_layers_that_have_no_file_yet_are_left_out(self):
        places = re.findall(r'^    \w+ \[label="\w+\\n(.*)"\];$', draw("--dot"), re.M)
        self.assertGreater(len(places), 30)
        for place in places:
            self.assertTrue(list(ROOT.glob(place.rstrip("/") + "*")), place)

    def test_page_shows_the_table_of_today(self):
        shown = re.search(r"^```mermaid\n(.*?)^```$", PAGE.read_text(encoding="utf-8"), re.M | re.S)
        self.assertEqual(draw("--mermaid"), shown.group(1), "copy the output of tools/layers.py --mermaid to " + PAGE.name)

    def test_files_that_the_page_names_exist(self):
        named = re.findall(r"`((?:runtime|deployer|generator|typekit_gen|templates)/[\w./]+)`", PAGE.read_text(encoding="utf-8"))
        self.assertGreater(len(named), 40)
        for path in named:
            self.assertTrue((ROOT / path).exists(), path)


if __name__ == "__main__":
    unittest.main()
