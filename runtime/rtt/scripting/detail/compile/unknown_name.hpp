// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Explains names that nothing has.
#ifndef ORO_SCRIPTING_DETAIL_UNKNOWN_NAME_HPP
#define ORO_SCRIPTING_DETAIL_UNKNOWN_NAME_HPP

#include <rtt/scripting/detail/compile/compile_name.hpp>

namespace RTT::scripting::detail {

class UnknownName : private UnitPart {
public:
    explicit UnknownName(UnitCompiler& unit) : UnitPart(unit) {}

    /** Reports that the name leads no further than to the last node, unless it may exist later. */
    [[noreturn]] void fail(const NameCompiler::Nodes& nodes, const ast::Name& name);
    /** Notes the argument that must be a text, whose name may lack the quotes; null if there is none. */
    void expectText(const ast::Name* argument) { text_ = argument; }

private:
    typedef NameCompiler::Node Node;

    /** True if the name may be added before the script reaches this place. */
    bool isToCome(const Node& last, const ast::Name& name) const;
    void doubt(const Node& last, const ast::Name& name) const;
    void checkCallOfValue(const NameCompiler::Nodes& nodes, const ast::Name& name);
    std::string missing(const Node& last, const ast::Name& name) const;
    std::vector<std::string> knownNames(const Node& last, bool isLast, bool called) const;
    unsigned lineOfLaterFunction(const ast::Identifier& name) const;

    const ast::Name* text_ = nullptr;
};

}  // namespace RTT::scripting::detail

#endif
