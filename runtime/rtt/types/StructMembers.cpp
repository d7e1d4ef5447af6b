// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "StructMembers.hpp"

#include <rtt/Logger.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/base/ActionInterface.hpp>
#include <rtt/internal/DataSources.hpp>
#include "TypeOps.hpp"
#include "TypeThunkTable.hpp"
#include "Types.hpp"
#include <rtt/types/member_update.hpp>
#include <boost/core/demangle.hpp>
#include <istream>
#include <ostream>

namespace RTT::types {

using base::DataSourceBase;
using SourcePtr = DataSourceBase::shared_ptr;

namespace {

/** Finds a member of a read-only value by its offset at each evaluation of the value. */
const SequenceOps& byteOffsetOps() {
    static constexpr SequenceOps table = {
        [](const void*) { return ~std::size_t(0); },
        [](const void*) { return ~std::size_t(0); },
        nullptr,
        [](void* object, std::size_t offset) { return static_cast<void*>(static_cast<char*>(object) + offset); },
        nullptr,
        nullptr,
        nullptr,
    };
    return table;
}

/** The type of a member. For an array it is that of views on such arrays, unless a class such as std::array has its
    own. */
const TypeInfo* typeOf(const Member& member) {
    const TypeInfo* type = member.count ? Types()->getArrayType(member.type()) : Types()->getTypeById(member.type());
    return !type && member.whole ? Types()->getTypeById(member.whole()) : type;
}

std::string description(const Member& member) {
    std::string text = member.doc;
    const auto add = [&text](const std::string& more) { text += (text.empty() ? "" : " ") + more; };
    if (*member.unit) add("[" + std::string(member.unit) + "]");
    if (*member.range) add("(" + std::string(member.range) + ")");
    return text;
}

SourcePtr elementOf(const SourcePtr& item, std::size_t index, const TypeThunks& thunks, const SequenceOps& ops) {
    auto* const which = new internal::ConstantDataSource<unsigned int>(static_cast<unsigned int>(index));
    return thunks.element(item.get(), which, &ops);
}

SourcePtr partOf(void* value, const SourcePtr& item, const Member& member, const TypeThunks& thunks) {
    return value ? thunks.part(static_cast<char*>(value) + member.offset, member.count, item.get()) : nullptr;
}

}  // namespace

std::vector<std::string> StructMembers::getMemberNames() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i != count_; ++i) names.push_back(members_[i].name);
    return names;
}

const Member* StructMembers::find(const std::string& name) const {
    for (std::size_t i = 0; i != count_; ++i)
        if (name == members_[i].name) return &members_[i];
    for (std::size_t i = 0; i != count_; ++i)
        if (*members_[i].also && name == members_[i].also) return &members_[i];
    return nullptr;
}

std::string StructMembers::describeMember(const std::string& name) const {
    const Member* const member = find(name);
    return member ? description(*member) : std::string();
}

SourcePtr StructMembers::getMember(SourcePtr item, const std::string& name) const {
    const Member* const member = find(name);
    return member ? memberOf(item, *member) : nullptr;
}

SourcePtr StructMembers::getMember(SourcePtr item, SourcePtr id) const { return MemberFactory::getMember(item, id); }

SourcePtr StructMembers::memberOf(const SourcePtr& item, const Member& member) const {
    if (!item->getTypeId() || *item->getTypeId() != *ops_.id) return nullptr;
    const TypeInfo* type = typeOf(member);
    if (!type || !type->getThunks()) {
        log(Error) << "member " << member.name << " of type " << item->getTypeName()
                   << " is out of reach: its C++ type " << boost::core::demangle(member.type())
                   << (member.count ? " is not registered as an array element" : " is not registered") << endlog();
        return nullptr;
    }
    const TypeThunks& thunks = *type->getThunks();
    if (member.access) return thunks.element ? elementOf(item, 0, thunks, *member.access) : nullptr;
    if (item->isAssignable()) return partOf(item->getRawPointer(), item, member, thunks);
    if (thunks.element) return elementOf(item, member.offset, thunks, byteOffsetOps());
    // For an array, a read-only view on it.
    if (void* const value = const_cast<void*>(item->getRawConstPointer())) return partOf(value, item, member, thunks);
    const SourcePtr copy = copyOf(item);
    return copy ? partOf(const_cast<void*>(copy->getRawConstPointer()), copy, member, thunks) : nullptr;
}

/** A copy made at each evaluation, for a value that has no address before it is evaluated. */
SourcePtr StructMembers::copyOf(const SourcePtr& item) const {
    const SourcePtr copy = thunks_.value();
    return copy->isAssignable() ? thunks_.actionAlias(copy->updateAction(item.get()), copy.get()) : nullptr;
}

SourcePtr StructMembers::decomposeType(SourcePtr source) const {
    boost::intrusive_ptr<internal::ValueDataSource<PropertyBag>> result(new internal::ValueDataSource<PropertyBag>());
    PropertyBag& bag = result->set();
    bag.setType(source->getTypeName());
    for (std::size_t i = 0; i != count_; ++i) {
        // Unreachable members were reported; the others are kept.
        if (const SourcePtr member = memberOf(source, members_[i])) {
            const std::string text = description(members_[i]);
            bag.ownProperty(
                member->getTypeInfo()->buildProperty(members_[i].name, text.empty() ? "Part" : text, member));
        }
    }
    return result;
}

bool StructMembers::composeType(SourcePtr source, SourcePtr target) const {
    const auto* bag = static_cast<const PropertyBag*>(detail::valueOfType(source, typeid(PropertyBag)));
    if (!bag || !detail::storageOfType(target, *ops_.id)) return false;
    bool complete = true;
    for (std::size_t i = 0; i != count_; ++i) {
        const base::PropertyBase* item = bag->find(members_[i].name);
        if (!item && *members_[i].also) item = bag->find(members_[i].also);
        if (!item || detail::updateWithConversion(memberOf(target, members_[i]), item->getDataSource())) continue;
        log(Error) << "member " << members_[i].name << " of type " << target->getTypeName()
                   << " cannot take a value of type " << item->getType() << endlog();
        complete = false;
    }
    target->updated();
    return complete;
}

std::ostream& StructMembers::write(std::ostream& os, SourcePtr source) const {
    os << '{';
    for (std::size_t i = 0; i != count_; ++i) {
        os << (i ? ", " : "") << members_[i].name << " = ";
        const SourcePtr member = memberOf(source, members_[i]);
        if (member && member->evaluate())
            member->write(os);
        else
            os << "(unknown_t)";
    }
    return os << '}';
}

std::istream& StructMembers::read(std::istream& is, SourcePtr) const {
    is.setstate(std::ios::failbit);
    return is;
}

}  // namespace RTT::types
