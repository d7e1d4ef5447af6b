#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
import unittest

from planted_tree import check_none, check_one

SCRIPT = "check_layers.py"


class CheckLayers(unittest.TestCase):
    def test_downward_includes_are_fine(self):
        check_none(self, SCRIPT, {
            "runtime/diag/sink.hpp": "",
            "runtime/rtt/os/Mutex.hpp": "#include <rtt/rtt-config.h>\n",
            "runtime/rtt/rtt-config.h.in": "",
            "runtime/rtt/Port.hpp": '#include "os/Mutex.hpp"\n#include <vector>\n',
            "runtime/rtt/plugin/detail/find.hpp": "",
            "runtime/rtt/plugin/PluginLoader.cpp": '#include "detail/find.hpp"\n#include <rtt/Port.hpp>\n#include <diag/sink.hpp>\n',
            "generator/clang/base/reader.cpp": "#include <clang/AST/Decl.h>\n#include <diag/sink.hpp>\n",
        })

    def test_os_must_not_know_core(self):
        check_one(self, SCRIPT, {"runtime/rtt/Port.hpp": "",
                                 "runtime/rtt/os/Mutex.cpp": '\n#include "../Port.hpp"\n'},
                  "runtime/rtt/os/Mutex.cpp:2: error: [LAY01]")

    def test_core_must_not_know_scripting_even_if_not_written_yet(self):
        check_one(self, SCRIPT, {"runtime/rtt/TaskContext.cpp": "#include <rtt/scripting/Parser.hpp>\n"},
                  "runtime/rtt/TaskContext.cpp:1: error: [LAY01] layer 'core' includes runtime/rtt/scripting/Parser.hpp")

    def test_transports_do_not_know_each_other(self):
        check_one(self, SCRIPT, {"runtime/rtt/transports/mqueue/Lib.cpp": "#include <rtt/transports/corba/Lib.hpp>\n",
                                 "runtime/rtt/transports/corba/Lib.hpp": ""},
                  "runtime/rtt/transports/mqueue/Lib.cpp:1: error: [LAY01]")

    def test_generator_must_not_know_runtime(self):
        check_one(self, SCRIPT, {"generator/view/view.cpp": "#include <rtt/Port.hpp>\n", "runtime/rtt/Port.hpp": ""},
                  "generator/view/view.cpp:1: error: [LAY01]")

    def test_render_must_not_know_model(self):
        check_one(self, SCRIPT, {"generator/render/renderer.cpp": "#include <model/package.hpp>\n",
                                 "generator/model/package.hpp": ""},
                  "generator/render/renderer.cpp:1: error: [LAY01]")

    def test_clang_only_in_its_folder(self):
        check_one(self, SCRIPT, {"generator/model/type.hpp": "#include <llvm/ADT/StringRef.h>\n"},
                  "generator/model/type.hpp:1: error: [LAY02]")
        check_one(self, SCRIPT, {"generator/model/type.hpp": "#include <clang/AST/Decl.h>\n"},
                  "generator/model/type.hpp:1: error: [LAY02]")

    def test_typegen_reads_no_components(self):
        for room in ("describe", "update"):
            check_one(self, SCRIPT, {f"generator/clang/{room}/read.hpp": "",
                                     "typekit_gen/driver/typegen.cpp": f"#include <clang/{room}/read.hpp>\n"},
                      f"typekit_gen/driver/typegen.cpp:1: error: [LAY01] layer 'typegen' includes generator/clang/{room}")

    def test_deployer_must_not_know_the_generator(self):
        check_one(self, SCRIPT, {"generator/explain/explanations.hpp": "",
                                 "deployer/bin/program.cpp": "#include <explain/explanations.hpp>\n"},
                  "deployer/bin/program.cpp:1: error: [LAY01]")

    def test_reports_are_written_by_programs_only(self):
        check_one(self, SCRIPT, {"runtime/report/report.hpp": "",
                                 "deployer/deployment/load.cpp": "#include <report/report.hpp>\n"},
                  "deployer/deployment/load.cpp:1: error: [LAY01]")
        check_one(self, SCRIPT, {"deployer/bin/program.cpp": "#include <nlohmann/json.hpp>\n"},
                  "deployer/bin/program.cpp:1: error: [LAY02]")

    def test_detail_is_private(self):
        check_one(self, SCRIPT, {"runtime/rtt/marsh/detail/read.hpp": "",
                                 "deployer/console/load.cpp": "#include <rtt/marsh/detail/read.hpp>\n"},
                  "deployer/console/load.cpp:1: error: [LAY03]")

    def test_installed_header_includes_installed_headers_only(self):
        check_one(self, SCRIPT, {"runtime/diag/sink.hpp": "",
                                 "runtime/rtt/marsh/Loader.hpp": "#include <diag/sink.hpp>\n"},
                  "runtime/rtt/marsh/Loader.hpp:1: error: [LAY04]")

    def test_templates_fill_in_installed_headers_only(self):
        check_one(self, SCRIPT, {"runtime/xml/element.hpp": "",
                                 "templates/component/base.hpp.mustache": "#include <xml/element.hpp>\n"},
                  "templates/component/base.hpp.mustache:1: error: [LAY01]")

    def test_every_source_has_a_layer(self):
        check_one(self, SCRIPT, {"generator/misc/helper.cpp": ""}, "generator/misc/helper.cpp:1: error: [LAY05]")

    def test_headers_do_not_include_each_other(self):
        check_one(self, SCRIPT, {"runtime/rtt/os/Mutex.hpp": "#include <rtt/os/Lock.hpp>\n",
                                 "runtime/rtt/os/Lock.hpp": "#include <rtt/os/Mutex.hpp>\n"},
                  "runtime/rtt/os/Mutex.hpp:1: error: [LAY06]")

    def test_includes_in_comments_do_not_count(self):
        check_none(self, SCRIPT, {"runtime/rtt/os/Timer.hpp": "/* like this:\n#include <rtt/Port.hpp>\n*/\n"
                                                              "// #include <rtt/Port.hpp>\n",
                                  "runtime/rtt/Port.hpp": ""})


if __name__ == "__main__":
    unittest.main()
