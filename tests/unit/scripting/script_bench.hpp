// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Loads programs and functions into a component by hand, without the service that does it for users.
#ifndef OROFORGE_TESTS_SCRIPTING_SCRIPT_BENCH_HPP
#define OROFORGE_TESTS_SCRIPTING_SCRIPT_BENCH_HPP

#include <rtt/TaskContext.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/scripting/ProgramInterface.hpp>
#include <rtt/scripting/detail/compile/compiler.hpp>

#include <map>
#include <string>

namespace script_test {

class ScriptBench {
public:
    explicit ScriptBench(RTT::TaskContext& component);

    /** The functions and programs of a text. What was reported, in lines; empty if nothing was. */
    std::string load(const std::string& text);
    RTT::scripting::ProgramInterface& operator[](const std::string& program) { return *programs.at(program); }
    RTT::scripting::detail::CompileContext context(oroforge::diag::Sink& sink) const;

    RTT::TaskContext& component;
    const RTT::Service::shared_ptr scripting;
    RTT::scripting::detail::Functions functions;
    std::map<std::string, RTT::scripting::ProgramInterfacePtr> programs;
    const boost::intrusive_ptr<RTT::internal::ValueDataSource<unsigned int>> budget;
};

}  // namespace script_test

#endif
