// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ast_text.hpp"

#include <rtt/scripting/detail/syntax/parser.hpp>

#include <diag/print.hpp>

#include <sstream>

namespace tests {

namespace {

using namespace RTT::scripting::detail;  // NOLINT: the tree is the subject

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

template <class List, class Text>
std::string joined(const List& list, const char* separator, Text text) {
    std::string result;
    for (const auto& each : list) result += (result.empty() ? "" : separator) + text(each);
    return result;
}

std::string listed(const ast::Expressions& list) {
    return joined(list, ", ", [](const ast::ExpressionPtr& each) { return textOf(*each); });
}

std::string named(const std::vector<ast::Identifier>& names, const char* separator) {
    return joined(names, separator, [](const ast::Identifier& each) { return each.text; });
}

std::string number(double value) {
    std::ostringstream out;
    out.precision(17);
    out << value;
    const std::string text = out.str();
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string letters(const std::string& text) {
    static constexpr char digits[] = "01234567";
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte != 0x7F && c != '\\' && c != '"' && c != '\'') {
            result += c;
        } else {
            result += {'\\', digits[byte >> 6], digits[(byte >> 3) & 7], digits[byte & 7]};
        }
    }
    return result;
}

std::string valueText(const ast::Value& value) {
    return std::visit(
        Overloaded{[](bool v) { return std::string(v ? "true" : "false"); },
                   [](char v) { return "'" + letters(std::string(1, v)) + "'"; },
                   [](int v) { return std::to_string(v); }, [](unsigned int v) { return std::to_string(v) + "u"; },
                   [](long long v) { return std::to_string(v) + "ll"; },
                   [](unsigned long long v) { return std::to_string(v) + "ull"; },
                   [](float v) { return number(static_cast<double>(v)) + "f"; }, [](double v) { return number(v); },
                   [](const std::string& v) { return "\"" + letters(v) + "\""; }},
        value);
}

std::string blockText(const ast::Block& block) {
    const std::string inside =
        joined(block.statements, "; ", [](const ast::StatementPtr& each) { return textOf(*each); });
    return inside.empty() ? "{}" : "{ " + inside + " }";
}

std::string after(const char* word, const std::unique_ptr<ast::Block>& block) {
    return block ? std::string(" ") + word + " " + blockText(*block) : "";
}

std::string sized(const ast::ExpressionPtr& size) { return size ? "(" + textOf(*size) + ")" : ""; }

std::string declarationText(const ast::Declaration& declaration) {
    static constexpr const char* words[] = {"var ", "const ", "alias ", "param "};
    return words[static_cast<int>(declaration.kind)] + declaration.type.text + " " +
           joined(declaration.names, ", ", [](const ast::Declarator& each) {
               return each.name.text + sized(each.size) + (each.value ? " = " + textOf(*each.value) : "");
           });
}

std::string functionText(const ast::Function& function) {
    static constexpr const char* scopes[] = {"local ", "export ", "global "};
    return scopes[static_cast<int>(function.scope)] + function.type.text + " " + function.name.text + "(" +
           joined(function.arguments, ", ",
                  [](const ast::Function::Argument& each) {
                      return each.type.text + " " + each.name.text + sized(each.size);
                  }) +
           ") " + blockText(function.body);
}

std::string instanceText(const char* word, const ast::Instance& instance) {
    return word + instance.type.text + " " + instance.name.text + "(" +
           joined(instance.arguments, ", ",
                  [](const ast::Instance::Argument& each) { return each.name.text + " = " + textOf(*each.value); }) +
           ")";
}

std::string selectionText(const ast::Selection& selection) {
    std::string text = selection.program ? blockText(*selection.program) : "";
    if (!selection.states.empty()) text += (text.empty() ? "select " : " select ") + named(selection.states, " or ");
    return text;
}

std::string transitionText(const ast::Transition& transition, const char* word) {
    std::string text = word;
    if (!transition.event.empty()) text += named(transition.event, ".") + "(" + listed(transition.arguments) + ") ";
    if (transition.condition) text += "if " + textOf(*transition.condition) + " then ";
    text += selectionText(transition.selection);
    return transition.otherwise ? text + " else " + selectionText(*transition.otherwise) : text;
}

template <class List, class Text>
void addAll(std::string& to, const List& list, Text text) {
    for (const auto& each : list) to += text(each) + "; ";
}

std::string stateText(const ast::State& state) {
    std::string text = state.initial ? "initial state " : state.final ? "final state " : "state ";
    text += state.name.text + " { ";
    addAll(text, state.locals, [](const ast::StatementPtr& each) { return textOf(*each); });
    const std::pair<const char*, const std::unique_ptr<ast::Block>*> programs[] = {
        {"entry ", &state.entry}, {"run ", &state.run}, {"handle ", &state.handle}, {"exit ", &state.exit}};
    for (const auto& program : programs)
        if (*program.second) text += program.first + blockText(**program.second) + "; ";
    addAll(text, state.preconditions, [](const ast::ExpressionPtr& each) { return "precondition " + textOf(*each); });
    addAll(text, state.detours,
           [](const ast::Transition& each) { return "preconditions { " + transitionText(each, "") + " }"; });
    addAll(text, state.transitions, [](const ast::Transition& each) { return transitionText(each, "transition "); });
    return text + "}";
}

std::string machineText(const ast::StateMachine& machine) {
    std::string text = "StateMachine " + machine.type.text + " { ";
    addAll(text, machine.locals, [](const ast::StatementPtr& each) { return textOf(*each); });
    addAll(text, machine.subMachines, [](const ast::Instance& each) { return instanceText("SubMachine ", each); });
    addAll(text, machine.transitions, [](const ast::Transition& each) { return transitionText(each, "transition "); });
    addAll(text, machine.states, stateText);
    return text + "}";
}

std::string printed(const oroforge::diag::Sink& sink, const std::string& script) {
    oroforge::diag::SourceCache sources;
    sources.add("test.ops", script);
    std::ostringstream out;
    oroforge::diag::print(out, sink, sources);
    return out.str();
}

}  // namespace

