// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORELIB_ATTRIBUTE_HPP
#define ORO_CORELIB_ATTRIBUTE_HPP

#include <rtt/base/AttributeBase.hpp>
#include <rtt/internal/DataSources.hpp>

namespace RTT {

/**
 * A named variable of type T: shown to scripts and tools, not saved to property files.
 * get() and set() are real-time safe if copying T is. Not thread safe.
 */
template <typename T>
class Attribute : public base::AttributeBase {
public:
    typedef internal::AssignableDataSource<T> DataSourceType;
    typedef typename DataSourceType::param_t param_t;
    typedef typename DataSourceType::reference_t reference_t;

    /** Not ready. */
    Attribute() {}
    [[gnu::cold]] explicit Attribute(const std::string& name)
        : AttributeBase(name), data(internal::ValueDataSource<T>::make()) {}
    [[gnu::cold]] Attribute(const std::string& name, T value)
        : AttributeBase(name), data(internal::ValueDataSource<T>::make(value)) {}
    template <class P, class = internal::IfSource<P, internal::AssignableDataSource<T>>>
    [[gnu::cold]] Attribute(const std::string& name, const P& source) : AttributeBase(name), data(source) {}
    /** Shares the data of `other`; not ready if its type is not T. */
    [[gnu::cold]] Attribute(base::AttributeBase* other)
        : AttributeBase(nameOf(other)), data(other ? DataSourceType::narrow(other->getDataSource().get()) : nullptr) {}

    [[gnu::cold]] Attribute& operator=(base::AttributeBase* other) { return *this = Attribute(other); }

    T get() const { return data->get(); }
    typename DataSourceType::const_reference_t rvalue() const { return data->rvalue(); }
    void set(param_t value) {
        data->set(value);
        data->updated();
    }
    reference_t set() { return data->set(); }

    base::DataSourceBase::shared_ptr getDataSource() const override { return data; }
    typename DataSourceType::shared_ptr getAssignableDataSource() const { return data; }
    void setDataSource(typename DataSourceType::shared_ptr source) { data = source; }

    [[gnu::cold]] Attribute<T>* clone() const override { return new Attribute<T>(mname, data.get()); }
    [[gnu::cold]] Attribute<T>* copy(internal::CopyMap& replacements, bool instantiate) const override {
        if (!instantiate) return new Attribute<T>(mname, data->copy(replacements));
        auto* made = new Attribute<T>(mname, data->clone());
        data->noteCopy(replacements, made->data.get());
        return made;
    }

    static Attribute<T>* narrow(base::AttributeBase* from) { return dynamic_cast<Attribute<T>*>(from); }

protected:
    typename DataSourceType::shared_ptr data;
};

/** A named value of type T that cannot be changed through its name. */
template <typename T>
class Constant : public base::AttributeBase {
public:
    /** Not ready. */
    Constant() {}
    [[gnu::cold]] Constant(const std::string& name, T value)
        : AttributeBase(name), data(new internal::ConstantDataSource<T>(std::move(value))) {}
    template <class P, class = internal::IfSource<P, internal::DataSource<T>>>
    [[gnu::cold]] Constant(const std::string& name, const P& source) : AttributeBase(name), data(source) {}
    /** Shares the data of `other`; not ready if its type is not T. */
    [[gnu::cold]] Constant(base::AttributeBase* other)
        : AttributeBase(nameOf(other)),
          data(other ? internal::DataSource<T>::narrow(other->getDataSource().get()) : nullptr) {}

    [[gnu::cold]] Constant& operator=(base::AttributeBase* other) { return *this = Constant(other); }

    T get() const { return data->get(); }
    typename internal::DataSource<T>::const_reference_t rvalue() const { return data->rvalue(); }

    base::DataSourceBase::shared_ptr getDataSource() const override { return data; }
    [[gnu::cold]] Constant<T>* clone() const override { return new Constant<T>(mname, data.get()); }
    [[gnu::cold]] Constant<T>* copy(internal::CopyMap&, bool) const override { return clone(); }

protected:
    typename internal::DataSource<T>::shared_ptr data;
};

/** A name for any data source. */
class RTT_API Alias : public base::AttributeBase {
public:
    Alias(const std::string& name, base::DataSourceBase::shared_ptr source);
    base::DataSourceBase::shared_ptr getDataSource() const override;
    Alias* clone() const override;
    Alias* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& replacements,
                bool instantiate) const override;

private:
    base::DataSourceBase::shared_ptr data;
};

}  // namespace RTT

#endif
