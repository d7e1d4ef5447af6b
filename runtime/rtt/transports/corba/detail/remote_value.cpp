// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/remote_value.hpp>

#include <rtt/Logger.hpp>
#include <rtt/internal/values/value_place.hpp>
#include <rtt/transports/corba/detail/any_values.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeThunkTable.hpp>

#include <utility>

namespace RTT::corba::detail {

namespace {

typedef base::DataSourceBase::shared_ptr Source;

/** The local copy of the value. */
class RemotePlace final : public internal::ValuePlace {
public:
    RemotePlace(std::shared_ptr<const RemoteAccess> access, const Source& copy, bool isAssignable)
        : ValuePlace(copy.get()), access_(std::move(access)), isAssignable_(isAssignable) {}

    bool evaluate() const override { return access_->fetch(parent); }
    void* value() const override { return const_cast<void*>(parent->getRawConstPointer()); }
    void* get() const override {
        (void)evaluate();
        return value();
    }
    void* forChange() override { return get(); }
    void* raw() override { return isAssignable_ ? parent->getRawPointer() : nullptr; }
    void assign(const void* value) override {
        if (isAssignable_ && parent->assignValue(value)) updated();
    }
    void updated() override {
        if (isAssignable_ && !access_->store(parent))
            log(Error) << "component '" << access_->peer->name() << "' does not take the value of '" << access_->name
                       << "'" << endlog();
    }
    bool isAssignable() const override { return isAssignable_; }
    bool isFixed() const override { return false; }
    bool isPart() const override { return false; }
    ValuePlace* clone() const override { return new RemotePlace(access_, parent->clone(), isAssignable_); }
    ValuePlace* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>&) const override { return nullptr; }

private:
    const std::shared_ptr<const RemoteAccess> access_;
    const bool isAssignable_;
};

}  // namespace

bool RemoteAccess::fetch(const Source& into) const {
    const CService_var from = peer->isLost() ? CService_var() : service->getLimited();
    if (CORBA::is_nil(from)) return false;
    try {
        const CORBA::Any_var any =
            kind == Kind::Property ? from->getProperty(name.c_str()) : from->getAttribute(name.c_str());
        return assign(any, into);
    } catch (const CORBA::Exception& error) {
        peer->failed(error);
        return false;
    }
}

bool RemoteAccess::store(const Source& from) const {
    const CService_var to = peer->isLost() ? CService_var() : service->getLimited();
    if (CORBA::is_nil(to)) return false;
    try {
        const CORBA::Any_var any = newAny(from);
        return kind == Kind::Property ? to->setProperty(name.c_str(), any) : to->setAttribute(name.c_str(), any);
    } catch (const CORBA::Exception& error) {
        peer->failed(error);
        return false;
    }
}

Source newRemoteValue(const types::TypeInfo& type, RemoteAccess access, bool isAssignable) {
    const types::TypeThunks* const thunks = type.getThunks();
    const Source copy = thunks && thunks->placed && transporterOf(type) ? type.buildValue() : nullptr;
    if (!copy) return nullptr;
    return thunks->placed(new RemotePlace(std::make_shared<const RemoteAccess>(std::move(access)), copy, isAssignable));
}

}  // namespace RTT::corba::detail
