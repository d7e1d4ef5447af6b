// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"

#include <rtt/ConnPolicy.hpp>
#include <rtt/types/GeneratedTypekit.hpp>
#include <rtt/types/Types.hpp>

namespace RTT::types::builtin {

namespace {
constexpr Enumerator bufferPolicy[] = {
    {"UnspecifiedBufferPolicy", UnspecifiedBufferPolicy, ""},
    {"PerConnection", PerConnection, ""},
    {"PerInputPort", PerInputPort, ""},
    {"PerOutputPort", PerOutputPort, ""},
    {"Shared", Shared, ""},
};

constexpr Member connPolicy[] = {
    {"type", offsetof(ConnPolicy, type), &typeRef<int>, 0, "DATA, BUFFER or CIRCULAR_BUFFER", ""},
    {"size", offsetof(ConnPolicy, size), &typeRef<int>, 0, "samples a buffer holds", ""},
    {"lock_policy", offsetof(ConnPolicy, lock_policy), &typeRef<int>, 0, "UNSYNC, LOCKED or LOCK_FREE", ""},
    {"init", offsetof(ConnPolicy, init), &typeRef<bool>, 0, "start with the last written value", ""},
    {"pull", offsetof(ConnPolicy, pull), &typeRef<bool>, 0, "storage at the writer's side", ""},
    {"buffer_policy", offsetof(ConnPolicy, buffer_policy), &typeRef<int>, 0, "a BufferPolicy", ""},
    {"mandatory", offsetof(ConnPolicy, mandatory), &typeRef<bool>, 0, "its failure is one of the write", ""},
    {"transport", offsetof(ConnPolicy, transport), &typeRef<int>, 0, "0: local", ""},
    {"data_size", offsetof(ConnPolicy, data_size), &typeRef<int>, 0, "hint for transports", "byte"},
    {"name_id", offsetof(ConnPolicy, name_id), &typeRef<std::string>, 0, "name of a stream", ""},
};
}  // namespace

void addPolicies() {
    Types()->addType(
        makeEnumType<BufferPolicy>("BufferPolicy", bufferPolicy, sizeof bufferPolicy / sizeof bufferPolicy[0]));
    Types()->addType(makeStructType<ConnPolicy>("ConnPolicy", connPolicy, sizeof connPolicy / sizeof connPolicy[0],
                                                "how two ports are joined"));
}

}  // namespace RTT::types::builtin
