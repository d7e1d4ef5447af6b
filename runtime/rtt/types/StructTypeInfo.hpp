// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_STRUCT_TYPE_INFO_HPP
#define ORO_STRUCT_TYPE_INFO_HPP

#include "MemberDiscovery.hpp"
#include "StructMembers.hpp"
#include "TemplateTypeInfo.hpp"

namespace RTT {
namespace types {

/**
 * Generator for a struct whose members a boost::serialization function names:
 * `ar & make_nvp("name", object.member)` in serialize(ar, object, version), as a member or a free function.
 * The text form is that of operator<< if `has_ostream`, else "{name = value, …}".
 */
template <typename T, bool has_ostream = false>
class StructTypeInfo : public TemplateTypeInfo<T, has_ostream>, public MemberFactory, public HasShape {
public:
    explicit StructTypeInfo(std::string name)
        : TemplateTypeInfo<T, has_ostream>(std::move(name)),
          found_(detail::discoverMembers<T>()),
          members_(new StructMembers(found_->table(), found_->size(), typeOps<T>(), typeThunks<T>())) {}

    bool installTypeInfoObject(TypeInfo* info) override {
        TemplateTypeInfo<T, has_ostream>::installTypeInfoObject(info);
        info->setMemberFactory(boost::dynamic_pointer_cast<StructTypeInfo>(this->getSharedPtr()));
        if (!has_ostream) info->setStreamFactory(members_);
        return false;
    }

    Shape shape() const override {
        if (found_->isComplete()) return members_->shape();
        return Shape::none("its serialization function has values without a name or without a place in the object");
    }
    std::vector<std::string> getMemberNames() const override { return members_->getMemberNames(); }
    using MemberFactory::getMember;
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               const std::string& name) const override {
        return members_->getMember(item, name);
    }
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               base::DataSourceBase::shared_ptr id) const override {
        return members_->getMember(item, id);
    }
    /** Uses decomposeTypeImpl() if a derived generator overrides it; otherwise live members. */
    base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const override {
        const auto own = TemplateTypeInfo<T, has_ostream>::decomposeType(source);
        return own ? own : members_->decomposeType(source);
    }

private:
    // The table outlives this generator, because the type may keep only members_.
    const detail::DiscoveredMembers* found_;
    boost::shared_ptr<StructMembers> members_;
};

}  // namespace types
}  // namespace RTT

#endif
