// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where values are that another source holds: written once for all types.
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

/** Finds a value inside that of another source, which is kept alive and told of changes. */
class RTT_API ValuePlace {
public:
    explicit ValuePlace(base::DataSourceBase* parent);
    virtual ~ValuePlace();
    ValuePlace(const ValuePlace&) = delete;
    ValuePlace& operator=(const ValuePlace&) = delete;

    virtual bool evaluate() const = 0;
    /** The value, never null, as it was evaluated last. */
    virtual void* value() const = 0;
    /** The same, evaluated first where that has no effect but finding the value. */
    virtual void* get() const = 0;
    /** The value for direct change; updated() follows. */
    virtual void* forChange() = 0;
    /** Null if the value can never be changed through this place. */
    virtual void* raw() { return forChange(); }
    virtual void assign(const void* value) = 0;
    virtual void updated() = 0;
    virtual bool isAssignable() const = 0;
    virtual void reset() {}
    /** True if value() is the same as long as this exists. */
    virtual bool isFixed() const = 0;
    /** False if this is all of the parent's value. */
    virtual bool isPart() const { return true; }
    /** The caller owns what these two return. */
    virtual ValuePlace* clone() const = 0;
    /** Null if a copied expression uses this place, too. */
    virtual ValuePlace* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const = 0;

    const base::DataSourceBase::shared_ptr parent;
};

/** The distance between a part and the beginning of its parent's value. */
class RTT_API PartOffset {
public:
    PartOffset(void* at, base::DataSourceBase& parent);

    /** Found anew if the parent's value may move, because it is an element of a container. */
    void* addressIn(base::DataSourceBase& parent) const { return parent.hasFixedAddress() ? at_ : movedIn(parent); }
    /** The place of this part in a copy of the parent. */
    void* movedIn(base::DataSourceBase& copyOfParent) const;

private:
    void* at_;
    std::ptrdiff_t offset_;
};

/** A part that is stored in the parent's value: a member of a struct, at any depth. */
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
 * An element of a container, found anew at each access, so that index and container may change.
 * Beyond the end a default value is read, and what is written is lost, as it is where elements cannot be changed.
 */
class RTT_API ElementPlace final : public ValuePlace {
public:
    /** `index` is of type int or unsigned int, `spare` a new variable of the element's type, which `reset` gives its first
        value again. */
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
    /** False, too, if the index is beyond the end. */
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

/** All of the parent's value, which an action computes each time before it is read. It cannot be changed. */
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