std::string textOf(const ast::Expression& expression) {
    return std::visit(
        Overloaded{
            [](const ast::Literal& e) { return valueText(e.value); },
            [](const ast::CurrentTime&) { return std::string("time"); },
            [](const ast::Name& e) { return named(e.parts, ".") + (e.called ? "(" + listed(e.arguments) + ")" : ""); },
            [](const ast::Member& e) { return "(" + textOf(*e.of) + ")." + e.member.text; },
            [](const ast::Index& e) { return "(" + textOf(*e.of) + ")[" + textOf(*e.index) + "]"; },
            [](const ast::Unary& e) { return "(" + std::string(1, e.op) + textOf(*e.operand) + ")"; },
            [](const ast::Binary& e) {
                std::string row = textOf(*e.first);
                for (const auto& step : e.steps) row = "(" + row + " " + step.op + " " + textOf(*step.right) + ")";
                return row;
            },
            [](const ast::Assignment& e) { return "(" + textOf(*e.to) + " = " + textOf(*e.value) + ")"; }},
        expression.what);
}

std::string textOf(const ast::Statement& statement) {
    return std::visit(
        Overloaded{[](const ast::Declaration& s) { return declarationText(s); },
                   [](const ast::Do& s) { return textOf(*s.expression); },
                   [](const ast::Nothing&) { return std::string("nothing"); },
                   [](const ast::Yield&) { return std::string("yield"); },
                   [](const ast::Try& s) { return "try " + textOf(*s.attempt) + after("catch", s.handler); },
                   [](const ast::Return& s) { return s.value ? "return " + textOf(*s.value) : "return"; },
                   [](const ast::If& s) {
                       return "if " + textOf(*s.condition) + " then " + blockText(s.then) + after("else", s.otherwise);
                   },
                   [](const ast::While& s) { return "while " + textOf(*s.condition) + " " + blockText(s.body); },
                   [](const ast::For& s) {
                       return "for (" + textOf(*s.first) + "; " + textOf(*s.condition) + "; " + textOf(*s.next) + ") " +
                              blockText(s.body);
                   },
                   [](const ast::Break&) { return std::string("break"); }},
        statement.what);
}

std::string textOf(const ast::Item& item) {
    return std::visit(
        Overloaded{[](const ast::StatementPtr& i) { return textOf(*i); },
                   [](const ast::Function& i) { return functionText(i); },
                   [](const ast::Program& i) { return "program " + i.name.text + " " + blockText(i.body); },
                   [](const ast::StateMachine& i) { return machineText(i); },
                   [](const ast::Instance& i) { return instanceText("RootMachine ", i); }},
        item.what);
}

std::string textOf(const ast::Script& script) {
    return joined(script.items, " ; ", [](const ast::Item& each) { return textOf(each); });
}

std::string parsed(const std::string& script) {
    oroforge::diag::Sink sink;
    const ast::Script tree = parse(script, "test.ops", sink);
    if (!sink.empty()) return printed(sink, script);
    const std::string text = textOf(tree);
    const std::string again = textOf(parse(text, "again", sink));
    return again == text ? text : "read again, it is another script: " + again;
}

std::string complaints(const std::string& script) {
    oroforge::diag::Sink sink;
    parse(script, "test.ops", sink);
    return printed(sink, script);
}

}  // namespace tests
