// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Executes a text that was typed at a console and returns its result.
#ifndef ORO_SCRIPTING_DETAIL_TYPED_TEXT_HPP
#define ORO_SCRIPTING_DETAIL_TYPED_TEXT_HPP

#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/scripting/detail/service/script_reader.hpp>
#include <rtt/scripting/typed_input.hpp>

#include <iosfwd>
#include <memory>
#include <string>

namespace RTT::scripting::detail {

class TypedText final : private ScriptReader {
public:
    /** Declarations go to `scope`, which must outlive this. */
    TypedText(TaskContext& component, std::shared_ptr<SourceFile> file, Scope& scope);
    ~TypedText() override;

    /** False after an error, which is in messages() or, from the service "scripting", in `out`. */
    bool run(TypedInput::Answer& answer, std::ostream& out);
    const oroforge::diag::Sink& messages() const { return sink_; }
    /** True if the scope needs the tree of the file. */
    bool hasAliases() const { return has_aliases_; }

private:
    typedef base::DataSourceBase::shared_ptr Source;
    using ScriptReader::take;
    bool take(const ast::Item& item, const ast::StatementPtr& statement) override;
    bool take(const ast::Item& item, const ast::Function&) override { return define(item); }
    bool take(const ast::Item& item, const ast::Program&) override { return define(item); }
    bool take(const ast::Item& item, const ast::StateMachine&) override { return define(item); }
    bool take(const ast::Item& item, const ast::Instance&) override { return define(item); }
    bool evaluate(const ast::Expression& expression);
    bool declare(const ast::Statement& statement, const ast::Declaration& declaration);
    bool isFree(const ast::Identifier& name);
    void publish(const ast::Declarator& declarator);
    bool define(const ast::Item& item);
    void answer(const Source& value);

    const boost::intrusive_ptr<const internal::EngineGate>
        gate_;  // the gate of the component, which a statement may destroy
    Scope& scope_;
    std::ostream* out_ = nullptr;
    TypedInput::Answer answer_;
    bool has_aliases_ = false;
};

}  // namespace RTT::scripting::detail

#endif
