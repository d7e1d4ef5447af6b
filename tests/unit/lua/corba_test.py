# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""rttlua with CORBA: test.py RTTLUA-CORBA COMPONENTS"""
from lua_case import LuaCase, main

SHOWS = "print(rtt.getTC():getPeer('Deployer'):hasOperation('server'), ...)"


class Corba(LuaCase):
    def test_is_there_if_it_is_asked_for(self):
        self.write("show.lua", SHOWS)
        self.assertEqual((0, "false\ta\n", ""), self.run_lua("show.lua", "a"))
        self.assertFalse((self.directory / "Deployer.ior").exists())
        status, out, _ = self.run_lua("show.lua", "a", "--", "-ORBtraceLevel", "0")
        self.assertEqual(0, status)
        self.assertIn("true\ta\n", out)
        self.assertTrue((self.directory / "Deployer.ior").exists())

    def test_another_process_uses_the_deployer(self):
        self.write("serve.lua", "rtt.getTC():getPeer('Deployer'):waitForInterrupt() print('ends')")
        serving = self.start("serve.lua", "--")
        while "waiting for an interrupt" not in serving.stdout.readline():
            pass
        self.write("use.lua", "d = rtt.getTC():getPeer('Deployer') assert(d:loadComponent('other', 'IORFile')) "
                              "print(d:getPeer('other'):getName())")
        (self.directory / "other").write_text((self.directory / "Deployer.ior").read_text())
        status, out, err = self.run_lua("use.lua", "--")
        self.assertEqual(0, status, err)
        self.assertIn("Deployer\n", out)
        serving.terminate()
        self.assertIn("ends\n", serving.communicate(timeout=20)[0])
        self.assertEqual(0, serving.returncode)


if __name__ == "__main__":
    main()
