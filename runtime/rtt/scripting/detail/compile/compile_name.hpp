// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Resolves a dotted name: a variable of the script, a value in a component or service, or a call without parentheses.
#ifndef ORO_SCRIPTING_DETAIL_COMPILE_NAME_HPP
#define ORO_SCRIPTING_DETAIL_COMPILE_NAME_HPP

#include <rtt/Service.hpp>
#include <rtt/scripting/detail/compile/unit_part.hpp>

namespace RTT::scripting::detail {

class NameCompiler : private UnitPart {
public:
    explicit NameCompiler(UnitCompiler& unit);

    /** A component or service on the way along a path. */
    struct Node {
        TaskContext* component;  ///< null if it is a service
        Service::shared_ptr service;
        std::size_t used;  ///< parts of the path that lead here
    };
    typedef std::vector<Node> Nodes;

    Operand compile(const ast::Name& name, ast::Place at);
    /** The component itself, then the targets of the parts of the path, at most `most`. */
    Nodes walk(const Parts& parts, std::size_t most) const;
    /** The declaration of the name (in an alias: before the alias); null if there is none. */
    const Scope::Entry* declared(const std::string& name) const;
    /** Where names are looked up: the scope of an alias while that is compiled. */
    const Scope& scope() const { return *scope_; }
    /** Finds the value that the name has without a call of what its last part names. */
    bool value(const Nodes& nodes, const Parts& parts, bool mayCall, Operand& found);

private:
    bool variable(const Parts& parts, Operand& found);
    bool valueIn(const Nodes& nodes, const Parts& parts, Operand& found);
    bool resultOf(const Nodes& nodes, const Parts& parts, Operand& found);
    Operand members(Operand of, const Parts& parts, std::size_t from);
    Operand valueOfAlias(const Scope::Entry& alias, const ast::Identifier& name);
    bool isElsewhere(const Parts& parts, const Operand& variable) const;
    bool leadsToCome(const Parts& parts) const;

    const Scope* scope_;
    unsigned aliases_ = 0;     // number of aliases being resolved
    unsigned alias_uses_ = 0;  // number of aliases used in the outermost one
};

}  // namespace RTT::scripting::detail

#endif
