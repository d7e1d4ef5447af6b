// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PLACED_DATA_SOURCE_HPP
#define ORO_PLACED_DATA_SOURCE_HPP

#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/values/value_place.hpp>
#include <memory>

namespace RTT {
namespace internal {

/** A value of type T that another source holds. The place says where it is. Only code that must know T is here, because
    every type of a typekit has its own copy of it. */
template <typename T>
class PlacedDataSource : public AssignableDataSource<T> {
public:
    typedef boost::intrusive_ptr<PlacedDataSource<T>> shared_ptr;
    typedef typename AssignableDataSource<T>::reference_t reference_t;
    typedef typename DataSource<T>::value_t value_t;

    /** Takes ownership of the place. */
    [[gnu::cold]] explicit PlacedDataSource(ValuePlace* place) : place_(place) {
        if (place->isFixed()) this->addressIsFixed();
    }

    bool evaluate() const override { return place_->evaluate(); }
    typename DataSource<T>::result_t get() const override { return types::copyOf<T>(at(place_->get())); }
    typename DataSource<T>::result_t value() const override { return types::copyOf<T>(at(place_->value())); }
    typename DataSource<T>::const_reference_t rvalue() const override { return at(place_->value()); }
    void set(typename AssignableDataSource<T>::param_t value) override { place_->assign(std::addressof(value)); }
    reference_t set() override { return at(place_->forChange()); }
    void updated() override { place_->updated(); }
    bool isAssignable() const override { return std::is_copy_assignable<T>::value && place_->isAssignable(); }
    void* getRawPointer() override { return place_->raw(); }
    void reset() override { place_->reset(); }
    base::DataSourceBase::shared_ptr getParent() override { return place_->isPart() ? place_->parent.get() : this; }

    [[gnu::cold]] PlacedDataSource<T>* clone() const override { return new PlacedDataSource<T>(place_->clone()); }
    [[gnu::cold]] PlacedDataSource<T>* copy(
        std::map<const base::DataSourceBase*, base::DataSourceBase*>& cloned) const override {
        if (auto* known = this->knownCopy(cloned)) return static_cast<PlacedDataSource<T>*>(known);
        ValuePlace* const place = place_->copy(cloned);
        auto* const made = place ? new PlacedDataSource<T>(place) : const_cast<PlacedDataSource<T>*>(this);
        this->noteCopy(cloned, made);
        return made;
    }

private:
    static value_t& at(void* place) { return *static_cast<value_t*>(place); }

    const std::unique_ptr<ValuePlace> place_;
};

}  // namespace internal
}  // namespace RTT

#endif
