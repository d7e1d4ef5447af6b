// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DATA_SOURCE_PROXY_HPP
#define ORO_CORBA_DATA_SOURCE_PROXY_HPP

#include <rtt/internal/DataSources.hpp>
#include <rtt/transports/corba/ServiceC.h>

#include <exception>
#include <string>

namespace RTT {
namespace types {
class TypeInfo;
}
namespace corba {

/** Another process has no such property or attribute of that type. */
struct RTT_API NonExistingDataSource : public std::exception {
    const char* what() const noexcept override;
};

/** A source whose value is that property or attribute of the other process. Throws NonExistingDataSource. Calls the
    other process and blocks. */
RTT_API base::DataSourceBase::shared_ptr newProxyOfValue(CService_ptr service, const std::string& name, bool isProperty,
                                                         const types::TypeInfo& type);

namespace detail {

/** What both kinds have in common. Base: internal::DataSource or internal::AssignableDataSource. */
template <class T, template <class> class Base>
class ProxyOfValue : public Base<T> {
public:
    bool evaluate() const override { return remote_->evaluate(); }
    T get() const override { return remote_->get(); }
    T value() const override { return remote_->value(); }
    typename internal::DataSource<T>::const_reference_t rvalue() const override { return remote_->rvalue(); }

protected:
    typedef typename Base<T>::shared_ptr Remote;
    explicit ProxyOfValue(Remote remote) : remote_(remote) {}
    ProxyOfValue(CService_ptr service, const std::string& name, bool isProperty)
        : remote_(Base<T>::narrow(
              newProxyOfValue(service, name, isProperty, *internal::DataSource<T>::GetTypeInfo()).get())) {
        if (!remote_) throw NonExistingDataSource();
    }
    const Remote remote_;
};

}  // namespace detail

/**
 * A property or an attribute of another process. Every reading fetches the value: it calls the other process and
 * blocks. If that does not answer, evaluate() is false, the value is the last one, and an error is logged. One thread
 * may use it at a time.
 */
template <class T>
class DataSourceProxy : public detail::ProxyOfValue<T, internal::DataSource> {
    typedef detail::ProxyOfValue<T, internal::DataSource> Shared;

public:
    typedef boost::intrusive_ptr<DataSourceProxy<T>> shared_ptr;

    /** Throws NonExistingDataSource. */
    DataSourceProxy(CService_ptr service, std::string name, bool isProperty) : Shared(service, name, isProperty) {}
    DataSourceProxy<T>* clone() const override { return new DataSourceProxy<T>(this->remote_); }
    DataSourceProxy<T>* copy(internal::CopyMap&) const override { return const_cast<DataSourceProxy<T>*>(this); }

private:
    explicit DataSourceProxy(typename Shared::Remote remote) : Shared(remote) {}
};

/** The same, whose changes are stored in the other process. If that does not take one, an error is logged. */
template <class T>
class ValueDataSourceProxy : public detail::ProxyOfValue<T, internal::AssignableDataSource> {
    typedef detail::ProxyOfValue<T, internal::AssignableDataSource> Shared;

public:
    typedef boost::intrusive_ptr<ValueDataSourceProxy<T>> shared_ptr;

    /** Throws NonExistingDataSource. */
    ValueDataSourceProxy(CService_ptr service, std::string name, bool isProperty) : Shared(service, name, isProperty) {}
    void set(typename internal::AssignableDataSource<T>::param_t value) override { this->remote_->set(value); }
    /** Fetches the value; updated() stores it. */
    typename internal::AssignableDataSource<T>::reference_t set() override { return this->remote_->set(); }
    void updated() override { this->remote_->updated(); }
    ValueDataSourceProxy<T>* clone() const override { return new ValueDataSourceProxy<T>(this->remote_); }
    ValueDataSourceProxy<T>* copy(internal::CopyMap&) const override {
        return const_cast<ValueDataSourceProxy<T>*>(this);
    }

private:
    explicit ValueDataSourceProxy(typename Shared::Remote remote) : Shared(remote) {}
};

}  // namespace corba
}  // namespace RTT

#endif
