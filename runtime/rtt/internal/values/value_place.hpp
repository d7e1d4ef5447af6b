// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Finds values that another source holds; implemented once for all types.
#ifndef ORO_VALUE_PLACE_HPP
#define ORO_VALUE_PLACE_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/types/SequenceOps.hpp>
#include <rtt/types/TypeOps.hpp>
#include <cstddef>
#include <memory>

namespace RTT {
namespace base {
class ActionInterface;
}
namespace internal {

/** Finds a value inside that of another source, keeps that source alive and reports changes to it. */
class RTT_API ValuePlace {
public:
    explicit ValuePlace(base::DataSourceBase* parent);
    virtual ~ValuePlace();
    ValuePlace(const ValuePlace&) = delete;
    ValuePlace& operator=(const ValuePlace&) = delete;

    virtual bool evaluate() const = 0;
    /** The value of the last evaluation; never null. */
    virtual void* value() const = 0;
    /** The same, but evaluates first, except in a PartPlace. */
    virtual void* get() const = 0;
    /** The value, to be changed in place; updated() follows. */
    virtual void* forChange() = 0;
    /** Null if the value can never be changed through this place. */
    virtual void* raw() { return forChange(); }
    virtual void assign(const void* value) = 0;
    virtual void updated() = 0;
    virtual bool isAssignable() const = 0;
    virtual void reset() {}
    /** True if value() never changes its result. */
    virtual bool isFixed() const = 0;
    /** False if this is the whole value of the parent. */
    virtual bool isPart() const { return true; }
    /** The caller owns the result of clone() and copy(). */
    virtual ValuePlace* clone() const = 0;
    /** Null if a copied expression shares this place. */
    virtual ValuePlace* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const = 0;

    const base::DataSourceBase::shared_ptr parent;
};

class RTT_API PartOffset {
public:
    PartOffset(void* at, base::DataSourceBase& parent);

    /** Computed anew if the parent's value may move, as an element of a container does. */
    void* addressIn(base::DataSourceBase& parent) const { return parent.hasFixedAddress() ? at_ : movedIn(parent); }
    /** The address of this part in a copy of the parent. */
    void* movedIn(base::DataSourceBase& copyOfParent) const;

private:
    void* at_;
    std::ptrdiff_t offset_;
};

/** A part stored in the parent's value: a member of a struct, at any depth. */
class RTT_API PartPlace final : public ValuePlace {
public:
    PartPlace(void* at, base::DataSourceBase* parent, const types::TypeOps& ops);

    bool evaluate() const override;
    void* value() const override;
    void* get() const override;
    void* forChange() override;
    void assign(const void* value) override;
    void updated() override;
    bool isAssignable() const override;
    bool isFixed() const override;
    ValuePlace* clone() const override;
    ValuePlace* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const override;

private:
    const PartOffset offset_;
    const types::TypeOps& ops_;
};

/**
 * An element of a container, found anew at each access, so that index and container may change. Reading beyond the end
 * gives a default value; writing there, or to elements that cannot be changed, has no effect.
 */
class RTT_API ElementPlace final : public ValuePlace {
public:
    /** `index` is of type int or unsigned int, `spare` is a new variable of the element's type; `reset` restores its
        first value. */
    ElementPlace(base::DataSourceBase* parent, base::DataSourceBase* index, const types::SequenceOps* ops,
                 base::DataSourceBase* spare, void (*reset)(void*));

    bool evaluate() const override;
    void* value() const override;
    void* get() const override;
    void* forChange() override;
    void assign(const void* value) override;
    void updated() override;
    bool isAssignable() const override;
    bool isFixed() const override;
    ValuePlace* clone() const override;
    ValuePlace* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const override;

private:
    std::size_t position() const;
    /** These two return false if the index is beyond the end. */
    bool load(void* element) const;
    bool store(const void* element) const;
    /** The element, or a copy of one that has no address. */
    void* element(bool forWriting) const;

    const base::DataSourceBase::shared_ptr index_;
    const types::SequenceOps* const ops_;
    const base::DataSourceBase::shared_ptr spare_;
    void* const spareAt_;
    void (*const reset_)(void*);
};

/** The whole value of the parent, read-only. An action computes it before each reading. */
class RTT_API ActionPlace final : public ValuePlace {
public:
    /** Takes ownership of the action. */
    ActionPlace(base::ActionInterface* action, base::DataSourceBase* parent);
    ~ActionPlace() override;

    bool evaluate() const override;
    void* value() const override;
    void* get() const override;
    void* forChange() override;
    void* raw() override;
    void assign(const void* value) override;
    void updated() override;
    bool isAssignable() const override;
    void reset() override;
    bool isFixed() const override;
    bool isPart() const override;
    ValuePlace* clone() const override;
    ValuePlace* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const override;

private:
    const std::unique_ptr<base::ActionInterface> action_;
};

}  // namespace internal
}  // namespace RTT

#endif
