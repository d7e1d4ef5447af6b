#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""run_guide.py and check_links.py with small pages, right and wrong ones; "deployer" is a script that answers a line with it."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent


class Pages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        target = self.folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)
        return target

    def call(self, script, *arguments):
        done = subprocess.run([sys.executable, HERE / script, *arguments], capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr, "")
        return done.returncode, done.stdout

    def try_page(self, text, name="page.md"):
        self.write("bin/deployer", '#!/bin/sh\necho "started with $*"\nwhile read -r line; do echo "= $line"; done\n').chmod(0o755)
        status, told = self.call("run_guide.py", self.folder, self.write(name, text))
        self.assertEqual(status, 1 if told else 0)
        return told.replace(f"{self.folder}/", "")

    def check_page(self, text):
        self.assertEqual(self.try_page(text), "")

    def check_wrong(self, text, told):
        self.assertIn(told, self.try_page(text))


class RunGuide(Pages):
    def test_a_page_without_faults(self):
        self.check_page("# Page\n\n<!-- file a/b.txt -->\n```\none\n```\n\n<!-- run -->\n```sh\nexport WORD=$(cat a/b.txt)\n```\n"
                        "\nText.\n\n<!-- run: 3 -->\n```sh\necho $WORD; echo /tmp/two; echo 3; exit 3\n```\n"
                        "\n<!-- output -->\n```\none\n…/two\n…\n```\n\n<!-- shown it is a picture -->\n```dot\na\n```\n")

    def test_a_part_of_a_file_stands_in_its_place(self):
        self.check_page("<!-- file x\nbegin\n…\nend\n-->\n```cpp\nmiddle\n```\n<!-- try\ndiff x - << END\nbegin\nmiddle\nend\nEND\n-->\n"
                        "<!-- file y\n…\n-->\n```cpp\nall\n```\n<!-- try\n[ \"$(cat y)\" = all ]\n-->\n")
        self.check_wrong("<!-- file x\nbegin\nend\n-->\n```cpp\nmiddle\n```\n", "page.md:5: only a file has something around it")
        self.check_wrong("<!-- run\ntrue\n…\n-->\n```cpp\nmiddle\n```\n", "only a file has something around it")

    def test_what_is_typed_at_the_prompt(self):
        session = "```console\nDeployer [S]> for {\n= for {\n> 1\n= 1\n```\n"
        self.check_page("<!-- typed -s a.ops -->\n" + session.replace("console\n", "console\nstarted with -s a.ops\n"))
        self.check_page("<!-- typed: deployer one two -->\n" + session.replace("console\n", "console\nstarted with one two\n"))
        self.check_wrong("<!-- typed: -->\n" + session, "not understood: <!-- typed: -->")
        self.check_wrong("<!-- typed -->\n" + session, "page.md:2: the output is another:\nstarted with \n= for {\n= 1\n")

    def test_another_status_is_told(self):
        self.check_wrong("Text\n\n<!-- run -->\n```sh\necho no; exit 4\n```\n", "page.md:4: exit status 4, expected 0:\necho no; exit 4\n\nno\n")
        self.check_wrong("<!-- run: 4 -->\n```sh\ntrue\n```\n", "page.md:2: exit status 0, expected 4")
        self.check_wrong("<!-- run -->\n```sh\nfalse\ntrue\n```\n", "exit status 1")
        self.check_wrong("<!-- try\nfalse\n-->\n", "page.md:1: exit status 1, expected 0:\nfalse\n")

    def test_another_output_is_told(self):
        page = "<!-- run -->\n```sh\nprintf 'a\\nb\\n'\n```\n<!-- output -->\n```\n%s\n```\n"
        self.check_page(page % "a\nb")
        for wrong in ("a", "b", "b\na", "a\n…\nc", "a\nb\n\n", "a\nb\nc"):
            self.check_wrong(page % wrong, "page.md:6: the output is another:\na\nb\n")

    def test_a_listing_that_nobody_tries_is_told(self):
        for language in ("cpp", "xml", "sh", "cmake", "ops", "text", "console"):
            self.check_wrong(f"<!-- file x -->\n```\n```\n\n```{language}\nx\n```\n", f"page.md:5: a listing of {language} that nobody tries")
        self.check_wrong("```\nx\n```\n", "page.md:1: a listing of no language that nobody tries")
        self.check_wrong("Text:\n\n    make it\n", "page.md:3: an indented listing")
        self.check_wrong("<!-- shown -->\n```sh\nx\n```\n", "not understood: <!-- shown -->")

    def test_those_of_another_test_are_left_to_it(self):
        self.assertEqual(self.try_page("```console\nx\n```\n", "console.md"), "")
        self.assertIn("nobody tries", self.try_page("```ops\nx\n```\n", "console.md"))

    def test_a_comment_that_does_nothing_is_told(self):
        self.check_wrong("<!-- ran -->\n```sh\ntrue\n```\n", "page.md:2: not understood: <!-- ran -->")
        self.check_wrong("<!-- file -->\n```sh\ntrue\n```\n", "not understood: <!-- file -->")
        self.check_wrong("<!-- run -->\n\nText.\n\n```sh\nfalse\n```\n", "page.md:5: no listing after <!-- run -->")
        self.check_wrong("<!-- run -->\n", "page.md:1: no listing after <!-- run -->")


class CheckLinks(Pages):
    def links(self, text):
        self.write("b.md", "# The `b` page: of C++, and_more\n\n## Twice\n\n## Twice\n\n```sh\n# no heading\n```\n")
        page = self.write("docs/a.md", "# A page\n" + text)
        return self.call("check_links.py", self.folder, page)[1].replace(f"{self.folder}/", "")

    def test_links_that_lead_somewhere(self):
        self.assertEqual(self.links("[b](../b.md) [up](#a-page) [c](../b.md#the-b-page-of-c-and_more) [two](../b.md#twice-1)\n"
                                    "[web](https://example.org/x) [folder](..) `[no](link)`\n```\n[no](link)\n```\n"), "")

    def test_links_that_lead_nowhere(self):
        self.assertEqual(self.links("see [b](b.md)\n"), "docs/a.md:2: there is no b.md\n")
        self.assertEqual(self.links("[b](../b.md#thrice)\n\n[x](#b)\n"), "docs/a.md:2: no heading 'thrice' in ../b.md\n"
                         "docs/a.md:4: no heading 'b' in this page\n")
        self.assertIn("no heading 'no-heading'", self.links("[b](../b.md#no-heading)"))
        self.assertIn("out of the repository", self.links("[b](../../x.md)"))
        self.assertIn("docs/a.md:2: there is no c.md", self.links("[a link\nover lines](c.md)"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
