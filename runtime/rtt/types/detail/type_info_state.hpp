// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_INFO_STATE_HPP
#define ORO_TYPE_INFO_STATE_HPP

#include <rtt/types/TypeConstructor.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeTransporter.hpp>
#include <array>
#include <atomic>
#include <map>
#include <mutex>

namespace RTT {
namespace types {

namespace detail {
/** Marks constructors that are tried after all others, even those added later. */
class AskedLast {
public:
    virtual ~AskedLast() = default;
};
}  // namespace detail

/** Everything in a TypeInfo. The mutex guards what is not atomic or constant; no user code runs while it is held. */
struct TypeInfo::State {
    explicit State(std::string n, TypeId i) : name(std::move(n)), id(i) {}

    const std::string name;
    std::atomic<TypeId> id;
    std::atomic<const TypeOps*> ops{nullptr};
    std::atomic<const TypeThunks*> thunks{nullptr};
    std::atomic<const char*> arrayElement{""};

    mutable std::mutex mutex;
    std::vector<std::string> aliases;
    std::string description;
    std::vector<std::shared_ptr<TypeConstructor>> constructors;
    std::map<int, std::unique_ptr<TypeTransporter>> transporters;
    std::vector<std::unique_ptr<TypeTransporter>> replaced;  // others may be using them
    /** Those of the small numbers once more, for readers that take no lock. */
    std::array<std::atomic<TypeTransporter*>, 4> quick{};
    ValueFactoryPtr values;
    MemberFactoryPtr members;
    CompositionFactoryPtr compositions;
    StreamFactoryPtr streams;
    ConnFactoryPtr ports;

    template <class F>
    auto locked(F read) const {
        std::lock_guard<std::mutex> lock(mutex);
        return read();
    }
    /** May load a plugin. Takes no lock if the protocol is a small number and there is one. */
    TypeTransporter* transporter(int protocol) const;
    /** Only while the mutex is held. */
    void keepQuick(int protocol, TypeTransporter* transporter) {
        if (isQuick(protocol)) quick[static_cast<std::size_t>(protocol)].store(transporter, std::memory_order_release);
    }
    bool isQuick(int protocol) const { return protocol >= 0 && static_cast<std::size_t>(protocol) < quick.size(); }
    std::vector<std::shared_ptr<TypeConstructor>> currentConstructors() const {
        return locked([this] { return constructors; });
    }
};

}  // namespace types
}  // namespace RTT

#endif
