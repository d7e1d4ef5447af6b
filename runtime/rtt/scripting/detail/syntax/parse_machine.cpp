// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_grammar.hpp>

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

ast::StateMachine MachineParser::parse() {
    ast::StateMachine result;
    tokens_.advance();
    result.type = tokens_.name("the name of a type of state machine");
    ahead_.setInMachine(true);
    tokens_.recoverAtBrace();
    result.end = grammar_.braces.contents(&Lookahead::machineEndsHere, [&] { machineItem(result); });
    ahead_.setInMachine(false);
    return result;
}

void MachineParser::machineItem(ast::StateMachine& machine) {
    if (tokens_.atWord("state") || tokens_.atWord("initial") || tokens_.atWord("final")) {
        machine.states.push_back(state());
    } else if (ahead_.atTransitions()) {
        if (!machine.states.empty())
            tokens_.report(tokens_.place(), "OPS012",
                           "found transitions of the whole machine behind a state, expected them before the first one");
        grammar_.transitions.parse(machine.transitions);
    } else if (ahead_.atDeclaration() || tokens_.atWord("param")) {
        machine.locals.push_back(ahead_.atDeclaration() ? grammar_.declarations.declaration()
                                                        : grammar_.declarations.parameters());
        tokens_.endStatement();
    } else if (tokens_.atWord("SubMachine")) {
        machine.subMachines.push_back(grammar_.definitions.instance());
        tokens_.endStatement();
    } else {
        Diagnostic* error = tokens_.failHere("a declaration, a transition, a state or '}'");
        suggest(
            error, tokens_.token(), tokens_.text(),
            {"state", "initial", "final", "transition", "transitions", "param", "var", "const", "alias", "SubMachine"});
    }
}

ast::State MachineParser::state() {
    ast::State result;
    result.initial = tokens_.acceptWord("initial");
    result.final = !result.initial && tokens_.acceptWord("final");
    tokens_.expectWord("state");
    result.name = tokens_.name("the name of a state");
    tokens_.recoverAtBrace();
    result.end = grammar_.braces.contents(&Lookahead::stateEndsHere, [&] { stateItem(result); });
    return result;
}

void MachineParser::stateItem(ast::State& state) {
    if (ahead_.atTransitions()) {
        grammar_.transitions.parse(state.transitions);
    } else if (tokens_.atWord("precondition") || tokens_.atWord("preconditions")) {
        preconditions(state);
    } else if (ahead_.atDeclaration()) {
        state.locals.push_back(grammar_.declarations.declaration());
        tokens_.endStatement();
    } else {
        stateProgram(state);
    }
}

void MachineParser::stateProgram(ast::State& state) {
    std::unique_ptr<ast::Block>* const programs[] = {&state.entry, &state.run, &state.handle, &state.exit};
    static constexpr const char* words[] = {"entry", "run", "handle", "exit"};
    for (int i = 0; i < 4; ++i) {
        const ast::Place at = tokens_.place();
        if (!tokens_.acceptWord(words[i])) continue;
        auto program = std::make_unique<ast::Block>();
        *program = grammar_.statements.body();
        if (*programs[i]) {
            tokens_
                .report(at, "OPS013",
                        std::string("found '") + words[i] + "' a second time in the state '" + state.name.text + "'")
                .note(tokens_.location((*programs[i])->at), "given here");
        } else {
            *programs[i] = std::move(program);
        }
        return;
    }
    Diagnostic* error =
        tokens_.failHere("'entry', 'run', 'handle', 'exit', a transition, a precondition, a declaration or '}'");
    suggest(error, tokens_.token(), tokens_.text(),
            {"entry", "run", "handle", "exit", "transition", "transitions", "precondition", "preconditions", "var",
             "const", "alias"});
}

/** `precondition a`, `preconditions { a; if b then select S }`. After the first form, the next item of the state may
    follow. */
void MachineParser::preconditions(ast::State& state) {
    const bool list = tokens_.atWord("preconditions");
    tokens_.advance();
    if (list) {
        grammar_.braces.contents(&Lookahead::stateEndsHere, [&] {
            precondition(state);
            tokens_.endStatement();
        });
    } else {
        precondition(state);
        if (!ahead_.atStateItem()) tokens_.endStatement();
    }
}

/** `a`, `if a then`: the state is entered only if a is true. `if a then select S`: if a is true, S is entered
    instead. */
void MachineParser::precondition(ast::State& state) {
    ast::Transition detour;
    detour.at = tokens_.place();
    const bool conditional = tokens_.acceptWord("if");
    if (conditional || !ahead_.atSelection()) detour.condition = grammar_.expressions.parse();
    if (conditional) tokens_.acceptWord("then");
    if (detour.condition && !(conditional && ahead_.atSelection())) {
        state.preconditions.push_back(std::move(detour.condition));
        return;
    }
    detour.selection = grammar_.transitions.selection();
    if (conditional && tokens_.acceptContinuation("else"))
        detour.otherwise = std::make_unique<ast::Selection>(grammar_.transitions.selection());
    else if (!detour.selection.program && detour.selection.states.size() == 1 &&
             detour.selection.states[0].text == state.name.text)
        tokens_.warn(detour.selection.at, "OPS014",
                     "this changes nothing: state '" + state.name.text +
                         "' is entered anyway; 'precondition c' says that it is entered only if c is true");
    state.detours.push_back(std::move(detour));
}

}  // namespace RTT::scripting::detail
