// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/FlowStatus.hpp>

#include <istream>
#include <ostream>
#include <string>

namespace RTT {

std::ostream& operator<<(std::ostream& os, FlowStatus status) {
    switch (status) {
        case NoData: return os << "NoData";
        case OldData: return os << "OldData";
        case NewData: return os << "NewData";
    }
    return os << "(unknown flow status)";
}

std::ostream& operator<<(std::ostream& os, WriteStatus status) {
    switch (status) {
        case WriteSuccess: return os << "WriteSuccess";
        case WriteFailure: return os << "WriteFailure";
        case NotConnected: return os << "NotConnected";
    }
    return os << "(unknown write status)";
}

std::istream& operator>>(std::istream& is, FlowStatus& status) {
    std::string word;
    is >> word;
    status = word == "NewData" ? NewData : word == "OldData" ? OldData : NoData;
    return is;
}

std::istream& operator>>(std::istream& is, WriteStatus& status) {
    std::string word;
    is >> word;
    status = word == "NotConnected" ? NotConnected : word == "WriteFailure" ? WriteFailure : WriteSuccess;
    return is;
}

}  // namespace RTT
