// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The part of a storage element that does not depend on the type of its samples.
#ifndef ORO_INTERNAL_STORAGE_CORE_HPP
#define ORO_INTERNAL_STORAGE_CORE_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/internal/flow/sample_store.hpp>

#include <atomic>
#include <memory>

namespace RTT {
namespace internal {
struct ChannelArray;

/** A storage, its policy and, with several readers (PerOutputPort and Shared), the list of readers to signal. */
class RTT_API StorageCore {
public:
    /** Completes the defaults of the policy. Has no store, with an error logged, if the policy is invalid. */
    StorageCore(const types::TypeOps& ops, const ConnPolicy& policy, const void* first);
    ~StorageCore();

    explicit operator bool() const { return store_ != nullptr; }
    SampleStore& store() const { return *store_; }
    const ConnPolicy& policy() const { return policy_; }
    bool hasManyReaders() const { return policy_.buffer_policy == PerOutputPort || policy_.buffer_policy == Shared; }

    void addReader(base::ChannelElementBase& reader);
    void removeReader(const base::ChannelElementBase* reader);
    bool signalReaders() const;
    /** Implements writeErased() of `element`, which owns this. */
    WriteStatus write(const void* sample, base::ChannelElementBase& element) {
        const WriteStatus status = store_->write(sample);
        if (__builtin_expect(status == WriteSuccess, 1))
            hasManyReaders() ? signalReaders() : element.signalUnderGuard();
        return status;
    }
    // The rare functions of the element that this belongs to.
    /** The new element; null, and the element deleted, if its storage could not be made. */
    static base::ChannelElementBase::shared_ptr heldIfReady(base::ChannelElementBase* made);
    static std::string elementName();
    static WriteStatus writeTyped(base::ChannelElementBase& element, const void* sample);
    bool connect(base::ChannelElementBase& element, base::ChannelElementBase::shared_ptr const& output, bool mandatory);

private:
    std::unique_ptr<SampleStore> store_;
    ConnPolicy policy_;
    std::atomic<const ChannelArray*> readers_{nullptr};  // changed with readersMutex() held
};

}  // namespace internal
}  // namespace RTT

#endif
