// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/ChannelElementBase.hpp>

#include <rtt/internal/flow/reclaimer.hpp>

namespace RTT::base {

using internal::Reclaimer;

ChannelElementBase::~ChannelElementBase() {
    // No thread can see this element any more, but others may see the neighbours through their own links.
    exchangeLink(input_, nullptr);
    exchangeLink(output_, nullptr);
}

thread_local const ChannelElementBase::SampleCall* ChannelElementBase::SampleCall::innermost_ = nullptr;

ChannelElementBase::SampleCall::SampleCall(const ChannelElementBase& element, bool reset)
    : element_(element), reset_(reset), outer_(innermost_) {
    innermost_ = this;
}

ChannelElementBase::SampleCall::~SampleCall() { innermost_ = outer_; }

const ChannelElementBase::SampleCall* ChannelElementBase::SampleCall::of(const ChannelElementBase& element) {
    return innermost_ && &innermost_->element_ == &element ? innermost_ : nullptr;
}

void ChannelElementBase::deref() {
    // Release, and acquire by the last reference: all use of the element happens before its destruction.
    if (references_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

void ChannelElementBase::exchangeLink(std::atomic<ChannelElementBase*>& link, ChannelElementBase* to) {
    if (to) to->ref();
    // Release: a thread that finds the new neighbour sees it complete. Acquire: another thread may have linked the old
    // one. A thread inside a Guard may still use the old neighbour, so its reference is released later.
    if (ChannelElementBase* old = link.exchange(to, std::memory_order_acq_rel))
        Reclaimer::retire(old, [](void* element) { static_cast<ChannelElementBase*>(element)->deref(); });
}

void ChannelElementBase::dropLink(std::atomic<ChannelElementBase*>& link, ChannelElementBase* expected) {
    if (link.compare_exchange_strong(expected, nullptr, std::memory_order_acq_rel) && expected)
        Reclaimer::retire(expected, [](void* element) { static_cast<ChannelElementBase*>(element)->deref(); });
}

ChannelElementBase::shared_ptr ChannelElementBase::getInput() const {
    const Reclaimer::Guard guard;
    return inputUnderGuard();
}

ChannelElementBase::shared_ptr ChannelElementBase::getOutput() const {
    const Reclaimer::Guard guard;
    return outputUnderGuard();
}

bool ChannelElementBase::connectTo(shared_ptr const& output, bool) {
    if (!output) return false;
    exchangeLink(output_, output.get());
    return output->connectFrom(this);
}

bool ChannelElementBase::connectFrom(shared_ptr const& input) {
    exchangeLink(input_, input.get());
    return true;
}

void ChannelElementBase::setOutput(shared_ptr const& output) {
    if (output)
        connectTo(output);
    else
        exchangeLink(output_, nullptr);
}

bool ChannelElementBase::inputReady(shared_ptr const&) { return inputReady(); }

bool ChannelElementBase::inputReady() {
    const shared_ptr input = getInput();
    return !input || input->inputReady(this);
}

bool ChannelElementBase::channelReady(shared_ptr const&, ConnPolicy const& policy, internal::ConnID* id) {
    const shared_ptr output = getOutput();
    return output && output->channelReady(this, policy, id);
}

void ChannelElementBase::clear() {
    if (const shared_ptr input = getInput()) input->clear();
}

bool ChannelElementBase::signal() {
    const Reclaimer::Guard guard;
    return signalUnderGuard();
}

void ChannelElementBase::disconnect(bool forward) {
    const shared_ptr next = forward ? getOutput() : getInput();
    const shared_ptr previous = forward ? getInput() : getOutput();
    // Links first: the neighbour may call back, and must then find nothing left to do.
    dropLink(output_, (forward ? next : previous).get());
    dropLink(input_, (forward ? previous : next).get());
    if (next) next->disconnect(this, forward);
}

bool ChannelElementBase::disconnect(shared_ptr const&, bool forward) {
    disconnect(forward);
    return true;
}

ChannelElementBase::shared_ptr ChannelElementBase::getInputEndPoint() {
    shared_ptr element = this;
    while (const shared_ptr input = element->getInput()) element = input;
    return element;
}

ChannelElementBase::shared_ptr ChannelElementBase::getOutputEndPoint() {
    shared_ptr element = this;
    while (const shared_ptr output = element->getOutput()) element = output;
    return element;
}

PortInterface* ChannelElementBase::getPort() const { return nullptr; }
const ConnPolicy* ChannelElementBase::getConnPolicy() const { return nullptr; }
bool ChannelElementBase::isRemoteElement() const { return false; }
std::string ChannelElementBase::getRemoteURI() const {
    const shared_ptr output = getOutput();
    return output ? output->getRemoteURI() : std::string();
}
std::string ChannelElementBase::getLocalURI() const { return std::string(); }
std::string ChannelElementBase::getElementName() const { return "ChannelElementBase"; }
internal::StorageCore* ChannelElementBase::storageCore() { return nullptr; }

WriteStatus ChannelElementBase::writeErased(const void* sample) {
    const Reclaimer::Guard guard;
    ChannelElementBase* output = outputUnderGuard();
    return output ? output->writeErased(sample) : NotConnected;
}

FlowStatus ChannelElementBase::readErased(void* sample, bool copyOld) {
    const Reclaimer::Guard guard;
    ChannelElementBase* input = inputUnderGuard();
    return input ? input->readErased(sample, copyOld) : NoData;
}

WriteStatus ChannelElementBase::sampleErased(const void* sample, bool reset) {
    const shared_ptr output = getOutput();
    return output ? output->sampleErased(sample, reset) : WriteSuccess;
}

bool ChannelElementBase::getSampleErased(void* sample) {
    const shared_ptr input = getInput();
    return input && input->getSampleErased(sample);
}

}  // namespace RTT::base
