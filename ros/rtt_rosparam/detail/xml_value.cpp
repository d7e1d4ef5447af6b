// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "xml_value.hpp"

#include <cmath>
#include <sstream>

namespace rtt_rosparam {

std::string described(const XmlRpc::XmlRpcValue& value) {
    typedef XmlRpc::XmlRpcValue Value;
    constexpr std::size_t kMost = 40;
    std::ostringstream text;
    switch (value.getType()) {
        case Value::TypeBoolean: text << "a bool (" << (as<bool>(value) ? "true" : "false") << ')'; break;
        case Value::TypeInt: text << "an int (" << as<int>(value) << ')'; break;
        case Value::TypeDouble: text << "a double (" << as<double>(value) << ')'; break;
        case Value::TypeString: {
            const auto& letters = as<std::string>(value);
            text << "a string ('" << letters.substr(0, kMost) << (letters.size() > kMost ? "…')" : "')");
            break;
        }
        case Value::TypeDateTime: text << "a date"; break;
        case Value::TypeBase64: text << "binary data"; break;
        case Value::TypeArray: text << "an array of " << value.size() << " elements"; break;
        case Value::TypeStruct: text << "a struct"; break;
        case Value::TypeInvalid: text << "nothing"; break;
    }
    return text.str();
}

bool same(const XmlRpc::XmlRpcValue& one, const XmlRpc::XmlRpcValue& other) {
    typedef XmlRpc::XmlRpcValue Value;
    if (one.getType() != other.getType()) return false;
    switch (one.getType()) {
        case Value::TypeDouble: {
            const double a = as<double>(one), b = as<double>(other);
            return a == b || (std::isnan(a) && std::isnan(b));
        }
        case Value::TypeArray:
            if (one.size() != other.size()) return false;
            for (int i = 0; i != one.size(); ++i)
                if (!same(one[i], other[i])) return false;
            return true;
        case Value::TypeStruct:
            if (one.size() != other.size()) return false;
            for (const auto& [name, member] : one)
                if (!other.hasMember(name) || !same(member, other[name])) return false;
            return true;
        case Value::TypeInvalid: return true;
        default: return one == other;
    }
}

}  // namespace rtt_rosparam
