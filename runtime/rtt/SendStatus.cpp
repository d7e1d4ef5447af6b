// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/SendStatus.hpp>

#include <istream>
#include <ostream>
#include <string>

namespace RTT {

std::ostream& operator<<(std::ostream& os, SendStatus status) {
    switch (status) {
        case CollectFailure: return os << "CollectFailure";
        case SendFailure: return os << "SendFailure";
        case SendNotReady: return os << "SendNotReady";
        case SendSuccess: return os << "SendSuccess";
    }
    return os << "(unknown send status)";
}

std::istream& operator>>(std::istream& is, SendStatus& status) {
    std::string name;
    is >> name;
    status = SendFailure;
    for (SendStatus known : {CollectFailure, SendNotReady, SendSuccess}) {
        if ((known == CollectFailure && name == "CollectFailure") ||
            (known == SendNotReady && name == "SendNotReady") || (known == SendSuccess && name == "SendSuccess"))
            status = known;
    }
    return is;
}

}  // namespace RTT
