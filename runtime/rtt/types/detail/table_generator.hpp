// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TABLE_GENERATOR_HPP
#define ORO_TABLE_GENERATOR_HPP

#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoGenerator.hpp>

namespace RTT {
namespace types {
namespace detail {

/** The common base of generators with constant tables: of operations on values, and of thunks, which make the data
    sources and ports of the type. */
class TableGenerator : public TypeInfoGenerator {
public:
    TableGenerator(const char* name, const char* doc, const TypeOps& ops, const TypeThunks& thunks);

    const std::string& getTypeName() const override { return name_; }
    TypeInfo* getTypeInfoObject() const override;
    bool installTypeInfoObject(TypeInfo* info) override;

protected:
    const TypeOps& ops() const { return *ops_; }
    const TypeThunks& thunks() const { return *thunks_; }

private:
    std::string name_;
    const char* doc_;
    const TypeOps* ops_;
    const TypeThunks* thunks_;
};

}  // namespace detail
}  // namespace types
}  // namespace RTT

#endif
