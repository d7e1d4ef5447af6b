// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/lone_service.hpp>

#include <algorithm>
#include <mutex>
#include <vector>

namespace RTT::corba::detail {

namespace {

struct LoneServices {
    std::mutex mutex;
    std::vector<std::weak_ptr<LoneService>> all;
};

LoneServices& loneServices() {
    static auto* const services = new LoneServices();  // never destroyed: threads of the ORB use it
    return *services;
}

std::shared_ptr<RemoteReference> referenceTo(CService_ptr service) {
    const auto made = std::make_shared<RemoteReference>();
    made->set(service);
    return made;
}

}  // namespace

std::shared_ptr<LoneService> LoneService::of(CService_ptr service, const std::string& name) {
    std::vector<std::shared_ptr<LoneService>> used;  // given up without the lock: this may be their last user
    const std::lock_guard<std::mutex> lock(loneServices().mutex);
    std::vector<std::weak_ptr<LoneService>>& all = loneServices().all;
    all.erase(std::remove_if(all.begin(), all.end(), [](const auto& one) { return one.expired(); }), all.end());
    for (const auto& one : all) {
        used.push_back(one.lock());
        if (used.back() && used.back()->reference_->get()->_is_equivalent(service)) return used.back();
    }
    const auto made = std::make_shared<LoneService>(service, name);
    all.push_back(made);
    return made;
}

LoneService::LoneService(CService_ptr service, const std::string& name)
    : RemotePeer(name), reference_(referenceTo(service)), ofProxy_(proxied(service)), watch_([this] { check(); }) {}

void LoneService::check() {
    if (CORBA::is_nil(ApplicationServer::orb)) return;
    lookForProxy();
    if (answers() || isFoundAgain()) found();
}

bool LoneService::answers() {
    const CService_var service = reference_->getLimited();
    if (CORBA::is_nil(service)) return false;
    try {
        const CORBA::String_var name = service->getName();
        return true;
    } catch (const CORBA::Exception& error) {
        failed(error);
        return false;
    }
}

void LoneService::lookForProxy() {
    if (ofProxy_.expired()) ofProxy_ = proxied(CService_var(reference_->get()));
}

bool LoneService::isFoundAgain() {
    const std::shared_ptr<RemoteReference> known = ofProxy_.lock();
    const CService_var now = known ? known->get() : CService_var();
    const CService_var before = reference_->get();
    if (CORBA::is_nil(now) || now->_is_equivalent(before)) return false;
    reference_->set(now);
    return answers();
}

}  // namespace RTT::corba::detail
