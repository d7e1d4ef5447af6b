// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Any bytes are read as a script: a tree whose items lie where they say, or errors with their places.
#include "../unit/scripting/ast_text.hpp"
#include "fuzzing.hpp"

#include <rtt/scripting/detail/syntax/parser.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace {

namespace ast = RTT::scripting::detail::ast;
namespace diag = oroforge::diag;

bool before(ast::Place a, ast::Place b) { return a.line != b.line ? a.line < b.line : a.column <= b.column; }

void checkPlaces(const ast::Script& script, const std::string& text) {
    std::size_t at = 0;
    for (const ast::Item& item : script.items) {
        require(at <= item.begin && item.size > 0 && item.begin + item.size <= text.size(), "items lie in order");
        require(item.at.line != 0 && item.at.column != 0 && before(item.at, item.end), "items have places");
        at = item.begin + item.size;
    }
}

void checkErrors(const diag::Sink& sink, const std::string& text) {
    const auto lines = static_cast<unsigned>(std::count(text.begin(), text.end(), '\n') + 1);
    for (const diag::Diagnostic& error : sink.all())
        require(error.where.line != 0 && error.where.line <= lines && error.where.column != 0 && !error.code.empty(),
                "errors have places");
    require(sink.all().size() <= text.size() + 1, "there are no more errors than letters");
}

/// The tree, written as a script, is the same script. Parentheses that were not there can make it too deep.
void checkMeaning(const ast::Script& script) {
    const std::string written = tests::textOf(script);
    diag::Sink sink;
    const ast::Script again = RTT::scripting::detail::parse(written, "written", sink);
    if (sink.hadErrors()) {
        require(std::all_of(sink.all().begin(), sink.all().end(), [](const auto& e) { return e.code == "OPS010"; }),
                "what is written can be read");
    } else {
        require(tests::textOf(again) == written, "what is written is the same script");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    diag::Sink sink;
    const ast::Script script = RTT::scripting::detail::parse(text, "input", sink);
    checkErrors(sink, text);
    if (sink.hadErrors()) return 0;
    checkPlaces(script, text);
    checkMeaning(script);
    return 0;
}
