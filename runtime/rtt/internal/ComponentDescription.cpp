// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/ComponentDescription.hpp>

#include <dlfcn.h>

#include <mutex>

namespace RTT::internal {
namespace {

std::mutex& mutex() {
    static std::mutex mutex;
    return mutex;
}

/** All tables, the newest first. */
ComponentDescriptions* newest = nullptr;

/** Takes the linker's lock. A thread that opens a library holds it and wants ours: never call this with ours held. */
const void* libraryWith(const void* address) {
    Dl_info info;
    return dladdr(address, &info) ? info.dli_fbase : nullptr;
}

}  // namespace

ComponentDescriptions::ComponentDescriptions(DescribedList<ComponentDescription> table)
    : table_(table), library_(libraryWith(table.first)) {
    const std::lock_guard<std::mutex> lock(mutex());
    next_ = newest;
    newest = this;
}

ComponentDescriptions::~ComponentDescriptions() {
    const std::lock_guard<std::mutex> lock(mutex());
    ComponentDescriptions** link = &newest;
    while (*link != this) link = &(*link)->next_;
    *link = next_;
}

const ComponentDescription* ComponentDescriptions::find(const std::string& type, const void* code) {
    const void* const library = libraryWith(code);
    const std::lock_guard<std::mutex> lock(mutex());
    for (const ComponentDescriptions* one = newest; one; one = one->next_)
        for (const ComponentDescription& description : one->table_)
            if (one->library_ == library && type == description.type) return &description;
    return nullptr;
}

}  // namespace RTT::internal
