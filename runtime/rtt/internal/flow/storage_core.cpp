// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/storage_core.hpp>

#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/flow/channel_array.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

#include <mutex>
#include <vector>

namespace RTT::internal {

namespace {
// One for all storages: readers come and go rarely, and only storages with several readers have a list.
std::mutex& readersMutex() {
    static std::mutex mutex;
    return mutex;
}
}  // namespace

StorageCore::StorageCore(const types::TypeOps& ops, const ConnPolicy& policy, const void* first) : policy_(policy) {
    store_ = ConnFactory::makeStore(ops, policy_, first);
}

StorageCore::~StorageCore() { ChannelArray::retire(readers_.load(std::memory_order_relaxed)); }

base::ChannelElementBase::shared_ptr StorageCore::heldIfReady(base::ChannelElementBase* made) {
    base::ChannelElementBase::shared_ptr held(made);
    if (!*made->storageCore()) held.reset();
    return held;
}

std::string StorageCore::elementName() { return "ChannelStorage"; }

void StorageCore::addReader(base::ChannelElementBase& reader) {
    const ChannelArray* old;
    {
        const std::lock_guard<std::mutex> lock(readersMutex());
        old = readers_.load(std::memory_order_relaxed);
        std::vector<ChannelArray::Entry> entries;
        if (old) entries.assign(old->begin(), old->end());
        for (const ChannelArray::Entry& entry : entries)
            if (entry.channel == &reader) return;
        entries.push_back({&reader, true});
        // Release: a thread that finds the list, by the acquire load in signalReaders(), sees its content.
        readers_.store(ChannelArray::make(entries.data(), entries.size()), std::memory_order_release);
    }
    ChannelArray::retire(old);
}

void StorageCore::removeReader(const base::ChannelElementBase* reader) {
    const ChannelArray* old;
    {
        const std::lock_guard<std::mutex> lock(readersMutex());
        old = readers_.load(std::memory_order_relaxed);
        if (!old) return;
        std::vector<ChannelArray::Entry> entries;
        for (const ChannelArray::Entry& entry : *old)
            if (entry.channel != reader) entries.push_back(entry);
        if (entries.size() == old->size) return;
        readers_.store(ChannelArray::make(entries.data(), entries.size()), std::memory_order_release);
    }
    ChannelArray::retire(old);
}

bool StorageCore::signalReaders() const {
    const Reclaimer::Guard guard;
    const ChannelArray* readers = readers_.load(std::memory_order_acquire);
    if (!readers) return false;
    for (const ChannelArray::Entry& entry : *readers) entry.channel->signal();
    return true;
}

WriteStatus StorageCore::writeTyped(base::ChannelElementBase& element, const void* sample) {
    const Reclaimer::Guard guard;
    return element.writeErased(sample);
}

bool StorageCore::connect(base::ChannelElementBase& element, base::ChannelElementBase::shared_ptr const& output,
                          bool mandatory) {
    if (!hasManyReaders()) return element.ChannelElementBase::connectTo(output, mandatory);
    addReader(*output);
    return output->connectFrom(&element);
}

}  // namespace RTT::internal
