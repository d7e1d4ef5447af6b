// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Compiles and executes pieces of script in a component, without the service.
#ifndef OROFORGE_SCRIPT_FIXTURE_HPP
#define OROFORGE_SCRIPT_FIXTURE_HPP

#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/scripting/detail/compile/compiler.hpp>
#include <rtt/scripting/detail/syntax/parser.hpp>

#include <diag/print.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <string>
#include <vector>

class ScriptTest : public ::testing::Test {
protected:
    typedef RTT::scripting::detail::Process::Outcome Outcome;

    ScriptTest() : component("robot") { RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE); }

    /** Executes the statements of a file, one after the other; true if all of them could be. */
    bool run(const std::string& text) {
        using namespace RTT::scripting::detail;
        sink = oroforge::diag::Sink();
        trees.push_back(std::make_shared<ast::Script>(parse(text, "script.ops", sink)));
        if (sink.hadErrors()) return false;
        for (auto& item : trees.back()->items) {
            if (auto* const function = std::get_if<ast::Function>(&item.what)) {
                define(*function, trees.back());
                continue;
            }
            Compiler compiler(context());
            auto* const statement = std::get_if<ast::StatementPtr>(&item.what);
            const auto code = statement ? compiler.statement(**statement, scope) : program(compiler, item);
            if (!code) return false;
            Process process(*code);
            while (process.run() == Outcome::Yielded) ++yields;
            if (!process.failed()) continue;
            sink.error({"script.ops", process.place().line, process.place().column}, "OPS400", process.message());
            return false;
        }
        return true;
    }
    /** All messages of the last run, one per line, without the lines of the text. */
    std::string messages() const {
        std::string text;
        for (const auto& each : sink.all()) text += toString(each) + "\n";
        return text;
    }
    /** Of a variable of the script. */
    template <class T>
    T value(const std::string& name) {
        const auto* const entry = scope.find(name);
        auto* const source =
            entry && entry->source ? RTT::internal::DataSource<T>::narrow(entry->source.get()) : nullptr;
        EXPECT_TRUE(source) << name << " is no variable of that type";
        return source ? source->get() : T();
    }
    /** Of an expression; "error" if it has none. */
    template <class T>
    T result(const std::string& type, const std::string& expression) {
        const std::string name = "result" + std::to_string(++results);
        EXPECT_TRUE(run("var " + type + " " + name + " = " + expression)) << expression << "\n" << messages();
        return value<T>(name);
    }

    RTT::scripting::detail::CompileContext context() {
        RTT::scripting::detail::CompileContext where;
        where.component = &component;
        where.caller = RTT::internal::GlobalEngine::Instance();
        where.functions = &functions;
        where.file = "script.ops";
        where.sink = &sink;
        return where;
    }

    RTT::TaskContext component;
    oroforge::diag::Sink sink;
    RTT::scripting::detail::Scope scope{"the script"};
    RTT::scripting::detail::Functions functions;
    int yields = 0;

private:
    std::unique_ptr<RTT::scripting::detail::Code> program(RTT::scripting::detail::Compiler& compiler,
                                                          RTT::scripting::detail::ast::Item& item) {
        const auto& tree = std::get<RTT::scripting::detail::ast::Program>(item.what);
        return compiler.program(tree.body, "program '" + tree.name.text + "'", scope);
    }
    void define(RTT::scripting::detail::ast::Function& function,
                const std::shared_ptr<RTT::scripting::detail::ast::Script>& script) {
        auto made = std::make_shared<RTT::scripting::detail::FunctionDefinition>();
        made->name = function.name.text;
        made->tree = std::shared_ptr<const RTT::scripting::detail::ast::Function>(script, &function);
        made->scope = std::shared_ptr<const RTT::scripting::detail::Scope>(script, &scope);
        made->file = "script.ops";
        functions[made->name] = made;
    }
    int results = 0;
    std::vector<std::shared_ptr<RTT::scripting::detail::ast::Script>> trees;
};

#endif
