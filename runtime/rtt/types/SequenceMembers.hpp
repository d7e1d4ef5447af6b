// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SEQUENCE_MEMBERS_HPP
#define ORO_SEQUENCE_MEMBERS_HPP

#include "CompositionFactory.hpp"
#include "MemberFactory.hpp"
#include "SequenceOps.hpp"
#include "Shape.hpp"
#include "StreamFactory.hpp"
#include <functional>

namespace RTT {
class PropertyBag;
namespace base {
class PropertyBase;
}
namespace types {

struct TypeThunks;
class TypeConstructor;

/** Members, property bags and text of containers whose elements are reached through SequenceOps. */
class RTT_API SequenceMembers : public MemberFactory, public CompositionFactory, public StreamFactory, public HasShape {
public:
    explicit SequenceMembers(const SequenceOps& ops) : ops_(ops) {}

    Shape shape() const override { return Shape::ofSequence(ops_); }
    bool resize(base::DataSourceBase::shared_ptr value, int size) const override;
    std::vector<std::string> getMemberNames() const override;
    using MemberFactory::getMember;
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               const std::string& name) const override;
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               base::DataSourceBase::shared_ptr id) const override;

    base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const override;
    bool composeType(base::DataSourceBase::shared_ptr source, base::DataSourceBase::shared_ptr target) const override;

    std::ostream& write(std::ostream& os, base::DataSourceBase::shared_ptr source) const override;
    std::istream& read(std::istream& is, base::DataSourceBase::shared_ptr target) const override;
    bool isStreamable() const override { return false; }

private:
    /** Logs an error and returns null if the element type is not registered. */
    const TypeThunks* elementThunks() const;
    base::DataSourceBase::shared_ptr elementAt(const base::DataSourceBase::shared_ptr& item, std::size_t index) const;
    std::size_t sizeOf(const base::DataSourceBase::shared_ptr& item) const;
    /** False if the element type is not registered. */
    bool forEach(const base::DataSourceBase::shared_ptr& source,
                 const std::function<void(const base::DataSourceBase::shared_ptr&)>& action) const;
    bool insertAll(const PropertyBag& bag, void* container) const;
    bool reportElement(const base::DataSourceBase::shared_ptr& element, const base::PropertyBase& item) const;

    const SequenceOps& ops_;
};

namespace detail {
/** T(element, element…), T(int size) and T(int size, element), tried in this order. */
RTT_API TypeConstructor* newSequenceConstructor(const SequenceOps& sequence, const TypeThunks& thunks);

}  // namespace detail

}  // namespace types
}  // namespace RTT

#endif
