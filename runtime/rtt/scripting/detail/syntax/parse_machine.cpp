// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_rules.hpp>

#include <diag/nearest_match.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

namespace {

using oroforge::diag::Diagnostic;

/** Suggests a similar word where a word does not begin an item of a list. */
void suggest(Diagnostic* error, const Token& token, std::string_view text, const std::vector<std::string>& words) {
    const bool known = std::find(words.begin(), words.end(), text) != words.end();
    if (error && !known && token.kind == TokenKind::Word)
        error->message += oroforge::diag::didYouMean(std::string(text), words);
}

}  // namespace

ast::StateMachine Parser::stateMachine() {
    ast::StateMachine result;
    advance();
    result.type = name("the name of a type of state machine");
    in_machine_ = true;
    recoverAtBrace();
    result.end = inBraces(&Parser::machineEndsHere, [&] { machineItem(result); });
    in_machine_ = false;
    return result;
}

void Parser::machineItem(ast::StateMachine& machine) {
    if (atWord("state") || atWord("initial") || atWord("final")) {
        machine.states.push_back(state());
    } else if (atTransitions()) {
        if (!machine.states.empty())
            report(place(), "OPS012",
                   "found transitions of the whole machine behind a state, expected them before the first one");
        transitions(machine.transitions);
    } else if (atDeclaration() || atWord("param")) {
        machine.locals.push_back(atDeclaration() ? declaration() : parameters());
        endStatement();
    } else if (atWord("SubMachine")) {
        machine.subMachines.push_back(instance());
        endStatement();
    } else {
        Diagnostic* error = failHere("a declaration, a transition, a state or '}'");
        suggest(
            error, token(), text(),
            {"state", "initial", "final", "transition", "transitions", "param", "var", "const", "alias", "SubMachine"});
    }
}

bool Parser::atState() const {
    if (atWordBeforeName("state")) return true;
    if (!atWord("initial") && !atWord("final")) return false;
    const Token next = following();
    return next.kind == TokenKind::Word && !next.newLine;
}

bool Parser::machineEndsHere() const { return atDefinition() && !following().newLine; }

bool Parser::stateEndsHere() const { return atState() || machineEndsHere(); }

/** True at `entry {`, `transitions {`, `transition select S` and the like, which are not statements. */
bool Parser::atStateItem() const {
    if (!at(TokenKind::Word)) return false;
    const Token next = following();
    for (const std::string_view word : {"entry", "run", "handle", "exit", "transitions", "preconditions"})
        if (text() == word) return next.kind == TokenKind::OpenBrace;
    return (text() == "transition" || text() == "precondition") && next.kind == TokenKind::Word;
}

ast::State Parser::state() {
    ast::State result;
    result.initial = acceptWord("initial");
    result.final = !result.initial && acceptWord("final");
    expectWord("state");
    result.name = name("the name of a state");
    recoverAtBrace();
    result.end = inBraces(&Parser::stateEndsHere, [&] { stateItem(result); });
    return result;
}

void Parser::stateItem(ast::State& state) {
    if (atTransitions()) {
        transitions(state.transitions);
    } else if (atWord("precondition") || atWord("preconditions")) {
        preconditions(state);
    } else if (atDeclaration()) {
        state.locals.push_back(declaration());
        endStatement();
    } else {
        stateProgram(state);
    }
}

void Parser::stateProgram(ast::State& state) {
    std::unique_ptr<ast::Block>* const programs[] = {&state.entry, &state.run, &state.handle, &state.exit};
    static constexpr const char* words[] = {"entry", "run", "handle", "exit"};
    for (int i = 0; i < 4; ++i) {
        const ast::Place at = place();
        if (!acceptWord(words[i])) continue;
        auto program = std::make_unique<ast::Block>();
        loops_ = 0;
        *program = body();
        if (*programs[i]) {
            report(at, "OPS013",
                   std::string("found '") + words[i] + "' a second time in the state '" + state.name.text + "'")
                .note(location((*programs[i])->at), "given here");
        } else {
            *programs[i] = std::move(program);
        }
        return;
    }
    Diagnostic* error =
        failHere("'entry', 'run', 'handle', 'exit', a transition, a precondition, a declaration or '}'");
    suggest(error, token(), text(),
            {"entry", "run", "handle", "exit", "transition", "transitions", "precondition", "preconditions", "var",
             "const", "alias"});
}

/** `precondition a`, `preconditions { a; if b then select S }`. After the first form, the next item of the state may
    follow. */
void Parser::preconditions(ast::State& state) {
    const bool list = atWord("preconditions");
    advance();
    if (list) {
        inBraces(&Parser::stateEndsHere, [&] {
            precondition(state);
            endStatement();
        });
    } else {
        precondition(state);
        if (!atStateItem()) endStatement();
    }
}

/** `a`, `if a then`: the state is entered only if a is true. `if a then select S`: if a is true, S is entered
    instead. */
void Parser::precondition(ast::State& state) {
    ast::Transition detour;
    detour.at = place();
    const bool conditional = acceptWord("if");
    if (conditional || !atSelection()) detour.condition = expression();
    if (conditional) acceptWord("then");
    if (detour.condition && !(conditional && atSelection())) {
        state.preconditions.push_back(std::move(detour.condition));
        return;
    }
    detour.selection = selection();
    if (conditional && acceptContinuation("else"))
        detour.otherwise = std::make_unique<ast::Selection>(selection());
    else if (!detour.selection.program && detour.selection.states.size() == 1 &&
             detour.selection.states[0].text == state.name.text)
        warn(detour.selection.at, "OPS014",
             "this changes nothing: state '" + state.name.text +
                 "' is entered anyway; 'precondition c' says that it is entered only if c is true");
    state.detours.push_back(std::move(detour));
}

}  // namespace RTT::scripting::detail
