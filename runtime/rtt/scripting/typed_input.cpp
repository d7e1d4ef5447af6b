// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/typed_input.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/scripting/detail/syntax/lexer.hpp>
#include <rtt/scripting/detail/service/typed_text.hpp>

#include <diag/print.hpp>

#include <algorithm>
#include <utility>

namespace RTT::scripting {

namespace diag = oroforge::diag;

struct TypedInput::State {
    State(TaskContext& component, std::string name)
        : component(component),
          gate(component.engine()->gate()),
          session(std::make_shared<detail::SourceFile>(std::move(name), "", nullptr)) {}

    TaskContext& component;
    const boost::intrusive_ptr<const internal::EngineGate> gate;
    const std::shared_ptr<detail::SourceFile> session;
    std::vector<detail::SourceFilePtr> kept;  ///< texts with aliases, which are compiled at each use
    std::string typed;                        ///< all texts at their lines, for messages
    unsigned lines = 0;                       ///< number of lines
};

TypedInput::TypedInput(TaskContext& component, std::string name) : state_(new State(component, std::move(name))) {}
TypedInput::~TypedInput() = default;

bool TypedInput::alive() const { return !state_->gate->closed(); }

bool TypedInput::execute(const std::string& text, unsigned line, std::ostream& messages, Answer& answer) {
    State& state = *state_;
    const diag::FileName& name = state.session->name;
    if (line > state.lines) state.typed.append(line - state.lines, '\n');
    state.typed += text;
    state.lines = std::max(state.lines, line) + static_cast<unsigned>(std::count(text.begin(), text.end(), '\n'));
    // Preceded by empty lines, so that places count all typed lines.
    const auto file = std::make_shared<detail::SourceFile>(name, std::string(line - 1, '\n') + text, state.session);
    detail::TypedText typed(state.component, file, state.session->scope);
    const bool good = typed.run(answer, messages);
    if (typed.hasAliases()) state.kept.push_back(file);
    if (typed.messages().empty()) return good;
    diag::SourceCache sources;
    sources.add(name, state.typed.substr(1));
    diag::print(messages, typed.messages(), sources);
    return good;
}

bool TypedInput::goesOn(const std::string& text) {
    using detail::TokenKind;
    detail::Lexer lexer(text);
    int open = 0;
    for (;;) {
        switch (lexer.next().kind) {
            case TokenKind::OpenParen:
            case TokenKind::OpenBracket:
            case TokenKind::OpenBrace: ++open; break;
            case TokenKind::CloseParen:
            case TokenKind::CloseBracket:
            case TokenKind::CloseBrace: --open; break;
            case TokenKind::OpenComment: return true;
            case TokenKind::End: return open > 0;
            default: break;
        }
    }
}

}  // namespace RTT::scripting
