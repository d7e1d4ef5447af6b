# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""oro record and a real deployer; oro-mcap reads what it has written."""
import json
import os
import pathlib
import signal
import statistics
import subprocess
import sys
import time
import unittest

# Before oro_case takes its words.
TOOL = sys.argv.pop(5)

from oro_case import SOURCES, OroCase, main  # noqa: E402

SCRIPT = """
import("ocl")
import("filling")
loadComponent("tank", "filling::Tank")
loadComponent("hello", "OCL::HelloWorld")
setActivity("hello", 0.002, 0, ORO_SCHED_OTHER)
hello.configure()
hello.start()
tank.capacity = 1.5
tank.configure()
tank.start()
"""


class Recording(OroCase):
    def setUp(self):
        super().setUp()
        self.deployer = self.deploy(SCRIPT)

    def tool(self, *words, status=0):
        done = subprocess.run([TOOL, *words], cwd=self.directory, text=True, capture_output=True, timeout=20, check=False)
        self.assertEqual((status, ""), (done.returncode, done.stderr), words)
        return done.stdout

    def messages(self, file, topic):
        return [json.loads(line) for line in self.tool("cat", file, "--topic", topic).splitlines()]

    def topics(self, file):
        """Messages and missing ones, by topic."""
        lines = self.tool("info", file).splitlines()
        begin = next(i for i, line in enumerate(lines) if line.startswith("topic "))
        words = [line.split() for line in lines[begin + 1:]]
        return {one[0]: (one[1], int(one[2]), int(one[3])) for one in words}

    def start_recording(self, *words):
        process = self.start_oro("record", "--format=json", *words)
        self.said = process.stderr.readline()
        while "recording to" not in self.said.splitlines()[-1]:
            self.said += process.stderr.readline()
        return process

    def ended(self, process, status=0):
        """The summary."""
        self.assertEqual(status, process.wait(15), process.stderr)
        return json.loads(process.stdout.read())

    def interrupt(self, process, status=0):
        process.send_signal(signal.SIGINT)
        return self.ended(process, status)

    def test_samples_are_in_the_file_after_half_a_second(self):
        process = self.start_recording("hello.*", "-o", "steps.mcap")
        file, sizes, until = self.directory / "steps.mcap", set(), time.monotonic() + 3.2
        while time.monotonic() < until:
            sizes.add(file.stat().st_size)
            time.sleep(0.01)
        process.kill()
        self.assertGreaterEqual(len(sizes), 6, sizes)  # the head, and a chunk every 0.5 s

    def test_all_ports_and_the_log_are_recorded(self):
        process = self.start_recording("-o", "all.mcap")
        time.sleep(0.3)
        self.oro("call", "tank.fill", "0.75")
        self.oro("set", "tank.capacity", "2")
        time.sleep(0.1)
        done = self.interrupt(process)
        topics = self.topics("all.mcap")
        self.assertEqual(("std_msgs/msg/Float64", 2, 0), topics["/tank/level"])
        self.assertEqual("std_msgs/msg/String", topics["/hello/the_results"][0])
        self.assertGreater(topics["/hello/the_results"][1], 50)
        self.assertEqual(0, topics["/hello/the_results"][2])
        self.assertEqual([0, 0.75], [one["message"]["data"] for one in self.messages("all.mcap", "/tank/level")])
        self.assertTrue(any("tank.capacity" in one["message"]["msg"] for one in self.messages("all.mcap", "/rosout")))
        self.assertEqual((0, sum(one[1] for one in topics.values())), (done["lost"], done["messages"]))
        self.assertEqual((self.directory / "all.mcap").stat().st_size, done["bytes"])
        info = self.tool("info", "all.mcap")
        self.assertRegex(info, r"metadata +oroforge: .*command=.*-s app\.ops .*deployment=Deployer .*packages=.*ocl.*version=")
        self.assertIn("oroforge.lost: all=0\n", info)

    def test_times_are_those_of_writing(self):
        self.oro("call", "setActivity", "hello", "0.001", "0", "0")
        self.ended(self.start_recording("hello", "-o", "times.mcap", "--duration", "1"))
        times = [one["time"] * 1e9 for one in self.messages("times.mcap", "/hello/the_results")]
        distances = [after - before for before, after in zip(times, times[1:])]
        self.assertGreater(len(distances), 100)
        self.assertGreaterEqual(min(distances), 0)
        # Of those that are read together, every 10 ms, most would have none. A computer under load makes them longer.
        self.assertTrue(2e5 < statistics.median(distances) < 5e6, statistics.median(distances))

    def test_what_finds_no_room_is_a_gap_and_is_counted(self):
        process = self.start_recording("hello", "-o", "gaps.mcap", "--buffer", "1", "--compression", "lz4")
        time.sleep(1)
        done = self.interrupt(process)
        messages = self.messages("gaps.mcap", "/hello/the_results")
        self.assertGreater(done["lost"], 10)
        self.assertEqual(len(messages), done["messages"])
        last = messages[-1]["sequence"]
        self.assertLessEqual(len(messages) + self.topics("gaps.mcap")["/hello/the_results"][2], last + 1)
        # What was dropped behind the last message is in no gap.
        self.assertIn(done["lost"] - (last + 1 - len(messages)), range(10))
        self.assertIn(f"oroforge.lost: /hello/the_results={done['lost']} all={done['lost']}\n", self.tool("info", "gaps.mcap"))

    @unittest.skipUnless(pathlib.Path(os.environ.get("JUDGES", ""), "node_modules").is_dir(), "./dev judges installs the readers")
    def test_others_read_it(self):
        self.ended(self.start_recording("hello", "rosout", "-o", "others.mcap", "--buffer", "1", "--duration", "1"))
        judge = str(pathlib.Path(SOURCES) / "tests/judges/recording.mjs")
        done = subprocess.run(["node", judge, "count", str(self.directory / "others.mcap")], cwd=os.environ["JUDGES"],
                              text=True, capture_output=True, timeout=20, check=True)
        found = json.loads(done.stdout)
        missing = int(found["metadata"]["oroforge.lost"]["/hello/the_results"])
        self.assertEqual((True, self.topics("others.mcap")["/hello/the_results"][1]),
                         (found["ordered"], found["counts"]["/hello/the_results"]))
        self.assertIn(missing - found["gaps"], range(10))

    def test_a_recorder_that_is_stopped_holds_nothing_up(self):
        process = self.start_recording("hello", "-o", "stopped.mcap")
        time.sleep(0.3)
        process.send_signal(signal.SIGSTOP)
        time.sleep(1)
        self.assertEqual("true\n", self.oro("call", "tank.fill", "0.5")[0])
        process.send_signal(signal.SIGCONT)
        done = self.interrupt(process)
        # 16 MiB wait for it.
        self.assertEqual(0, done["lost"])
        self.assertGreater(done["messages"], 200)

    def test_components_come_and_go(self):
        process = self.start_recording("tank.level", "late.*", "-o", "late.mcap")
        self.assertIn("no output port matches 'late.*'; it is recorded if it comes\n", self.said)
        self.assertIn("no output port matches 'late.*'", self.start_oro("record", "late.*", "-o", "x").communicate()[1])
        lines = ['loadComponent("late", "OCL::HelloWorld")', 'setActivity("late", 0.01, 0, ORO_SCHED_OTHER)',
                 "late.configure()", "late.start()"]
        for _ in range(2):
            self.oro("console", text="\n".join(lines) + "\n")
            time.sleep(1.3)
            self.oro("console", text='late.stop()\nlate.cleanup()\nunloadComponent("late")\n')
        done = self.interrupt(process)
        topics = self.topics("late.mcap")
        self.assertEqual({"/tank/level", "/late/the_results"}, set(topics))
        self.assertGreater(topics["/late/the_results"][1], 4)
        self.assertEqual(0, done["lost"])

    def test_the_end_of_the_deployment_ends_the_file(self):
        process = self.start_recording("hello", "-o", "end.mcap")
        time.sleep(0.8)
        self.deployer.kill()
        done = self.ended(process)
        self.assertIn("has ended; the recording ends", process.stderr.read())
        self.assertGreater(done["messages"], 50)
        self.assertEqual(done["messages"], self.topics("end.mcap")["/hello/the_results"][1])

    def test_files_are_split_and_kept(self):
        (self.directory / "run_1.mcap").write_text("of somebody")
        done = self.ended(self.start_recording("hello", "-o", "run.mcap", "--split", "0.5 s", "--duration", "1.8"))
        self.assertGreater(done["files"], 1)
        self.assertEqual("of somebody", (self.directory / "run_1.mcap").read_text())
        files = sorted(set(self.directory.glob("*.mcap")) - {self.directory / "run_1.mcap"})
        self.assertEqual(done["files"], len(files))
        self.assertEqual(done["messages"], sum(self.topics(one.name)["/hello/the_results"][1] for one in files))
        self.assertIn("'run.mcap' exists already; --force overwrites it", self.oro("record", "-o", "run.mcap", status=1)[1])
        out, _ = self.oro("record", "hello", "-o", "run.mcap", "--force", "--duration", "0.3")
        self.assertRegex(out, r"^run\.mcap: \d+ messages of 1 topic, 0 lost, \d+ bytes, 0\.\d s\n$")

    def test_the_name_has_the_deployment_and_the_time(self):
        self.oro("record", "tank", "--duration", "0.1")
        names = [one.name for one in self.directory.glob("*.mcap")]
        self.assertEqual(1, len(names))
        self.assertRegex(names[0], r"^Deployer_\d{4}-\d\d-\d\d_\d\d-\d\d-\d\d\.mcap$")

    def test_what_is_wrong_is_reported(self):
        _, err = self.oro("record", "tank.levle", "-o", "x.mcap", status=1)
        self.assertIn("no output port matches 'tank.levle'; did you mean 'tank.level'?; there are ", err)
        self.assertFalse((self.directory / "x.mcap").exists())
        self.assertIn("did you mean 'zstd'?", self.oro("record", "--compression", "zst", status=2)[1])
        self.assertIn("such as '500 MB' or '60 s'", self.oro("record", "--split", "often", status=2)[1])
        self.assertIn("[MCP009]", self.oro("record", "-o", "/dev/full", "--duration", "1", status=1)[1])
        self.assertIn("could not open file", self.oro("record", "-o", "no/where.mcap", status=1)[1])

    def test_topics_and_globs_are_patterns(self):
        self.ended(self.start_recording("/tank/level", "h*.the_res*", "-o", "p.mcap", "--duration", "0.2"))
        self.assertEqual({"/tank/level", "/hello/the_results"}, set(self.topics("p.mcap")))
        self.ended(self.start_recording("rosout", "-o", "log.mcap", "--duration", "0.1"))
        self.assertEqual("tank.level", self.oro("__complete", "record", "tank.")[0].split("\t")[0])


main()
