// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef TESTS_UNIT_SCRIPTING_PROGRAM_FIXTURE_HPP
#define TESTS_UNIT_SCRIPTING_PROGRAM_FIXTURE_HPP

#include "script_bench.hpp"

#include <rtt/scripting/detail/execute/program.hpp>
#include <unit/operations/probe.hpp>
#include <unit/types/builtin_typekit.hpp>

#include <stdexcept>

namespace script_test {

using oroforge::test::Probe;

/** A component whose steps are made by step(), with a variable and operations for the script. */
struct Programs : types_test::WithBuiltinTypes {
    Programs() {
        oroforge::test::makeManual(host);
        host.addAttribute("count", count);
        host.addOperation("note", [this](const std::string& text) { notes += text; });
        host.addOperation("fail", [this] {
            if (broken) throw std::runtime_error("the gripper is stuck");
        });
    }
    void step(int times = 1) {
        for (int i = 0; i != times; ++i) ASSERT_TRUE(host.update());
    }
    void load(const std::string& text) { ASSERT_EQ(bench.load(text), ""); }
    RTT::scripting::ProgramInterface& p() { return bench["p"]; }
    std::string status() { return p().getProgramStatusStr(); }

    Probe host{"host"};
    int count = 0;
    std::string notes;
    bool broken = true;
    ScriptBench bench{host};
};

}  // namespace script_test
#endif
