// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ELEMENT_DATA_SOURCE_HPP
#define ORO_ELEMENT_DATA_SOURCE_HPP

#include <rtt/types/SequenceOps.hpp>
#include "DataSource.hpp"

namespace RTT {
namespace internal {

/** The part of ElementDataSource that does not depend on the element's type: where the element is now. */
class RTT_API ElementPlace {
public:
    ElementPlace(base::DataSourceBase* parent, base::DataSourceBase* index, const types::SequenceOps* ops);

    /** Evaluates parent and index. */
    bool evaluate() const;
    /** False, too, if the index is beyond the end. */
    bool load(void* element) const;
    bool store(const void* element) const;
    bool isAssignable() const;
    /** Null if there is no such element, or elements have no address. */
    void* address(bool forWriting) const;

    base::DataSourceBase::shared_ptr parent;
    base::DataSourceBase::shared_ptr index;  ///< of type int or unsigned int
    const types::SequenceOps* ops;

private:
    std::size_t position() const;
};

/**
 * An element of a container, found anew at each access, so that index and container may change.
 * Beyond the end a default value is read, and what is written is lost, as it is where elements cannot be changed.
 */
template <typename E>
class ElementDataSource : public AssignableDataSource<E> {
public:
    [[gnu::cold]] ElementDataSource(base::DataSourceBase* parent, base::DataSourceBase* index,
                                    const types::SequenceOps* ops)
        : place_(parent, index, ops), spare_(types::ValueTraits<E>::make()) {}

    bool evaluate() const override { return place_.evaluate(); }
    typename DataSource<E>::result_t get() const override {
        place_.evaluate();
        return types::copyOf<E>(element(false));
    }
    typename DataSource<E>::result_t value() const override { return types::copyOf<E>(element(false)); }
    typename DataSource<E>::const_reference_t rvalue() const override { return element(false); }
    void set(typename AssignableDataSource<E>::param_t value) override {
        place_.evaluate();
        // Kept for updated(), which may follow and stores it again where elements have no address.
        if (!place_.ops->at) types::assignValue(spare_, value);
        place_.store(&value);
    }
    typename AssignableDataSource<E>::reference_t set() override {
        place_.evaluate();
        return element(true);
    }
    void updated() override {
        if (!place_.ops->at)
            place_.store(&spare_);
        else
            place_.parent->updated();
    }
    bool isAssignable() const override { return std::is_copy_assignable<E>::value && place_.isAssignable(); }
    base::DataSourceBase::shared_ptr getParent() override { return place_.parent; }

    [[gnu::cold]] ElementDataSource<E>* clone() const override {
        return new ElementDataSource<E>(place_.parent.get(), place_.index.get(), place_.ops);
    }
    [[gnu::cold]] ElementDataSource<E>* copy(
        std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const override {
        return new ElementDataSource<E>(place_.parent->copy(cloned), place_.index->copy(cloned), place_.ops);
    }

private:
    /** The element, or a copy of one that has no address. */
    [[gnu::noinline]] E& element(bool forWriting) const {
        if (void* at = place_.address(forWriting)) return *static_cast<E*>(at);
        if (!place_.load(&spare_)) types::resetValue(spare_);
        return spare_;
    }

    ElementPlace place_;
    mutable E spare_;
};

}  // namespace internal
}  // namespace RTT

#endif
