// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_STRUCT_MEMBERS_HPP
#define ORO_STRUCT_MEMBERS_HPP

#include "CompositionFactory.hpp"
#include "MemberFactory.hpp"
#include "Shape.hpp"
#include "StreamFactory.hpp"
#include "StructTable.hpp"

namespace RTT {
namespace types {

/**
 * Members, property bags and the text form "{a = 1, b = 2}" of a struct described by a table of its fields.
 * Members are live references into the value; of a value that cannot be changed they are read-only.
 */
class RTT_API StructMembers : public MemberFactory, public CompositionFactory, public StreamFactory, public HasShape {
public:
    /** The table and what it points to must live as long as this. */
    StructMembers(const Member* members, std::size_t count, const TypeOps& ops, const TypeThunks& thunks)
        : members_(members), count_(count), ops_(ops), thunks_(thunks) {}

    Shape shape() const override { return Shape::ofStruct(members_, count_); }
    std::vector<std::string> getMemberNames() const override;
    std::string describeMember(const std::string& name) const override;
    using MemberFactory::getMember;
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               const std::string& name) const override;
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               base::DataSourceBase::shared_ptr id) const override;

    base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const override;
    /** Members that the bag lacks keep their values; other items of the bag are ignored. */
    bool composeType(base::DataSourceBase::shared_ptr source, base::DataSourceBase::shared_ptr target) const override;

    std::ostream& write(std::ostream& os, base::DataSourceBase::shared_ptr source) const override;
    std::istream& read(std::istream& is, base::DataSourceBase::shared_ptr target) const override;
    bool isStreamable() const override { return false; }

private:
    const Member* find(const std::string& name) const;
    base::DataSourceBase::shared_ptr memberOf(const base::DataSourceBase::shared_ptr& item, const Member& member) const;
    base::DataSourceBase::shared_ptr copyOf(const base::DataSourceBase::shared_ptr& item) const;

    const Member* members_;
    std::size_t count_;
    const TypeOps& ops_;
    const TypeThunks& thunks_;
};

}  // namespace types
}  // namespace RTT

#endif
