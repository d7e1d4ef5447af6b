// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "script_bench.hpp"

#include <rtt/scripting/detail/function/function_operation.hpp>
#include <rtt/scripting/detail/syntax/parser.hpp>
#include <rtt/scripting/detail/execute/program.hpp>
#include <rtt/scripting/detail/compile/source_file.hpp>

#include <diag/print.hpp>

#include <memory>

namespace script_test {

using namespace RTT::scripting;
using namespace RTT::scripting::detail;

ScriptBench::ScriptBench(RTT::TaskContext& c)
    : component(c), scripting(c.provides("scripting")), budget(new RTT::internal::ValueDataSource<unsigned int>(0)) {}

CompileContext ScriptBench::context(oroforge::diag::Sink& sink) const {
    CompileContext where;
    where.component = &component;
    where.caller = component.engine();
    where.functions = &functions;
    where.file = "bench.ops";
    where.sink = &sink;
    where.roundLimit = budget;
    return where;
}

std::string ScriptBench::load(const std::string& text) {
    oroforge::diag::Sink sink;
    const auto file = std::make_shared<SourceFile>("bench.ops", text, nullptr);
    file->tree = parse(text, file->name, sink);
    for (const ast::Item& item : file->tree.items) {
        if (sink.hadErrors()) break;
        if (const auto* function = std::get_if<ast::Function>(&item.what)) {
            const auto definition = std::make_shared<FunctionDefinition>();
            definition->name = function->name.text;
            definition->tree = partOf(file, *function);
            definition->scope = partOf(file, file->scope);
            definition->file = file->name;
            if (addFunction(definition, function->scope, *scripting, context(sink)))
                functions[definition->name] = definition;
        }
        if (const auto* program = std::get_if<ast::Program>(&item.what)) {
            const ProgramInterfacePtr made = makeProgram(*program, *file, file->textOf(item), context(sink));
            if (made && component.engine()->runFunction(made.get())) programs[made->getName()] = made;
        }
    }
    std::string reported;
    for (const auto& diagnostic : sink.sorted()) reported += oroforge::diag::toString(diagnostic) + "\n";
    return reported;
}

}  // namespace script_test
