// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORELIB_DATASOURCES_HPP
#define ORO_CORELIB_DATASOURCES_HPP

#include "AssignCommand.hpp"
#include "DataSource.hpp"
#include "Reference.hpp"

namespace RTT {
namespace internal {

/** Selects the constructors that copy a value once; those without it take a value and move from it. */
struct CopyTag {};

/** A variable: holds its value itself. copy() returns the same variable, clone() a new one. After copiesAnew(), copy()
    returns a new one as well, which the local variables of programs need. */
template <typename T>
class ValueDataSource : public AssignableDataSource<T> {
public:
    typedef boost::intrusive_ptr<ValueDataSource<T>> shared_ptr;
    typedef typename AssignableDataSource<T>::param_t param_t;
    typedef typename AssignableDataSource<T>::reference_t reference_t;
    typedef typename DataSource<T>::const_reference_t const_reference_t;

    ValueDataSource(const_reference_t value, CopyTag) : mdata(types::copyOf<T>(value)) { this->addressIsFixed(); }
    ValueDataSource() : mdata(types::ValueTraits<T>::make()) { this->addressIsFixed(); }
    explicit ValueDataSource(T value) : mdata(types::movedFrom(value)) { this->addressIsFixed(); }
    /** A new variable. A function of its own, so that all callers share the code. */
    [[gnu::cold, gnu::noinline]] static ValueDataSource<T>* make(const T& value) {
        return new ValueDataSource<T>(value, CopyTag());
    }
    [[gnu::cold, gnu::noinline]] static ValueDataSource<T>* make() { return new ValueDataSource<T>(); }

    bool evaluate() const override { return true; }  // get() would make a useless copy
    typename DataSource<T>::result_t get() const override { return types::copyOf<T>(mdata); }
    typename DataSource<T>::result_t value() const override { return types::copyOf<T>(mdata); }
    const_reference_t rvalue() const override { return mdata; }
    void set(param_t value) override { types::assignValue(mdata, value); }
    reference_t set() override { return mdata; }

    [[gnu::cold]] ValueDataSource<T>* clone() const override {
        auto* const made = make(mdata);
        if (this->isCopiedAnew()) made->copiesAnew();
        return made;
    }
    [[gnu::cold]] ValueDataSource<T>* copy(CopyMap& cloned) const override {
        if (auto* known = this->knownCopy(cloned)) return static_cast<ValueDataSource<T>*>(known);
        auto* const made = this->isCopiedAnew() ? clone() : const_cast<ValueDataSource<T>*>(this);
        this->noteCopy(cloned, made);
        return made;
    }

protected:
    T mdata;
};

/** A variable whose copy in a copied expression is a new variable. BoundT is a ValueDataSource. */
template <typename BoundT>
class UnboundDataSource : public BoundT {
public:
    typedef typename BoundT::result_t T;

    UnboundDataSource() { this->copiesAnew(); }
    explicit UnboundDataSource(T value) : BoundT(types::movedFrom(value)) { this->copiesAnew(); }
};

/** A value fixed at construction. */
template <typename T>
class ConstantDataSource : public DataSource<T> {
public:
    typedef boost::intrusive_ptr<ConstantDataSource<T>> shared_ptr;

    ConstantDataSource(typename DataSource<T>::const_reference_t value, CopyTag)
        : mdata(types::copyOf<std::remove_const_t<T>>(value)) {}
    explicit ConstantDataSource(T value) : mdata(types::movedFrom(value)) {}
    [[gnu::cold, gnu::noinline]] static ConstantDataSource<T>* make(typename DataSource<T>::const_reference_t value) {
        return new ConstantDataSource<T>(value, CopyTag());
    }

    bool evaluate() const override { return true; }  // get() would make a useless copy
    typename DataSource<T>::result_t get() const override { return types::copyOf<T>(mdata); }
    typename DataSource<T>::result_t value() const override { return types::copyOf<T>(mdata); }
    typename DataSource<T>::const_reference_t rvalue() const override { return mdata; }

    [[gnu::cold]] ConstantDataSource<T>* clone() const override { return make(mdata); }
    [[gnu::cold]] ConstantDataSource<T>* copy(CopyMap&) const override {
        return const_cast<ConstantDataSource<T>*>(this);
    }

private:
    const std::remove_const_t<T> mdata;
};

/** Refers to a variable that the user owns and that must outlive this source. */
template <typename T>
class ReferenceDataSource : public AssignableDataSource<T>, public Reference {
public:
    typedef boost::intrusive_ptr<ReferenceDataSource<T>> shared_ptr;
    typedef typename AssignableDataSource<T>::param_t param_t;
    typedef typename AssignableDataSource<T>::reference_t reference_t;

    explicit ReferenceDataSource(reference_t ref) : mptr(std::addressof(ref)) { this->addressIsFixed(); }

    /** Call it before members of the value are handed out. */
    void setReference(void* ref) override { mptr = static_cast<typename DataSource<T>::value_t*>(ref); }
    bool setReference(base::DataSourceBase::shared_ptr source) override {
        void* const at = source && this->hasTypeOf(*source) ? source->getRawPointer() : nullptr;
        if (at) setReference(at);
        return at != nullptr;
    }
    bool evaluate() const override { return true; }  // get() would make a useless copy
    typename DataSource<T>::result_t get() const override { return types::copyOf<T>(*mptr); }
    typename DataSource<T>::result_t value() const override { return types::copyOf<T>(*mptr); }
    typename DataSource<T>::const_reference_t rvalue() const override { return *mptr; }
    void set(param_t value) override { types::assignValue(*mptr, value); }
    reference_t set() override { return *mptr; }

    [[gnu::cold]] ReferenceDataSource<T>* clone() const override { return new ReferenceDataSource<T>(*mptr); }
    [[gnu::cold]] ReferenceDataSource<T>* copy(CopyMap&) const override {
        return const_cast<ReferenceDataSource<T>*>(this);
    }

private:
    typename DataSource<T>::value_t* mptr;
};

/** Refers to a variable that cannot be changed through this source. */
template <typename T>
class ConstReferenceDataSource : public DataSource<T> {
public:
    typedef boost::intrusive_ptr<ConstReferenceDataSource<T>> shared_ptr;

    explicit ConstReferenceDataSource(typename DataSource<T>::const_reference_t ref) : mptr(std::addressof(ref)) {}

    bool evaluate() const override { return true; }  // get() would make a useless copy
    typename DataSource<T>::result_t get() const override { return types::copyOf<T>(*mptr); }
    typename DataSource<T>::result_t value() const override { return types::copyOf<T>(*mptr); }
    typename DataSource<T>::const_reference_t rvalue() const override { return *mptr; }
    [[gnu::cold]] ConstReferenceDataSource<T>* clone() const override { return new ConstReferenceDataSource<T>(*mptr); }
    [[gnu::cold]] ConstReferenceDataSource<T>* copy(CopyMap&) const override {
        return const_cast<ConstReferenceDataSource<T>*>(this);
    }

private:
    const typename DataSource<T>::value_t* mptr;
};

}  // namespace internal
}  // namespace RTT

#include <rtt/internal/values/referring_data_sources.hpp>

#endif
