// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_UNIT_PART_HPP
#define ORO_SCRIPTING_DETAIL_UNIT_PART_HPP

#include <rtt/scripting/detail/compile/operand.hpp>
#include <rtt/scripting/detail/compile/reporter.hpp>

namespace RTT::scripting::detail {

struct UnitCompiler;
class ValueCompiler;

/** A part of a UnitCompiler, with what most parts use. */
class UnitPart {
public:
    UnitPart(const UnitPart&) = delete;
    UnitPart& operator=(const UnitPart&) = delete;

protected:
    typedef base::DataSourceBase::shared_ptr Source;
    typedef std::vector<ast::Identifier> Parts;

    explicit UnitPart(UnitCompiler& unit);
    ~UnitPart() = default;

    UnitCompiler& unit_;
    const CompileContext& where_;
    Code& code_;
    Reporter& reporter_;
    ValueCompiler& values_;
};

}  // namespace RTT::scripting::detail

#endif
