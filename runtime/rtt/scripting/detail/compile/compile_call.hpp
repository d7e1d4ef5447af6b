// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Compiles calls of operations, constructors and functions of scripts.
#ifndef ORO_SCRIPTING_DETAIL_COMPILE_CALL_HPP
#define ORO_SCRIPTING_DETAIL_COMPILE_CALL_HPP

#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/scripting/detail/compile/compile_name.hpp>

#include <functional>

namespace RTT::scripting::detail {

/** What a name calls. */
struct Callable {
    OperationInterfacePart* part = nullptr;
    Service* of = nullptr;  ///< the owner of the operation; null if it is global
    std::shared_ptr<const FunctionDefinition> function;
};

class CallCompiler : private UnitPart {
public:
    explicit CallCompiler(UnitCompiler& unit) : UnitPart(unit) {}

    /** The operation or function that the first `count` parts name. To be sent, a function must be an operation. */
    Callable callable(const Parts& parts, std::size_t count, const NameCompiler::Nodes& nodes, bool toSend) const;
    /** Compiles what the name calls, also with `.send` and the like behind it; false if it calls nothing. */
    bool call(const ast::Name& name, const NameCompiler::Nodes& nodes, ast::Place at, Operand& result);
    Operand call(const Callable& called, const ast::Name& name, ast::Place at);
    bool construct(const ast::Name& name, ast::Place at, Operand& result);

    /** True for the index of an argument that the call assigns to. */
    typedef std::function<bool(std::size_t)> IsOutput;
    std::vector<Operand> values(const ast::Expressions& expressions, const IsOutput& isOutput,
                                const internal::OperationSignature* signature = nullptr);
    /** The arguments, with numbers converted to the types of the operation. */
    OperationInterfacePart::Args arguments(const ast::Name& name, const OperationInterfacePart& part);
    /** What `make` makes for a call of `name`; reports errors in its arguments. */
    Source made(const ast::Name& name, ast::Place at, const OperationInterfacePart& part,
                const std::function<Source()>& make);

private:
    Callable found(const Parts& parts, std::size_t count, const NameCompiler::Nodes& nodes, bool toSend) const;
    Operand callOperation(const Callable& called, const ast::Name& name, ast::Place at);
    Operand callFunction(const std::shared_ptr<const FunctionDefinition>& function, const ast::Name& name,
                         ast::Place at);
    [[noreturn]] void failRecursive(const std::string& function, ast::Place at);
    Source argument(const ast::Name& name, const internal::OperationSignature& signature, std::size_t index,
                    const std::vector<Operand>& values);
};

}  // namespace RTT::scripting::detail

#endif
