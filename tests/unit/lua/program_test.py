# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""rttlua with components: test.py RTTLUA COMPONENTS"""
import pathlib
import signal

from lua_case import RTTLUA, LuaCase, main

# As in the manual, with components of the library.
DEPLOYMENT = """
local tc = rtt.getTC()
local d = tc:getPeer("Deployer")
assert(d:import("ocl"))
assert(d:loadComponent("producer", "OCL::LuaComponent"))
assert(d:loadComponent("consumer", "OCL::LuaComponent"))
local producer, consumer = d:getPeer("producer"), d:getPeer("consumer")
assert(producer:exec_str([[
    port = rtt.OutputPort.new("double", "out")
    rtt.getTC():addPort(port)
    function updateHook() port:write(4.5) end
    function stopHook() print("producer stops") io.flush() end
]]))
assert(consumer:exec_str([[
    port = rtt.InputPort.new("double", "inp")
    rtt.getTC():addEventPort(port)
    function updateHook() local status, value = port:read() if status == "NewData" then result:write(value) end end
    result = rtt.OutputPort.new("double", "result")
    rtt.getTC():addPort(result)
    function cleanupHook() print("consumer cleans up") io.flush() end
]]))
local policy = rtt.Variable.new("ConnPolicy")
assert(d:connect("producer.out", "consumer.inp", policy))
assert(d:setActivity("producer", 0.01, 0, rtt.globals_get("ORO_SCHED_OTHER")))
for _, each in ipairs({consumer, producer}) do assert(each:configure() and each:start()) end
local answer = rtt.InputPort.new("double", "answer")
tc:addPort(answer)
assert(d:connect("consumer.result", "lua.answer", policy))
local status, value
repeat rtt.sleep(0, 10000000) status, value = answer:read() until status == "NewData"
print("value", value, producer:getState())
"""


class Components(LuaCase):
    def test_are_there(self):
        self.assertEqual((0, "lua\tDeployer\tlua\n", ""), self.run_lua(
            "-e", "tc = rtt.getTC() d = tc:getPeer('Deployer') print(tc:getName(), d:getName(), d:getPeer('lua'):getName())"))

    def test_are_deployed_and_taken_down(self):
        self.write("deploy.lua", DEPLOYMENT)
        self.assertEqual((0, "value\t4.5\tRunning\nproducer stops\nconsumer cleans up\n", ""), self.run_lua("deploy.lua"))

    def test_are_taken_down_at_os_exit(self):
        self.write("deploy.lua", DEPLOYMENT + "os.exit(3)\nprint('never')")
        self.assertEqual((3, "value\t4.5\tRunning\nproducer stops\nconsumer cleans up\n", ""), self.run_lua("deploy.lua"))

    def test_are_taken_down_after_an_error(self):
        self.write("deploy.lua", DEPLOYMENT + "error('failed')")
        status, out, err = self.run_lua("deploy.lua")
        self.assertEqual((1, "value\t4.5\tRunning\nproducer stops\nconsumer cleans up\n"), (status, out))
        self.assertTrue(err.startswith(f"rttlua: deploy.lua:{DEPLOYMENT.count(chr(10)) + 1}: failed\nstack traceback:\n"), err)

    def test_are_taken_down_at_signals(self):
        for number in signal.SIGTERM, signal.SIGHUP, signal.SIGINT:
            with self.subTest(number):
                self.write("deploy.lua", DEPLOYMENT + "io.flush()\nwhile true do rtt.sleep(1) end")
                started = self.start("deploy.lua")
                self.assertEqual("value\t4.5\tRunning\n", started.stdout.readline())
                started.send_signal(number)
                out, _ = started.communicate(timeout=20)
                self.assertEqual((1, "producer stops\nconsumer cleans up\n"), (started.returncode, out))

    def test_are_looked_at_from_outside(self):
        oro = str(pathlib.Path(RTTLUA).parent / "oro")
        ours = {"XDG_RUNTIME_DIR": str(self.directory)}
        program = self.start("-e", "print('on') io.stdout:flush() while true do end", **ours)
        self.assertEqual("on\n", program.stdout.readline())
        self.assertIn("rttlua", self.run_lua("list", program=oro, **ours)[1])
        self.assertIn("\nlua  ", self.run_lua("tree", program=oro, **ours)[1])
        self.assertEqual(0, self.run_lua("stop", program=oro, **ours)[0])
        program.wait(20)
        program = self.start("--no-live", "-e", "print('on') io.stdout:flush() while true do end", **ours)
        program.stdout.readline()
        self.assertEqual(3, self.run_lua("tree", program=oro, **ours)[0])
        self.assertIn("unknown permission 'all'", self.run_lua("--web", "--web-allow=all", **ours)[2])
        status, out, _ = self.run_lua("--web=127.0.0.1:0", "-e", "print(1)", **ours)
        self.assertEqual(0, status)
        self.assertRegex(out, r"^live window: ws://127\.0\.0\.1:\d+/\?token=\w+\n1\n$")

    def test_wait_for_a_signal_in_the_script(self):
        self.write("deploy.lua", DEPLOYMENT + "io.flush()\nd:waitForInterrupt()\nprint('goes on')")
        started = self.start("deploy.lua")
        while "waiting" not in started.stdout.readline():
            pass
        started.send_signal(signal.SIGINT)
        out, _ = started.communicate(timeout=20)
        self.assertEqual(0, started.returncode)
        self.assertIn("goes on\nproducer stops\nconsumer cleans up\n", out)

    def test_end_the_program(self):
        # In the thread of the component "lua", while the script waits.
        self.write("exit.lua", "function updateHook() os.exit(8) end\nlocal tc = rtt.getTC()\n"
                               "assert(tc:configure() and tc:start())\nrtt.sleep(20)\nprint('never')")
        status, out, _ = self.run_lua("exit.lua")
        self.assertEqual((8, ""), (status, out))

    def test_log_as_the_environment_says(self):
        for level, shown in ("6", True), ("2", False):
            _, out, err = self.run_lua("-e", "rtt.logl('Warning', 'a warning')", ORO_LOGLEVEL=level)
            self.assertEqual(shown, "a warning" in out + err)


class UsersFile(LuaCase):
    def test_is_executed_first(self):
        (self.home / ".rttlua").write_text("print('users file') mine = 5")
        self.assertEqual((0, "users file\ninit\n5\n", ""),
                         self.run_lua("-e", "print(mine)", LUA_INIT="print('init')"))

    def test_ends_nothing_if_it_fails(self):
        (self.home / ".rttlua").write_text("\nerror('broken')")
        status, out, err = self.run_lua("-e", "print('goes on')")
        self.assertEqual((0, "goes on\n"), (status, out))
        self.assertTrue(err.startswith(f"rttlua: {self.home}/.rttlua:2: broken\n"), err)

    def test_may_end_the_program(self):
        (self.home / ".rttlua").write_text("os.exit(4)")
        self.assertEqual((4, "", ""), self.run_lua("-e", "print('never')"))

    def test_is_told_of_if_it_is_none(self):
        (self.home / ".rttlua").mkdir()
        self.assertEqual((0, "1\n", f"rttlua: {self.home}/.rttlua: is not executed, because it is no regular file\n"),
                         self.run_lua("-e", "print(1)"))


if __name__ == "__main__":
    main()
