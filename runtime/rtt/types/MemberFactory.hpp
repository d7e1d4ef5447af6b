// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MEMBER_FACTORY_HPP
#define ORO_MEMBER_FACTORY_HPP

#include <rtt/base/DataSourceBase.hpp>

namespace RTT {
namespace internal {
class Reference;
}
namespace types {

/** Gives access to the members of values of one type. Every function has a default that knows no members. */
class RTT_API MemberFactory {
public:
    virtual ~MemberFactory();

    /** Sets the number of elements; false if the type has a fixed size. */
    virtual bool resize(base::DataSourceBase::shared_ptr value, int size) const;
    virtual std::vector<std::string> getMemberNames() const;
    /** What is known of a member beside its type: "comment [unit] (range)"; empty if that is nothing. */
    virtual std::string describeMember(const std::string& name) const;
    /** A source that refers to the member, or null. */
    virtual base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                                       const std::string& name) const;
    /** The same by a source that gives the name (string) or the index (int). */
    virtual base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                                       base::DataSourceBase::shared_ptr id) const;
    /** Lets `reference` refer to the member; false if there is no such member of the reference's type. */
    virtual bool getMember(internal::Reference* reference, base::DataSourceBase::shared_ptr item,
                           const std::string& name) const;
};

}  // namespace types
}  // namespace RTT

#endif
