// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Data sources that refer to another source, or to memory that is known later; users include DataSources.hpp.
#ifndef ORO_CORELIB_REFERRING_DATASOURCES_HPP
#define ORO_CORELIB_REFERRING_DATASOURCES_HPP

#include <rtt/base/ActionInterface.hpp>
#include <rtt/internal/AssignCommand.hpp>
#include <rtt/internal/DataSource.hpp>
#include <memory>

namespace RTT {
namespace internal {

/** A read-only alias of another source. */
template <typename T>
class AliasDataSource : public DataSource<T> {
public:
    typedef boost::intrusive_ptr<AliasDataSource<T>> shared_ptr;

    explicit AliasDataSource(DataSource<T>* of) : alias_(of) {}

    bool evaluate() const override { return alias_->evaluate(); }
    typename DataSource<T>::result_t get() const override { return alias_->get(); }
    typename DataSource<T>::result_t value() const override { return alias_->value(); }
    typename DataSource<T>::const_reference_t rvalue() const override { return alias_->rvalue(); }
    [[gnu::cold]] AliasDataSource<T>* clone() const override { return new AliasDataSource<T>(alias_.get()); }
    [[gnu::cold]] AliasDataSource<T>* copy(CopyMap& cloned) const override {
        return new AliasDataSource<T>(alias_->copy(cloned));
    }

protected:
    typename DataSource<T>::shared_ptr alias_;
};

/** An alias of an assignable source. */
template <typename T>
class AliasAssignableDataSource : public AssignableDataSource<T> {
public:
    explicit AliasAssignableDataSource(AssignableDataSource<T>* of) : alias_(of) {}

    bool evaluate() const override { return alias_->evaluate(); }
    typename DataSource<T>::result_t get() const override { return alias_->get(); }
    typename DataSource<T>::result_t value() const override { return alias_->value(); }
    typename DataSource<T>::const_reference_t rvalue() const override { return alias_->rvalue(); }
    void set(typename AssignableDataSource<T>::param_t value) override { alias_->set(value); }
    typename AssignableDataSource<T>::reference_t set() override { return alias_->set(); }
    void updated() override { alias_->updated(); }
    [[gnu::cold]] AliasAssignableDataSource<T>* clone() const override {
        return new AliasAssignableDataSource<T>(alias_.get());
    }
    [[gnu::cold]] AliasAssignableDataSource<T>* copy(CopyMap& cloned) const override {
        return new AliasAssignableDataSource<T>(alias_->copy(cloned));
    }

protected:
    typename AssignableDataSource<T>::shared_ptr alias_;
};

/** A source that runs an action each time before it is read. Owns the action. */
template <typename T>
class ActionAliasDataSource : public DataSource<T> {
public:
    ActionAliasDataSource(base::ActionInterface* action, DataSource<T>* of) : action_(action), alias_(of) {}

    bool evaluate() const override {
        action_->readArguments();
        return action_->execute() && alias_->evaluate();
    }
    typename DataSource<T>::result_t get() const override {
        action_->readArguments();
        action_->execute();
        return alias_->get();
    }
    typename DataSource<T>::result_t value() const override { return alias_->value(); }
    typename DataSource<T>::const_reference_t rvalue() const override { return alias_->rvalue(); }
    void reset() override {
        alias_->reset();
        action_->reset();
    }

    [[gnu::cold]] ActionAliasDataSource<T>* clone() const override {
        return new ActionAliasDataSource<T>(action_->clone(), alias_.get());
    }
    [[gnu::cold]] ActionAliasDataSource<T>* copy(CopyMap& cloned) const override {
        return new ActionAliasDataSource<T>(action_->copy(cloned), alias_->copy(cloned));
    }

private:
    std::unique_ptr<base::ActionInterface> action_;
    typename DataSource<T>::shared_ptr alias_;
};

/** The same for an assignable source. */
template <typename T>
class ActionAliasAssignableDataSource : public AliasAssignableDataSource<T> {
public:
    ActionAliasAssignableDataSource(base::ActionInterface* action, AssignableDataSource<T>* of)
        : AliasAssignableDataSource<T>(of), action_(action) {}

    bool evaluate() const override {
        action_->readArguments();
        return action_->execute() && this->alias_->evaluate();
    }
    typename DataSource<T>::result_t get() const override {
        action_->readArguments();
        action_->execute();
        return this->alias_->get();
    }
    void reset() override {
        this->alias_->reset();
        action_->reset();
    }

