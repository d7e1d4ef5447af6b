// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Compiles declarations, and functions with their arguments.
#ifndef ORO_SCRIPTING_DETAIL_COMPILE_DECLARATION_HPP
#define ORO_SCRIPTING_DETAIL_COMPILE_DECLARATION_HPP

#include <rtt/scripting/detail/compile/unit_part.hpp>

namespace RTT::scripting::detail {

class DeclarationCompiler : private UnitPart {
public:
    explicit DeclarationCompiler(UnitCompiler& unit) : UnitPart(unit) {}

    /** `again`: a loop may declare a variable of an earlier loop again. */
    void compile(const ast::Declaration& declaration, bool again = false);
    /** Declares arguments and result. */
    void functionHead(const ast::Function& function);

private:
    void constant(const ast::Declaration& declaration, const ast::Declarator& declarator);
    void alias(const ast::Declaration& declaration, const ast::Declarator& declarator);
    void variable(const ast::Declaration& declaration, const ast::Declarator& declarator, bool again);
    void handle(const ast::Declarator& declarator);
    void argument(const ast::Function::Argument& argument);
    void addEntry(const ast::Identifier& name, Scope::Entry entry);
    const types::TypeInfo& type(const ast::Identifier& name);
    Source newVariable(const ast::Identifier& type, const ast::Identifier& name, const ast::Expression* size);
    int sizeHint(const ast::Expression& size, const std::string& type, const ast::Identifier& name);
};

}  // namespace RTT::scripting::detail

#endif