    [[gnu::cold]] ActionAliasAssignableDataSource<T>* clone() const override {
        return new ActionAliasAssignableDataSource<T>(action_->clone(), this->alias_.get());
    }
    [[gnu::cold]] ActionAliasAssignableDataSource<T>* copy(CopyMap& cloned) const override {
        return new ActionAliasAssignableDataSource<T>(action_->copy(cloned), this->alias_->copy(cloned));
    }

private:
    std::unique_ptr<base::ActionInterface> action_;
};

/** A reference that is bound after construction. Using it earlier is a programming error. */
template <typename T>
class LateReferenceDataSource : public AssignableDataSource<T> {
public:
    typedef boost::intrusive_ptr<LateReferenceDataSource<T>> shared_ptr;
    typedef typename DataSource<T>::value_t value_t;

    explicit LateReferenceDataSource(value_t* ptr = nullptr) : mptr(ptr) {}

    void setPointer(value_t* ptr) { mptr = ptr; }
    bool evaluate() const override { return true; }  // get() would make a useless copy
    typename DataSource<T>::result_t get() const override { return *mptr; }
    typename DataSource<T>::result_t value() const override { return *mptr; }
    typename DataSource<T>::const_reference_t rvalue() const override { return *mptr; }
    void set(typename AssignableDataSource<T>::param_t value) override { *mptr = value; }
    typename AssignableDataSource<T>::reference_t set() override { return *mptr; }
    [[gnu::cold]] LateReferenceDataSource<T>* clone() const override { return new LateReferenceDataSource<T>(mptr); }
    [[gnu::cold]] LateReferenceDataSource<T>* copy(CopyMap&) const override {
        return const_cast<LateReferenceDataSource<T>*>(this);
    }

private:
    value_t* mptr;
};

/** Read-only form of LateReferenceDataSource. */
template <typename T>
class LateConstReferenceDataSource : public DataSource<T> {
public:
    typedef boost::intrusive_ptr<LateConstReferenceDataSource<T>> shared_ptr;
    typedef typename DataSource<T>::value_t value_t;

    explicit LateConstReferenceDataSource(const value_t* ptr = nullptr) : mptr(ptr) {}

    void setPointer(const value_t* ptr) { mptr = ptr; }
    bool evaluate() const override { return true; }  // get() would make a useless copy
    typename DataSource<T>::result_t get() const override { return *mptr; }
    typename DataSource<T>::result_t value() const override { return *mptr; }
    typename DataSource<T>::const_reference_t rvalue() const override { return *mptr; }
    [[gnu::cold]] LateConstReferenceDataSource<T>* clone() const override {
        return new LateConstReferenceDataSource<T>(mptr);
    }
    [[gnu::cold]] LateConstReferenceDataSource<T>* copy(CopyMap&) const override {
        return const_cast<LateConstReferenceDataSource<T>*>(this);
    }

private:
    const value_t* mptr;
};

/**
 * Owns the elements that a view type such as carray<E> refers to. T needs value_type, count(), and T(value_type*,
 * std::size_t).
 */
template <typename T>
class ArrayDataSource : public AssignableDataSource<T> {
public:
    typedef typename T::value_type element_t;

    explicit ArrayDataSource(std::size_t size = 0) { newArray(size); }
    ArrayDataSource(const T& other) {
        newArray(other.count());
        view_ = other;
    }

    /** Replaces the storage by `size` value-initialised elements. Allocates. */
    void newArray(std::size_t size) {
        storage_.reset(size ? new element_t[size]() : nullptr);
        view_.init(storage_.get(), size);
    }
    typename DataSource<T>::result_t get() const override { return view_; }
    typename DataSource<T>::result_t value() const override { return view_; }
    typename DataSource<T>::const_reference_t rvalue() const override { return view_; }
    void set(typename AssignableDataSource<T>::param_t value) override { view_ = value; }
    typename AssignableDataSource<T>::reference_t set() override { return view_; }
    [[gnu::cold]] ArrayDataSource<T>* clone() const override { return new ArrayDataSource<T>(view_); }
    [[gnu::cold]] ArrayDataSource<T>* copy(CopyMap& cloned) const override {
        if (auto* known = this->knownCopy(cloned)) return static_cast<ArrayDataSource<T>*>(known);
        auto* self = const_cast<ArrayDataSource<T>*>(this);
        this->noteCopy(cloned, self);
        return self;
    }

private:
    std::unique_ptr<element_t[]> storage_;
    T view_;
};

}  // namespace internal
}  // namespace RTT

#endif
